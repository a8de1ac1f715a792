"""Points with two irrational coordinates, and polynomials that are zero there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import prod

import flint

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic
from gainproof.verify.judge.exact.polynomial import Ball, Poly, fraction, rational, terms
from gainproof.verify.judge.exact.polynomial_balls import evaluate
from gainproof.verify.judge.exact.rational_roots import content_of
from gainproof.verify.judge.exact.work_limits import Undecided

FIRST_BITS = 128
MOST_BITS = 20_000


@dataclass(frozen=True)
class Corner:
    """A point of several parameters, in the order of the tower."""

    coordinates: tuple[Algebraic, ...]

    at = None
    is_cell = False
    moved = ()

    @property
    def samples(self) -> tuple[tuple[Algebraic, ...], ...]:
        """The point itself."""
        return (self.coordinates,)


def vanishing_at(corner: Corner, indices: tuple[int, ...]) -> Callable[[Poly], bool]:
    """Whether a polynomial of these variables is zero at the point, exactly."""
    return lambda p: is_zero_at(p, corner.coordinates, indices)


def is_zero_at(p: Poly, coordinates: tuple[Algebraic, ...], indices: tuple[int, ...]) -> bool:
    """Whether p is zero at a point of algebraic coordinates. Raises Undecided.

    With integer coefficients, and times the leading coefficients of the coordinates' polynomials
    to the degrees of p, the value is an algebraic integer of degree D at most. Its conjugates are
    at most B, so it is zero or at least B^(1-D): a ball small enough tells.
    """
    p = p / rational(content_of(p))
    degrees = [max(0, int(p.degrees()[i])) for i in indices]
    conjugates = prod(len(a.coefficients) - 1 for a in coordinates)
    most = _most(p, coordinates, indices, degrees)
    bits = (conjugates - 1) * most.bit_length() + 8
    if bits > MOST_BITS:
        raise Undecided(f"a zero that needs more than {MOST_BITS} bits")
    precision = FIRST_BITS
    while True:
        ball = _ball(p, coordinates, indices, degrees, precision)
        if not ball.contains(0):
            return False
        if ball.abs_upper() < flint.arb(2) ** -bits:
            return True
        if precision > 4 * (bits + most.bit_length()) + 1000:
            raise Undecided("balls cannot tell a zero")
        precision *= 2


def _leads(coordinates: tuple[Algebraic, ...], degrees: list[int]) -> int:
    """The factor that makes the value an algebraic integer."""
    pairs = zip(coordinates, degrees, strict=True)
    return prod(abs(a.coefficients[-1]) ** d for a, d in pairs)


def _most(
    p: Poly, coordinates: tuple[Algebraic, ...], indices: tuple[int, ...], degrees: list[int]
) -> int:
    """A bound on all conjugates of the value: every root is at most Cauchy's bound."""
    bounds = [
        1 + -(-max(abs(c) for c in a.coefficients[:-1]) // abs(a.coefficients[-1]))
        for a in coordinates
    ]
    total = 0
    for exponents, coefficient in terms(p):
        powers = prod(b ** int(exponents[i]) for b, i in zip(bounds, indices, strict=True))
        total += abs(int(fraction(coefficient))) * powers
    return max(2, total * _leads(coordinates, degrees))


def _ball(
    p: Poly,
    coordinates: tuple[Algebraic, ...],
    indices: tuple[int, ...],
    degrees: list[int],
    precision: int,
) -> Ball:
    with flint.ctx.workprec(precision):
        values: list[Ball | None] = [None] * len(p.context().names())
        for i, a in zip(indices, coordinates, strict=True):
            values[i] = a.ball(precision)
        return evaluate(p, values) * flint.arb(_leads(coordinates, degrees))
