"""Distinct real roots of polynomials whose coefficients are rational or in the field of one real
algebraic number: how many there are in an interval, by Sturm's theorem in exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import flint

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided

Element = Any
"""A flint.fmpq_poly in the algebraic number, of lower degree than its own polynomial."""
Coefficients = list[Element]
"""From power 0 up; the last is not zero, and the zero polynomial is empty."""


@dataclass(frozen=True)
class NumberField:
    """The field of one real algebraic number."""

    number: Algebraic

    @property
    def _modulus(self) -> Element:
        return flint.fmpq_poly(list(self.number.coefficients))

    def sign(self, value: Element) -> int:
        """Exact: only the zero element is zero, as the number's own polynomial is irreducible.
        Raises Undecided for one too near to it.
        """
        precision = 64
        while value and precision <= DEFAULT_LIMITS.precision:
            with flint.ctx.workprec(precision + 10):
                ball: Ball = flint.arb_poly(value)(self.number.ball(precision))
                if not ball.contains(0):
                    return 1 if ball > 0 else -1
            precision *= 2
        if value:
            raise Undecided("a sign at an algebraic number needs too many digits")
        return 0

    def quotient(self, top: Element, bottom: Element) -> Element:
        """Of two elements, the second not zero."""
        one, inverse, _ = bottom.xgcd(self._modulus)
        return top * inverse / one[0] % self._modulus

    def polynomial(self, coefficients: Sequence[Element]) -> Coefficients:
        """Without leading zeros."""
        found = [c % self._modulus for c in coefficients]
        while found and not found[-1]:
            found.pop()
        return found

    def slope(self, f: Coefficients) -> Coefficients:
        """The derivative."""
        return self.polynomial([k * c for k, c in enumerate(f)][1:])

    def divided(self, f: Coefficients, by: Coefficients) -> tuple[Coefficients, Coefficients]:
        """Quotient and rest."""
        rest, found = f, [flint.fmpq_poly([0])] * len(f)
        while len(rest) >= len(by):
            shift = len(rest) - len(by)
            found[shift] = self.quotient(rest[-1], by[-1])
            lower = zip(rest[shift:-1], by[:-1], strict=True)
            rest = self.polynomial([*rest[:shift], *(c - found[shift] * b for c, b in lower)])
        return self.polynomial(found), rest

    def common(self, f: Coefficients, g: Coefficients) -> Coefficients:
        """A greatest common divisor."""
        while g:
            f, g = g, self.divided(f, g)[1]
        return f

    def simple(self, f: Coefficients, without: Sequence[Coefficients] = ()) -> Coefficients:
        """A polynomial with simple roots: those of f, which is not zero, that none of the others
        has.
        """
        found = self.divided(f, self.common(f, self.slope(f)))[0]
        for other in without:
            found = self.divided(found, self.common(found, other))[0]
        return found

    def value(self, f: Coefficients, at: Element) -> Element:
        """The polynomial at an element."""
        total = flint.fmpq_poly([0])
        for c in reversed(f):
            total = (total * at + c) % self._modulus
        return total

    def roots_up_to(self, f: Coefficients, low: Element | None, high: Element | None) -> int:
        """The real roots of a polynomial with simple roots that are above `low` and not above
        `high`, which is not below it; None is infinite.
        """
        chain = [f, self.slope(f)]
        while chain[-1]:
            chain.append([-c for c in self.divided(chain[-2], chain[-1])[1]])
        return self._changes(chain[:-1], low, -1) - self._changes(chain[:-1], high, 1)

    def _changes(self, chain: Sequence[Coefficients], at: Element | None, side: int) -> int:
        if at is None:
            signs = [self.sign(f[-1]) * side ** (len(f) - 1) for f in chain]
        else:
            signs = [self.sign(self.value(f, at)) for f in chain]
        return sum(a != b for a, b in pairwise([s for s in signs if s]))
