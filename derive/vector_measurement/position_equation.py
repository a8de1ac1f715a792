"""The equation between Lambda, S and P11 without a root: of degree four in S^2 and in P11.

P11 = a + b delta with a and delta^2 of the form x + y c eta, and b of the form x c + y eta, where
c = Lambda w and eta, with known squares, change their signs together with sigma. The norm, taken
first over delta and then over c eta, has P11 among its roots; monic in P11 it has coefficients in
Lambda^2 and S^2 alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.polys.fields import FracField

from gainproof.derive.vector_measurement.names import INDEX, RATIO
from gainproof.derive.vector_measurement.spectrum import Spectrum, V
from gainproof.derive.vector_measurement.towers import rational

AREA, SQUARE, VARIANCE = sp.symbols("area square variance", real=True)
Pair = tuple[Any, Any]


@dataclass(frozen=True)
class _Roots:
    """Arithmetic of x + y c eta ("even") and x c + y eta ("odd") over rational functions."""

    field: Any
    one_end: Any
    other_end: Any

    def number(self, value: sp.Expr) -> Any:
        return self.field.from_expr(sp.sympify(value))

    def even(self, u: Pair, v: Pair) -> Pair:
        """Even times even."""
        both = self.one_end * self.other_end
        return u[0] * v[0] + u[1] * v[1] * both, u[0] * v[1] + u[1] * v[0]

    def odd(self, u: Pair, v: Pair) -> Pair:
        """Odd times odd, which is even."""
        first = u[0] * v[0] * self.one_end + u[1] * v[1] * self.other_end
        return first, u[0] * v[1] + u[1] * v[0]

    def mixed(self, u: Pair, v: Pair) -> Pair:
        """Even times odd, which is odd."""
        return u[0] * v[0] + u[1] * v[1] * self.other_end, u[0] * v[1] + u[1] * v[0] * self.one_end

    def inverse(self, u: Pair) -> Pair:
        """Of something even."""
        norm = u[0] ** 2 - u[1] ** 2 * self.one_end * self.other_end
        return u[0] / norm, -u[1] / norm


def _sum(*terms: Pair) -> Pair:
    first, second = zip(*terms, strict=True)
    return sum(first[1:], first[0]), sum(second[1:], second[0])


def _times(factor: Any, u: Pair) -> Pair:
    return factor * u[0], factor * u[1]


def position_equation(spectrum: Spectrum) -> tuple[sp.Expr, ...]:
    """The coefficients of 1, S^2, S^4, ...: polynomials in INDEX^2 and `VARIANCE`, free of any
    common factor.
    """
    field = FracField([AREA, SQUARE], sp.QQ)
    replaced = {INDEX: sp.sqrt(AREA), RATIO: sp.sqrt(SQUARE)}
    ends = (sp.expand(spectrum.polynomial.subs(V, v).subs(replaced)) for v in (0, 4))
    x = _Roots(field, *(field.from_expr(sp.together(end)) for end in ends))
    middle, delta_squared, other = _parts(x, spectrum)
    square = x.even(middle, middle)
    rest = x.even(delta_squared, x.odd(other, other))
    # of (P11 - a)^2 - (b delta)^2: what is free of c eta, and its coefficient, by powers of P11
    plain = [square[0] - rest[0], -2 * middle[0], field.one]
    mixed = [square[1] - rest[1], -2 * middle[1]]
    both = x.one_end * x.other_end
    norm = [field.zero] * 5
    for first, entry in enumerate(plain):
        for second, another in enumerate(plain):
            norm[first + second] += entry * another
    for first, entry in enumerate(mixed):
        for second, another in enumerate(mixed):
            norm[first + second] -= entry * another * both
    terms = (entry.as_expr() * VARIANCE**power for power, entry in enumerate(norm))
    numerator = sp.Poly(sp.numer(sp.together(sp.Add(*terms))), VARIANCE)
    whole = sp.Poly(numerator.primitive()[1].as_expr(), SQUARE)
    return tuple(
        sp.factor(whole.coeff_monomial(SQUARE**power)).subs(AREA, INDEX**2)
        for power in range(whole.degree() + 1)
    )


def _parts(x: _Roots, spectrum: Spectrum) -> tuple[Pair, Pair, Pair]:
    """a, delta^2 and b of P11 = a + b delta, from h (1 + (delta/S)^2) and the forms of P11."""
    n, first = rational(spectrum.noise.n), rational(spectrum.noise.first)
    number, half = x.number, x.number(sp.Rational(1, 2))
    mean: Pair = (half, half)
    one_end: Pair = (number(1), number(0))
    delta_squared = _sum(x.odd(mean, mean), (number(-4), number(0)))
    below = x.inverse(_sum(delta_squared, (number(SQUARE), number(0))))
    plain = x.mixed(below, _sum(_times(number(AREA / 2), mean), _times(number(SQUARE), one_end)))
    by_delta = x.even(below, (number(-AREA * (1 - 2 * n) / 2), number(0)))
    area = number(AREA * (first - n) / 2)
    middle = _sum(
        by_delta,
        _times(half, x.odd(mean, plain)),
        _times(half, x.even(delta_squared, by_delta)),
        (area, number(0)),
    )
    inverse = x.inverse(delta_squared)
    other = _sum(
        x.mixed(inverse, _sum(one_end, plain)),
        _times(half, _sum(x.mixed(by_delta, mean), plain)),
        _times(area, x.mixed(inverse, mean)),
    )
    return middle, delta_squared, other
