"""Domains of variables: real intervals, or the integers in one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, floor


@dataclass(frozen=True)
class Box:
    """Where a variable lives. A missing bound is infinite; `stated` says that the domain was given,
    not guessed.
    """

    lower: Fraction | None = None
    upper: Fraction | None = None
    lower_open: bool = True
    upper_open: bool = True
    integer: bool = False
    stated: bool = True

    @property
    def is_empty(self) -> bool:
        """Whether no real number (or integer, for integers) lies in it."""
        if self.lower is None or self.upper is None:
            return False
        if self.lower > self.upper or (
            self.lower == self.upper and (self.lower_open or self.upper_open)
        ):
            return True
        if not self.integer:
            return False
        return not any(self.holds(Fraction(n)) for n in (ceil(self.lower), floor(self.lower) + 1))

    @property
    def is_positive(self) -> bool:
        """Whether every number in it is greater than zero."""
        return self.lower is not None and (self.lower > 0 or (self.lower == 0 and self.lower_open))

    @property
    def is_nonnegative(self) -> bool:
        """Whether no number in it is less than zero."""
        return self.lower is not None and self.lower >= 0

    def holds(self, value: Fraction) -> bool:
        """Whether the number lies in it."""
        if self.integer and value.denominator != 1:
            return False
        if self.lower is not None and (
            value < self.lower or (value == self.lower and self.lower_open)
        ):
            return False
        return self.upper is None or not (
            value > self.upper or (value == self.upper and self.upper_open)
        )

    def text(self, name: str) -> str:
        """Readable."""
        if self.integer and self.lower is None and self.upper is None:
            return f"all integers {name}"
        ends = ("" if end is None else str(end) for end in (self.lower, self.upper))
        text = interval_text(name, ends, self.lower_open, self.upper_open)
        return f"{text}, {name} an integer" if self.integer else text


Boxes = Mapping[str, Box]
"""The domains of variables by their names."""


def interval_text(
    name: str, ends: Iterable[str], lower_open: bool = True, upper_open: bool = True
) -> str:
    """`x > 0`, `0 <= x < 1`, `all real x`; an end that is missing is empty."""
    lower, upper = ends
    below, above = "<" if lower_open else "<=", "<" if upper_open else "<="
    if lower and upper:
        return f"{lower} {below} {name} {above} {upper}"
    if lower:
        return f"{name} {below.replace('<', '>')} {lower}"
    return f"{name} {above} {upper}" if upper else f"all real {name}"


def bounds_text(boxes: Boxes, labels: Mapping[str, str]) -> list[str]:
    """The domains that have an end, each readable; `labels`: how variables are written."""
    bounded = {n: box for n, box in boxes.items() if (box.lower, box.upper) != (None, None)}
    return [box.text(labels.get(name, name)) for name, box in bounded.items()]
