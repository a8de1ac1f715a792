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
from sympy.polys.rings import PolyRing

from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.names import XI
from gainproof.derive.three_state.spectrum import Spectrum

B, C, X = sp.symbols("b c x")
DIGITS, NOTHING = 60, mp.mpf(10) ** -40
Terms = Mapping[tuple[int, int], sp.Expr]
Number = Any
"""An element of SymPy's ring of polynomials in b and c; SymPy ships no types for it."""


class Surds:
    """Numbers over b and c of a family: polynomials in these, or in b where c is rational."""

    def __init__(self, spectrum: Spectrum) -> None:
        m1, m2 = rational(spectrum.m1), rational(spectrum.m2)
        self.ring = PolyRing([B, C], sp.QQ, sp.lex)
        root = sp.sqrt(m2)
        c = root if root.is_Rational else C
        self.relations = [self.ring.from_expr(entry) for entry in (C**2 - m2, B**2 - m1 - 2 * c)]
        root = sp.sqrt(m1 + 2 * c) if c is not C else B
        b = root if root.is_Rational else B
        with mp.workdps(DIGITS):
            value = mp.sqrt(mp.mpf(m2.p) / m2.q)
            self.values = mp.sqrt(mp.mpf(m1.p) / m1.q + 2 * value), value
        self.least = self.ring.from_expr(1 + b)
        self.inverse = self.of(_inverse(m1, m2, b, c))

    def of(self, value: sp.Expr) -> Number:
        """An expression in b and c, the squares of these put in place."""
        return self.reduced(self.ring.from_expr(sp.expand(value)))

    def reduced(self, value: Number) -> Number:
        """The squares of b and c put in place."""
        return value.rem(self.relations)

    def size(self, value: Number) -> Any:
        """The value, to many digits."""
        with mp.workdps(DIGITS):
            (b, c), total = self.values, mp.mpf(0)
            for (first, second), number in value.terms():
                total += (
                    mp.mpf(int(number.numerator)) / int(number.denominator) * b**first * c**second
                )
            return total


def _inverse(m1: sp.Rational, m2: sp.Rational, b: sp.Expr, c: sp.Expr) -> sp.Expr:
    """1/xi0, with nothing but rationals below the line."""
    if b is not B:
        return 1 / (1 + b)
    if c is not C:
        return (B - 1) / (m1 - 1 + 2 * c)
    return (B - 1) * (m1 - 1 - 2 * C) / ((m1 - 1) ** 2 - 4 * m2)


def positive_terms(spectrum: Spectrum, polynomial: sp.Expr) -> Terms:
    """The factors by i and j; both powers are counted in a polynomial in xi.

    Raises ArithmeticError where a coefficient in xi - xi0 is negative.
    """
    surds = Surds(spectrum)
    left = _coefficients(surds, polynomial)
    if any(surds.size(value) < -NOTHING for value in left.values()):
        raise ArithmeticError(f"no form without subtraction for {polynomial}")
    degree, least = max(left), surds.size(surds.least)
    found: dict[tuple[int, int], sp.Expr] = {}
    for i in range(degree + 1):
        for j in range(degree - i, -1, -1):
            shares = {
                n: surds.size(left.get(i + n, surds.ring.zero)) / (comb(j, n) * least ** (j - n))
                for n in range(j + 1)
            }
            scarce = min(shares, key=lambda n: shares[n])
            if shares[scarce] < NOTHING:
                continue
            inverse = surds.reduced(surds.inverse ** (j - scarce))
            factor = surds.reduced(left[i + scarce] * inverse).quo_ground(comb(j, scarce))
            found[i, j] = factor.as_expr()
            for n in range(j + 1):
                used = factor * surds.reduced(surds.least ** (j - n)) * comb(j, n)
                left[i + n] = surds.reduced(left[i + n] - used)
            del left[i + scarce]
    return found


def _coefficients(surds: Surds, polynomial: sp.Expr) -> dict[int, Number]:
    """By powers of xi - xi0."""
    shifted = sp.Poly(sp.expand(polynomial.subs(XI, surds.least.as_expr() + X)), X)
    reduced = {power: surds.of(value) for (power,), value in shifted.terms()}
    return {power: value for power, value in reduced.items() if value}


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
