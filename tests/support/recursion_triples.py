"""Covariances of three states in fractions: noises, motions, factors by elimination.

The process noises are those of ``oracles.noise``, from their physical description.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from recursion_tracks import transition

from gainproof.verify.oracles import noise
from gainproof.verify.oracles.matrices import Matrix, identity, matrix, product, scale, transpose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import StateSpace
from gainproof.verify.oracles.trajectory import Move, last_covariance

ONE = Fraction(1)
ROW = matrix([[1, 0, 0]], Fraction)
NOISES = (
    "acceleration_increments",
    "wiener_acceleration",
    "random_jerk",
    "continuous_white_jerk",
)
FACTORS = (
    "diagonal_1",
    "diagonal_2",
    "diagonal_3",
    "first_shear",
    "second_shear",
    "third_shear",
)


@cache
def unit_noise(name: str, interval: Fraction) -> Matrix:
    """One unit of a noise over an interval: integrated, or what it does until the end."""
    a, b = noise.chain(3)
    motion = transition(interval, 3)
    if name == "continuous_white_jerk":
        return matrix(noise.white(a, b, interval, 60), fraction)
    if name == "random_jerk":
        return matrix(noise.held(a, b, interval, 60), fraction)
    # an acceleration from the interval's start on is carried by the motion; else it comes last
    column = tuple((row[2],) for row in motion) if name == "wiener_acceleration" else b
    return product(column, transpose(column))


def move(name: str, interval: Fraction, strength: Fraction) -> Move:
    """One interval for the batch: a noise through one shape has one disturbance."""
    whole = scale(strength, unit_noise(name, interval))
    if name == "continuous_white_jerk":
        return Move(transition(interval, 3), identity(3, Fraction(1)), whole)
    last = whole[2][2]
    shape = tuple((row[2] / last,) for row in whole)
    return Move(transition(interval, 3), shape, ((last,),))


def covariance(values: Sequence[Any]) -> Matrix:
    """U D U' with U the product of the three shears, exactly."""
    d1, d2, d3, a, b, c = map(Fraction, values)
    one, zero = Fraction(1), Fraction(0)
    first = ((one, a, zero), (zero, one, zero), (zero, zero, one))
    second = ((one, zero, zero), (zero, one, b), (zero, zero, one))
    third = ((one, c, zero), (zero, one, zero), (zero, zero, one))
    u = product(first, second, third)
    diagonal = ((d1, zero, zero), (zero, d2, zero), (zero, zero, d3))
    return product(u, diagonal, transpose(u))


def factors(p: Matrix) -> dict[str, Fraction]:
    """The factors by elimination from the last state, then the shears from the first row."""
    d3 = p[2][2]
    u13, u23 = p[0][2] / d3, p[1][2] / d3
    d2 = p[1][1] - u23 * u23 * d3
    u12 = (p[0][1] - u13 * u23 * d3) / d2
    d1 = p[0][0] - u12 * u12 * d2 - u13 * u13 * d3
    a = u13 / u23 if u23 else Fraction(0)
    return dict(zip(FACTORS, (d1, d2, d3, a, u23, u12 - a), strict=True))


@cache
def model(name: str, index: Fraction) -> StateSpace:
    """A filter in units of the interval and of the measured position's deviation."""
    noisy = matrix(
        unit_noise(name.replace("-", "_"), ONE), lambda x: _rounded(Fraction(x)) * index**2
    )
    return StateSpace(transition(ONE, 3), noisy, ROW, ((ONE,),))


def _rounded(value: Fraction) -> Fraction:
    """The number that 60 digits of the oracle's noise stand for."""
    return value.limit_denominator(10**6)


def three_positions(name: str, index: Fraction) -> Matrix:
    """The covariance after three positions, by normal equations of all three."""
    unknown = scale(Fraction(10) ** 70, identity(3, ONE))
    moves = [move(name.replace("-", "_"), ONE, index**2)] * 2
    return last_covariance(unknown, moves, [True] * 3, ROW, ONE)
