"""Sums of an exact constant and a scaled exact input: the one subtraction that costs one rounding.

c + f x with f = +-2^k is exact data until its own rounding. A constant that the format does not
hold is taken in two parts, (high + f x) + low: where they nearly cancel the first sum is exact
(Sterbenz), and where not its rounding is one more u, so that 2 u bound both cases.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.formats import FLOAT64, FORMATS, Format
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.program import Program


@dataclass(frozen=True)
class AffineSum:
    """`sign` times `constant`, plus `factor` times the input of step `source`; `parts`: 1 or 2."""

    constant: Constant
    sign: float
    source: int
    factor: float
    parts: int

    def zero(self, form: Format) -> tuple[float, float]:
        """The numbers of the format next to the input where the sum vanishes, or that one twice."""
        ends = [self._place(end) for end in self.constant.between()]
        return form.at_most(min(ends)), form.at_least(max(ends))

    def _place(self, value: Fraction) -> Fraction:
        return -value * Fraction(self.sign) / Fraction(self.factor)

    def crosses_zero(self) -> bool:
        """Whether the terms have opposite signs for positive inputs."""
        return (self.constant.between()[0] > 0) == (self.sign * self.factor < 0)

    def at(self, x: Array) -> Interval:
        """Enclosures (of either sign) of the sum at exact points."""
        high = FLOAT64.nearest(self.constant.between()[0])
        rest = [(end - Fraction(high)) * int(self.sign) for end in self.constant.between()]
        low_rest, high_rest = FLOAT64.at_most(min(rest)), FLOAT64.at_least(max(rest))
        scaled = self.factor * x
        total = high * self.sign + scaled
        part = total - scaled
        # exact error of the sum (Knuth); a scaled subnormal may have lost up to half a unit
        error = (scaled - (total - part)) + (high * self.sign - part)
        lost = np.where((np.abs(scaled) < 2.0**-1000) & (abs(self.factor) != 1), FLOAT64.least, 0.0)
        low, high_ = error + (low_rest - lost), error + (high_rest + lost)
        exact = (low == 0) & (high_ == 0)
        low, high_ = np.nextafter(low, -np.inf), np.nextafter(high_, np.inf)
        # a rest of one sign cannot pass the number itself: matters next to the largest one
        below, above = np.nextafter(total + low, -np.inf), np.nextafter(total + high_, np.inf)
        below = np.where(low >= 0, np.maximum(below, total), below)
        above = np.where(high_ <= 0, np.minimum(above, total), above)
        below, above = np.where(exact, total, below), np.where(exact, total, above)
        return below, above


def affine_sum(program: Program, number: int, form: Format) -> AffineSum | None:
    """The step as a sum of constant and input, None if it is another operation.

    A positive sum with a constant that the format does not hold is None too: it is an ordinary
    addition of a rounded constant.
    """
    step = program.steps[number]
    if step.operation not in ("add", "sub"):
        return None
    first, second = (program.affine(part) for part in step.operands)
    if first is None or second is None or (first[0] is None) == (second[0] is None):
        return None
    turn = -1.0 if step.operation == "sub" else 1.0
    second = (second[0], second[1], second[2] * turn)
    value, source = (first, second) if first[0] is not None else (second, first)
    if value[0] is None or value[0].rational == 0:
        return None
    whole = value[0].is_exact(form)
    found = AffineSum(value[0], value[2], source[1], source[2], 1 if whole else 2)
    return found if whole or found.crosses_zero() else None


def in_two_parts(program: Program, number: int) -> tuple[AffineSum, AffineSum] | None:
    """The step in float64 and float32 where it is printed in two steps: the nearest number to the
    constant, and the rest, which may be 0 in one of the formats.
    """
    double, single = (affine_sum(program, number, form) for form in FORMATS)
    if double is None or single is None or double.parts == single.parts == 1:
        return None
    return double, single
