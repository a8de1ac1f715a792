"""The start of three states from the first three positions, an interval apart each.

Nothing is known before: the state at the third position is what three positions make of it, and
its covariance is what their errors and the process noise of both intervals leave. Its factors are
quotients of polynomials in the two intervals, q and r without a minus sign.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import sympy as sp

from gainproof.derive.recursion.noise import Q, T
from gainproof.derive.recursion.polynomial import nested, times
from gainproof.derive.recursion.three_state_forms import Triple
from gainproof.derive.recursion.three_state_names import R, S, transition
from gainproof.derive.recursion.three_state_noise import TripleNoise

ORDER = (Q, R, T, S)
SPAN = S * T * (S + T)


def sights() -> sp.ImmutableDenseMatrix:
    """What three positions show of the last state without noise, the newest in the first row."""
    back = (sp.Integer(0), T, S + T)
    return sp.ImmutableDenseMatrix([list(transition(-x)[0, :]) for x in back])


@cache  # asked for by each of the families' kernels and steps
def weights() -> sp.ImmutableDenseMatrix:
    """W, with which three positions give the state: the parabola through them."""
    inverse: Any = sights().inv()
    return sp.ImmutableDenseMatrix(inverse.applyfunc(sp.factor))


@cache
def newer() -> sp.ImmutableDenseMatrix:
    """What the noise of the second interval does to the state that W gives."""
    rows = sights()
    return _factored(weights() * sp.ImmutableDenseMatrix([[0, 0, 0], rows[1, :], rows[2, :]]))


@cache
def older() -> sp.ImmutableDenseMatrix:
    """What the noise of the first interval does."""
    last = list(transition(-S)[0, :])
    return _factored(weights() * sp.ImmutableDenseMatrix([[0, 0, 0], [0, 0, 0], last]))


def _factored(matrix: Any) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix(matrix.applyfunc(sp.factor))


MATRICES = {"w": weights, "newer": newer, "older": older}
"""W, A and B by the prefix of their entries' names."""


def entry_names(prefix: str) -> dict[str, sp.Expr]:
    """The entries of W, A or B that are no plain numbers, by name."""
    matrix = MATRICES[prefix]()
    return {
        f"{prefix}_{i + 1}{j + 1}": matrix[i, j]
        for i in range(3)
        for j in range(3)
        if matrix[i, j].free_symbols
    }


def covariance(noise: TripleNoise) -> sp.ImmutableDenseMatrix:
    """Of the state that W gives, times the square of s t (s + t): polynomials in q, s, t and r."""
    square, two, one = (
        sp.ImmutableDenseMatrix((SPAN * matrix).applyfunc(sp.cancel))
        for matrix in (weights(), newer(), older())
    )
    first = noise.covariance.subs(T, S)
    whole = R * square * square.T + two * noise.covariance * two.T + one * first * one.T
    return sp.ImmutableDenseMatrix(whole.applyfunc(sp.expand))


@dataclass(frozen=True)
class _Scaled:
    """`value` times the number `share`: a polynomial without its numbers, or a quotient of two."""

    value: Any
    share: Fraction

    def over(self, other: _Scaled) -> _Scaled:
        return _Scaled(self.value / other.value, self.share / other.share)

    def by(self, other: _Scaled) -> _Scaled:
        return _Scaled(self.value * other.value, self.share * other.share)

    @property
    def whole(self) -> Any:
        return times(self.value, self.share)


def _scaled(
    expression: sp.Expr, at: Mapping[sp.Symbol, Any], divisor: sp.Expr = sp.S.One
) -> _Scaled:
    """A polynomial over one that divides it, its coefficients whole numbers without a divisor."""
    found = sp.Poly(expression, *ORDER).exquo(sp.Poly(divisor, *ORDER))
    share, polynomial = found.primitive()
    return _Scaled(nested(polynomial.as_expr(), ORDER, at), Fraction(str(share)))


def started(noise: TripleNoise, at: Mapping[sp.Symbol, Any]) -> Triple:
    """The factors, where `at` has the values (symbols or nodes) of q, s, t and r."""
    p = covariance(noise)
    last, near, far = (_scaled(p[place], at) for place in ((2, 2), (1, 2), (0, 2)))
    # minors and determinant are linear in what lies below the line, like the entries
    below = _scaled(p[1, 1] * p[2, 2] - p[1, 2] ** 2, at, SPAN**2)
    mixed = _scaled(p[0, 1] * p[1, 2] - p[0, 2] * p[1, 1], at, SPAN**2)
    whole = _scaled(p.det(), at, SPAN**4)
    span = (at[S] * at[T]) * (at[S] + at[T])
    return Triple(
        whole.over(below).whole,
        below.over(last).whole,
        last.whole / (span * span),
        far.over(near).whole,
        near.over(last).whole,
        # two quotients: the products of numerators would leave the range of float32
        last.over(below).by(mixed.over(near)).whole,
    )
