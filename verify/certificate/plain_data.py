"""Plain data: dictionaries with text keys, lists, text and integers, and nothing else.

Certificates come from JSON files or straight from their writer. Both are copied into plain data
first, so that nothing that merely looks like a number (True, 1.0) or changes while it is read
reaches the checker, and so that size and depth are known to be bounded.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from gainproof.verify.certificate.rejection import (
    MAXIMUM_DEPTH,
    MAXIMUM_PLAIN_VALUES,
    MAXIMUM_TEXT,
    GivenUpError,
    MalformedError,
)

Plain: TypeAlias = "dict[str, Plain] | list[Plain] | str | int"

# No honest integer in a certificate (exponent, power, weight, node number) comes near this.
_LARGEST_INTEGER = 10**6


def plain(value: object) -> Plain:
    """A deep copy of ``value`` made of dict, list, str and int only (tuples become lists).

    Raises MalformedError for any other type (booleans, floats, None, subclasses of text or int),
    for keys that are not text, and beyond the limits of size, depth and length.
    """
    return _copy(value, MAXIMUM_DEPTH, [MAXIMUM_PLAIN_VALUES])


def _copy(value: object, depth: int, remaining: list[int]) -> Plain:
    remaining[0] -= 1 + (len(value) // 64 if isinstance(value, str) else 0)
    if depth < 0:
        raise MalformedError(f"data nested deeper than {MAXIMUM_DEPTH} levels")
    if remaining[0] < 0:
        raise MalformedError(f"more than {MAXIMUM_PLAIN_VALUES} values")
    if type(value) is str:
        return _text(value)
    if type(value) is int:
        if abs(value) > _LARGEST_INTEGER:
            raise MalformedError(f"an integer beyond {_LARGEST_INTEGER}")
        return value
    if isinstance(value, list | tuple):
        return [_copy(item, depth - 1, remaining) for item in value]
    if isinstance(value, Mapping):
        copied: dict[str, Plain] = {}
        for key, item in value.items():
            if type(key) is not str:
                raise MalformedError(f"a key of type {type(key).__name__} where text is wanted")
            copied[_text(key)] = _copy(item, depth - 1, remaining)
        return copied
    raise MalformedError(
        f"a value of type {type(value).__name__}: only text, integers, lists and "
        "records are allowed"
    )


def _text(value: str) -> str:
    if len(value) > MAXIMUM_TEXT:
        raise GivenUpError(f"given up: text longer than {MAXIMUM_TEXT} characters")
    return value


def difference(found: Plain, wanted: Plain, place: str) -> str | None:
    """Where two plain values first differ, as a sentence; None when they are the same."""
    if isinstance(found, dict) and isinstance(wanted, dict):
        for key in wanted:
            if key not in found:
                return f"{place}: {key!r} is missing"
        for key in found:
            if key not in wanted:
                return f"{place}: {key!r} is not expected"
            inner = difference(found[key], wanted[key], f"{place}.{key}")
            if inner is not None:
                return inner
        return None
    if isinstance(found, list) and isinstance(wanted, list):
        if len(found) != len(wanted):
            return f"{place}: {len(wanted)} items wanted, {len(found)} found"
        for number, (left, right) in enumerate(zip(found, wanted, strict=True)):
            inner = difference(left, right, f"{place}[{number}]")
            if inner is not None:
                return inner
        return None
    if type(found) is not type(wanted) or found != wanted:
        return f"{place}: {_short(wanted)} wanted, {_short(found)} found"
    return None


def _short(value: Plain) -> str:
    if isinstance(value, dict):
        return "a record"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    return repr(value) if len(str(value)) <= 60 else repr(str(value)[:57] + "...")
