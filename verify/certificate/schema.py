"""Reading fields strictly: every field wanted is there, no other field is.

Each function takes plain data and a ``place`` (where in the certificate it stands, for messages),
returns the value with its type known, and raises MalformedError otherwise.
"""

from __future__ import annotations

import re
from fractions import Fraction

from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import (
    MAXIMUM_NUMBER_TEXT,
    GivenUpError,
    MalformedError,
    RejectedError,
)

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}\Z")
_NUMBER = re.compile(r"(-?)(0|[1-9][0-9]*)(?:/([1-9][0-9]*))?\Z")
_INDEX = re.compile(r"(?:0|[1-9][0-9]{0,5})\Z")


def record(value: Plain, fields: tuple[str, ...], place: str) -> dict[str, Plain]:
    """A record with exactly these fields."""
    entries = table(value, place)
    for field in fields:
        if field not in entries:
            raise MalformedError(f"{place}: the field {field!r} is missing")
    for field in entries:
        if field not in fields:
            raise MalformedError(f"{place}: the field {field!r} is not known here")
    return entries


def table(value: Plain, place: str) -> dict[str, Plain]:
    """A record whose keys are for the caller to judge."""
    if not isinstance(value, dict):
        raise MalformedError(f"{place}: a record is wanted, {type(value).__name__} found")
    return value


def items(value: Plain, place: str) -> list[Plain]:
    """A list."""
    if not isinstance(value, list):
        raise MalformedError(f"{place}: a list is wanted, {type(value).__name__} found")
    return value


def text(value: Plain, place: str) -> str:
    """Printable text (no control characters) that is not blank."""
    if not isinstance(value, str) or not value.strip() or not value.isprintable():
        raise MalformedError(f"{place}: printable text is wanted")
    return value


def name(value: Plain, place: str) -> str:
    """A name: a letter, then letters, digits and underscores, at most 64 in all."""
    if not isinstance(value, str) or not _NAME.match(value):
        raise MalformedError(f"{place}: a name is wanted (letters, digits, underscores)")
    return value


def integer(value: Plain, lowest: int, highest: int, place: str) -> int:
    """An integer within bounds, both included."""
    if type(value) is not int:
        raise MalformedError(f"{place}: an integer is wanted, {type(value).__name__} found")
    if not lowest <= value <= highest:
        raise MalformedError(f"{place}: an integer from {lowest} to {highest} is wanted")
    return value


def index(value: str, place: str) -> int:
    """An integer written as a key, in its one canonical spelling."""
    if not _INDEX.match(value):
        raise MalformedError(f"{place}: {value!r} is not a node number")
    return int(value)


def number(value: Plain, place: str) -> Fraction:
    """A rational number in its one canonical spelling: '3', '-1/2'; lowest terms, no sign on 0."""
    if not isinstance(value, str):
        raise MalformedError(f"{place}: a number as text is wanted, such as '-3/4'")
    if len(value) > MAXIMUM_NUMBER_TEXT:
        raise GivenUpError(
            f"{place}: given up: a number of {len(value)} characters, at most {MAXIMUM_NUMBER_TEXT}"
        )
    match = _NUMBER.match(value)
    if match is None:
        raise MalformedError(f"{place}: {value[:40]!r} is not a number such as '-3/4'")
    result = Fraction(int(match.group(1) + match.group(2)), int(match.group(3) or "1"))
    if str(result) != value:
        raise MalformedError(f"{place}: {value[:40]!r} is not in lowest terms")
    return result


def unused(names: set[str], what: str, place: str) -> None:
    """Reject what nothing depends on: changing it could not be noticed."""
    if names:
        raise RejectedError(f"{place}: {what} {', '.join(sorted(names))} not used by anything")
