"""Domains of variables: real intervals, or the integers in one."""

from __future__ import annotations

from collections.abc import Mapping
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
        kind = f", {name} an integer" if self.integer else ""
        left = "" if self.lower is None else f"{self.lower} {'<' if self.lower_open else '<='} "
        right = "" if self.upper is None else f" {'<' if self.upper_open else '<='} {self.upper}"
        if not left and not right:
            return f"all real {name}" if not kind else f"all integers {name}"
        if left and not right:
            return f"{name} {'>' if self.lower_open else '>='} {self.lower}{kind}"
        return f"{left}{name}{right}{kind}"


Boxes = Mapping[str, Box]
"""The domains of variables by their names."""
