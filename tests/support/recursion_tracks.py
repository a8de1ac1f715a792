"""Tracks with unequal intervals and missed detections, run by kernels and by oracles.

The process noises are those of ``oracles.noise``, from their physical description.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from gainproof.verify.oracles import noise
from gainproof.verify.oracles.matrices import Matrix, identity, matrix, product, scale, transpose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.trajectory import Move

NOISES = ("random_velocity", "random_acceleration", "continuous_white_acceleration")


@cache
def unit_noise(name: str, interval: Fraction, states: int = 2) -> Matrix:
    """The covariance of one unit of a noise over an interval, as fractions good to 60 digits."""
    a, b = noise.chain(states)
    described: Mapping[str, Callable[[], Matrix]] = {
        "random_velocity": lambda: noise.increment(b),
        "random_acceleration": lambda: noise.held(a, b, interval, 60),
        "continuous_white_acceleration": lambda: noise.white(a, b, interval, 60),
    }
    return matrix(described[name](), lambda x: x if isinstance(x, Fraction) else fraction(x))


def transition(interval: Fraction, states: int = 2) -> Matrix:
    """exp(A t) of a chain of integrators."""
    a, _ = noise.chain(states)
    return matrix(noise.transition(a, interval, 60), fraction)


def move(name: str, interval: Fraction, strength: Fraction) -> Move:
    """One interval for the batch: a noise through one shape has one disturbance."""
    whole = unit_noise(name, interval)
    if name == "continuous_white_acceleration":
        return Move(transition(interval), identity(2, Fraction(1)), scale(strength, whole))
    last = whole[1][1]
    shape = tuple((row[1] / last,) for row in whole)
    return Move(transition(interval), shape, ((strength * last,),))


def noise_of(step: Move) -> Matrix:
    """G W G'."""
    return product(step.shape, step.disturbance, transpose(step.shape))


@dataclass(frozen=True)
class Sheared:
    """d1, u and d2 of a covariance."""

    values: tuple[Fraction, ...]

    @classmethod
    def of(cls, p: Matrix) -> Sheared:
        determinant = p[0][0] * p[1][1] - p[0][1] ** 2
        return cls((determinant / p[1][1], p[0][1] / p[1][1], p[1][1]))


def entries(factors: Sequence[Any]) -> Matrix:
    """The covariance of factors, exactly."""
    first, shear, last = map(Fraction, factors)
    cross = shear * last
    return ((first + shear * cross, cross), (cross, last))
