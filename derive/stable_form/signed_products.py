"""Values as products of factors of one sign each: factor by factor, and sums term by term.

A sum is brought to its normal form, in which most cancels. Where that has no sign that is found,
its terms are put into two groups that have the same one, and then it is taken as it came.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from itertools import combinations
from operator import mul

import sympy as sp

from gainproof.derive.algebra.tower import Fraction as Quotient
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.stable_form.normal_form import Normal
from gainproof.derive.stable_form.polynomial_products import Product, of_poly
from gainproof.derive.stable_form.signed_factors import Signs, plain

GATHERED = "terms gathered into two sums of one sign"
MOST_TERMS = 6  # of a sum whose groups are tried


class Products:
    """The search in one tower."""

    def __init__(self, tower: Tower) -> None:
        self.tower, self.normal = tower, Normal(tower)
        self.order = range(len(tower.generators))[::-1]
        self._known: dict[sp.Expr, Product] = {}

    def by_factors(self, value: sp.Expr) -> Product:
        """Products and powers factor by factor, sums as they are best."""
        if value not in self._known:
            self._known[value] = self._by_factors(value)
        return self._known[value]

    def _by_factors(self, value: sp.Expr) -> Product:
        if isinstance(value, sp.Mul):
            return reduce(mul, map(self.by_factors, value.args))
        if isinstance(value, sp.Pow):
            base = self.by_factors(value.base)
            if not base.constant and value.exp < 0:
                raise ZeroDivisionError
            return base ** int(value.exp)
        found = self.whole(value)
        if shown(found) or not isinstance(value, sp.Add):
            return found
        for other in (self._gathered(value), self._quotient(self.tower.fraction(value))):
            if other is not None and shown(other):
                return other
        return found

    def whole(self, value: sp.Expr) -> Product:
        """The normal form of a value, in which factors of sums may cancel too."""
        return self._quotient(self.normal.value(value))

    def _quotient(self, value: Quotient) -> Product:
        if not value.num:
            return Product(Fraction(0))
        below = Signs(self.tower, self.order).product(value.den)
        return Signs(self.tower, self.order, below.powers).product(value.num) * below**-1

    def _gathered(self, value: sp.Add) -> Product | None:
        for group in _groups(value):
            first, second = self.by_factors(group), self.by_factors(value - group)
            if shown(first) and shown(second) and first.constant * second.constant > 0:
                return self._sum(first, second).because(GATHERED)
        return None

    def _sum(self, first: Product, second: Product) -> Product:
        """The sum of two products of one sign each, which they share."""
        powers = {
            factor: min(first.powers.get(factor, 0), second.powers.get(factor, 0))
            for factor in (*first.powers, *second.powers)
        }
        common = Product(Fraction(1), powers, (*first.rules, *second.rules))
        total = self.tower.ring.zero
        for part in (first, second):
            rest = part * common**-1
            term = self.tower.ring.ground_new(
                sp.QQ(rest.constant.numerator, rest.constant.denominator)
            )
            for factor, power in rest.powers.items():
                term = self.tower.reduce(term * factor**power)
            total += term
        return common * of_poly(total)


def shown(product: Product) -> bool:
    """Whether every factor has one sign."""
    return all(map(plain, product.powers))


def _groups(value: sp.Add) -> Iterator[sp.Expr]:
    """Sums of some of the terms: of each way to make two groups one, the smaller ones first."""
    terms = value.args
    if len(terms) > MOST_TERMS:
        return
    for count in range(1, len(terms) // 2 + 1):
        for group in combinations(terms, count):
            if 2 * count < len(terms) or terms[0] in group:
                yield sp.Add(*group)
