"""Polynomials in xi as sums of positive terms in h = (xi - xi0)/xi and v = 1/xi, xi0 = 1 + b.

A polynomial without a negative coefficient in xi - xi0 is a sum of terms (xi - xi0)^i xi^j with
positive factors. They are chosen with as few powers of the difference as can be, since it is
known with more error than xi. The factors are numbers over the roots b and c of the family.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import comb
from typing import Any

import mpmath as mp
import sympy as sp

from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.names import XI
from gainproof.derive.three_state.spectrum import Spectrum

B, C, X = sp.symbols("b c x")
DIGITS, NOTHING = 60, mp.mpf(10) ** -40
Terms = Mapping[tuple[int, int], sp.Expr]


class Surds:
    """Numbers over b and c of a family: rationals where these are, else symbols."""

    def __init__(self, spectrum: Spectrum) -> None:
        self.m1, self.m2 = rational(spectrum.m1), rational(spectrum.m2)
        root = sp.sqrt(self.m2)
        self.c = root if root.is_Rational else C
        root = sp.sqrt(self.m1 + 2 * self.c) if self.c is not C else B
        self.b = root if root.is_Rational else B
        with mp.workdps(DIGITS):
            c = mp.sqrt(mp.mpf(self.m2.p) / self.m2.q)
            self.values = mp.sqrt(mp.mpf(self.m1.p) / self.m1.q + 2 * c), c
        self.least = 1 + self.b

    @property
    def inverse(self) -> sp.Expr:
        """1/xi0, with nothing but rationals below the line."""
        if self.b is not B:
            return 1 / self.least
        below, conjugate = self.m1 - 1 + 2 * self.c, self.m1 - 1 - 2 * self.c
        if self.c is not C:
            return self.reduced((B - 1) / below)
        return self.reduced((B - 1) * conjugate / ((self.m1 - 1) ** 2 - 4 * self.m2))

    def reduced(self, value: sp.Expr) -> sp.Expr:
        """The squares of b and c put in place."""
        relations = [C**2 - self.m2, B**2 - self.m1 - 2 * self.c]
        return sp.reduced(sp.expand(value), relations, B, C, order="lex")[1]

    def number(self, value: sp.Expr) -> Any:
        """The value, to many digits."""
        with mp.workdps(DIGITS):
            return mp.mpf(1) * sp.lambdify((B, C), value, "mpmath")(*self.values)


def positive_terms(spectrum: Spectrum, polynomial: sp.Expr) -> Terms:
    """The factors by i and j; both powers are counted in a polynomial in xi.

    Raises ArithmeticError where a coefficient in xi - xi0 is negative.
    """
    surds = Surds(spectrum)
    left = _coefficients(surds, polynomial)
    if any(surds.number(value) < -NOTHING for value in left.values()):
        raise ArithmeticError(f"no form without subtraction for {polynomial}")
    degree, inverse = max(left), surds.inverse
    least = surds.number(surds.least)
    found: dict[tuple[int, int], sp.Expr] = {}
    for i in range(degree + 1):
        for j in range(degree - i, -1, -1):
            shares = {
                n: surds.number(left.get(i + n, sp.Integer(0))) / (comb(j, n) * least ** (j - n))
                for n in range(j + 1)
            }
            scarce = min(shares, key=lambda n: shares[n])
            if shares[scarce] < NOTHING:
                continue
            factor = surds.reduced(left[i + scarce] * inverse ** (j - scarce) / comb(j, scarce))
            found[i, j] = factor
            for n in range(j + 1):
                used = factor * comb(j, n) * surds.least ** (j - n)
                left[i + n] = surds.reduced(left[i + n] - used)
            del left[i + scarce]
    return found


def _coefficients(surds: Surds, polynomial: sp.Expr) -> dict[int, sp.Expr]:
    """By powers of xi - xi0."""
    shifted = sp.Poly(sp.expand(polynomial.subs(XI, surds.least + X)), X)
    reduced = {power: surds.reduced(value) for (power,), value in shifted.terms()}
    return {power: value for power, value in reduced.items() if value != 0}


def node_of(value: sp.Expr, b: Any, c: Any) -> Any:
    """A number over b and c as a number or a node; its terms may have either sign."""
    terms = []
    for (first, second), number in sp.Poly(value, B, C).terms():
        term: Any = Fraction(int(number.p), int(number.q))
        for root in (b,) * first + (c,) * second:
            term = root * term
        terms.append(term)
    found, *others = terms
    for term in others:
        found = found + term
    return found
