"""Products of polynomials of one tower, with the rules that led to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Poly


@dataclass(frozen=True)
class Product:
    """constant * product of factor^power; no factor is a number."""

    constant: Fraction
    powers: Mapping[Poly, int] = field(default_factory=dict)
    rules: tuple[str, ...] = ()

    def __mul__(self, other: Product) -> Product:
        powers = dict(self.powers)
        for factor, power in other.powers.items():
            powers[factor] = powers.get(factor, 0) + power
        kept = {factor: power for factor, power in powers.items() if power}
        rules = tuple(dict.fromkeys((*self.rules, *other.rules)))
        return Product(self.constant * other.constant, kept, rules)

    def __pow__(self, power: int) -> Product:
        powers = {factor: each * power for factor, each in self.powers.items() if power}
        return Product(self.constant**power, powers, self.rules)

    def because(self, rule: str) -> Product:
        """The same, by one rule more."""
        return self * Product(Fraction(1), {}, (rule,))


def of_poly(poly: Poly) -> Product:
    """A polynomial as a number and one factor of whole coprime coefficients, its first positive."""
    if poly.is_ground:
        return Product(exact(poly.coeff(1)))
    content, part = poly.primitive()
    if part.LC < 0:
        content, part = -content, -part
    return Product(exact(content), {part: 1})


def exact(value: object) -> Fraction:
    """A coefficient as a fraction of Python's own."""
    number = sp.QQ.to_sympy(value)
    return Fraction(int(number.p), int(number.q))
