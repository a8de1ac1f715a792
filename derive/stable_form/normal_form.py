"""Elements of a tower with no root below the line and nothing common above and below it.

That form is unique, and of low degree: sums of quotients that are not brought to it grow with
every step. It may lose digits where the one it came from does not; signs are looked for later.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from gainproof.derive.algebra.tower import Fraction, Poly, Tower


class Normal:
    """Values of expressions over the variables of one tower."""

    def __init__(self, tower: Tower) -> None:
        self.tower = tower
        self._known: dict[sp.Expr, Fraction] = {}

    def value(self, expression: sp.Expr) -> Fraction:
        """The normal form; ZeroDivisionError for a division by 0."""
        if expression not in self._known:
            self._known[expression] = self._value(expression)
        return self._known[expression]

    def _value(self, expression: sp.Expr) -> Fraction:
        if isinstance(expression, sp.Add):
            return self._folded(expression, self._sum)
        if isinstance(expression, sp.Mul):
            return self._folded(expression, self._product)
        if isinstance(expression, sp.Pow):
            base, power = self.value(expression.base), int(expression.exp)
            if power < 0:
                base = self._normal(base.den, base.num)
            return self._normal(base.num ** abs(power), base.den ** abs(power))
        found = self.tower.fraction(expression)
        return self._normal(found.num, found.den)

    def _folded(
        self, expression: sp.Expr, step: Callable[[Fraction, Fraction], Fraction]
    ) -> Fraction:
        first, *others = map(self.value, expression.args)
        for other in others:
            first = step(first, other)
        return first

    def _sum(self, a: Fraction, b: Fraction) -> Fraction:
        return self._normal(a.num * b.den + b.num * a.den, a.den * b.den)

    def _product(self, a: Fraction, b: Fraction) -> Fraction:
        return self._normal(a.num * b.num, a.den * b.den)

    def _normal(self, num: Poly, den: Poly) -> Fraction:
        tower = self.tower
        num, den = tower.reduce(num), tower.reduce(den)
        if not den:
            raise ZeroDivisionError("a division by 0")
        for position in reversed(range(len(tower.generators))):
            index = len(tower.parameters) + position
            if den.degree(index) > 0:
                conjugate = den - 2 * linear(den, index)
                num, den = tower.reduce(num * conjugate), tower.reduce(den * conjugate)
        return Fraction(*num.cancel(den))


def linear(poly: Poly, index: int) -> Poly:
    """The terms that hold one variable, of which no power above the first occurs."""
    found = poly.ring.zero
    for exponents, coefficient in poly.terms():
        if exponents[index]:
            found += poly.ring.term_new(exponents, coefficient)
    return found
