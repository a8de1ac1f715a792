"""Questions to Gappa: enclosures of expressions over intervals.

No hint is ever given, so that Gappa assumes nothing beyond the hypotheses of a question.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from time import perf_counter

from gainproof.certify import external
from gainproof.certify.sizes import logarithm

PROGRAM = "gappa"
COMMAND = (PROGRAM, "-Eprecision=100", "-Eno-auto-dichotomy")
AND = " /\\ "
_NUMBER = r"([-0-9b]+)(?: \{[^}]*\})?"
_FOUND = re.compile(rf"^  (\w+) in \[{_NUMBER}, {_NUMBER}\]", re.MULTILINE)
_RENAMED = re.compile(r"^Warning: renaming identifier '(\w+)' as '(\w+)' .*\n?", re.MULTILINE)

Enclosure = tuple[Fraction, Fraction]


class OutOfTimeError(Exception):
    """No answer in time."""


def enclosures(
    definitions: str, given: Iterable[str], asked: Iterable[str], stop: float
) -> Mapping[str, Enclosure]:
    """Enclosures of the names that are asked for; those that Gappa does not bound are missing.

    Nothing is found where Gappa warns of anything but a name for something that has one.
    OutOfTimeError when the clock (perf_counter) passes `stop`.
    """
    names = list(asked)
    question = AND.join(f"{name} in ?" for name in names)
    text = f"{definitions}{{ {AND.join(given)} -> {question} }}\n"
    limit = stop - perf_counter()
    answer = external.ask(COMMAND, "question.g", text, limit) if limit > 0 else None
    if answer is None or answer.status is None:
        raise OutOfTimeError
    last = dict(_RENAMED.findall(answer.text))
    said = _RENAMED.sub("", answer.text)
    if "Warning" in said:
        return {}
    found = {name: (fraction(low), fraction(high)) for name, low, high in _FOUND.findall(said)}
    result = {}
    for name in names:
        shown = name
        while shown in last and shown not in found:
            shown = last[shown]
        if shown in found:
            result[name] = found[shown]
    return result


def proves(text: str, stop: float) -> bool:
    """Whether Gappa proves a whole file, without a warning."""
    limit = stop - perf_counter()
    answer = external.ask(COMMAND, "question.g", text, limit) if limit > 0 else None
    if answer is None or answer.status is None:
        raise OutOfTimeError
    return answer.status == 0 and not answer.text.strip()


def dyadic(value: Fraction) -> str:
    """A number m * 2^e as Gappa writes it. ValueError for any other."""
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"a number m * 2^e is wanted, not {value}")
    zeros = (value.numerator & -value.numerator).bit_length() - 1 if value else 0
    return f"{value.numerator >> zeros}b{zeros - (value.denominator.bit_length() - 1)}"


def fraction(text: str) -> Fraction:
    """A number as Gappa writes it."""
    whole, _, power = text.partition("b")
    return Fraction(int(whole)) * Fraction(2) ** int(power or "0")


def down(value: Fraction) -> Fraction:
    """At most a positive value, by at most 2^-69 of it: of few digits, as Gappa is to read it."""
    return _rounded(value, -1)


def up(value: Fraction) -> Fraction:
    """At least a positive value, likewise."""
    return _rounded(value, 1)


def _rounded(value: Fraction, turn: int) -> Fraction:
    unit = Fraction(2) ** (round(logarithm(value)) - 70)
    return value // unit * unit if turn < 0 else -(-value // unit) * unit
