"""Process noises over an interval of any length: how each enters, derived from what it is.

A noise is F's own kind of matrix: its covariance over an interval t is S diag(floor, velocity) S'
with the shear S = [1, n t; 0, 1]. The numbers are read off the covariance, which is integrated
where the noise is continuous and a square where it acts through one shape.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.expression import real

T, Q = real("t"), real("q")


class NoiseError(ValueError):
    """A process noise that is not of this kind."""


@dataclass(frozen=True)
class Noise:
    """A process noise of position and velocity, of strength q over an interval t.

    covariance: its matrix in t and q. share: n. power: the velocity's variance is q t^power.
    floor: the position's variance, given the velocity, over q t^3. chord: the variance of the mean
    velocity over the interval less that at its end, over q t^power. continuous: whether it acts all
    through the interval. meaning: of q, with its unit.
    """

    name: str
    words: str
    meaning: str
    covariance: sp.ImmutableDenseMatrix
    continuous: bool
    share: Fraction
    power: int
    floor: Fraction
    chord: Fraction

    def velocity(self, strength: Any, interval: Any) -> Any:
        """Variance that the velocity gains."""
        if self.power == 0:
            return strength
        return strength * (interval if self.power == 1 else interval * interval)

    def position(self, strength: Any, interval: Any) -> Any:
        """Variance that the position gains where the velocity's gain is known; None for zero."""
        if not self.floor:
            return None
        cube = interval * (interval * interval)
        return (strength * cube) * self.floor.numerator / self.floor.denominator


def through(name: str, words: str, meaning: str, shape: sp.ImmutableDenseMatrix) -> Noise:
    """One independent number for each interval, entering through a shape (position, velocity)."""
    return _read(name, words, meaning, sp.ImmutableDenseMatrix(Q * shape * shape.T), False)


def continuous(name: str, words: str, meaning: str) -> Noise:
    """White acceleration: what enters at each instant is carried to the interval's end by F."""
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time], [1]])
    squares = (Q * response * response.T).applyfunc(lambda x: sp.integrate(x, (time, 0, T)))
    return _read(name, words, meaning, sp.ImmutableDenseMatrix(squares), True)


def _read(
    name: str, words: str, meaning: str, covariance: sp.ImmutableDenseMatrix, continuous: bool
) -> Noise:
    velocity = covariance[1, 1]
    share = sp.simplify(covariance[0, 1] / (velocity * T))
    floor = sp.simplify((covariance[0, 0] - covariance[0, 1] ** 2 / velocity) / (Q * T**3))
    power = sp.degree(velocity, T)
    chord = (covariance[0, 0] / T**2 - 2 * covariance[0, 1] / T + velocity) / (Q * T**power)
    chord = sp.simplify(chord)
    numbers = all(x.is_Rational for x in (share, floor, chord))
    plain = numbers and sp.expand(velocity - Q * T**power) == 0
    if not plain or share not in (0, sp.Rational(1, 2)):
        raise NoiseError(
            f"process noise {name}: no shear of 0 or half the interval in {covariance}"
        )
    return Noise(
        name,
        words,
        meaning,
        covariance,
        continuous,
        Fraction(str(share)),
        int(power),
        Fraction(str(floor)),
        Fraction(str(chord)),
    )


def noises() -> tuple[Noise, ...]:
    """The process noises of the two-state families of the catalogue."""
    return (
        through(
            "random_velocity",
            "an independent increment of the velocity at each sample, of variance `q`",
            "variance of the velocity increment, the same for an interval of any length",
            sp.ImmutableDenseMatrix([[0], [1]]),
        ),
        through(
            "random_acceleration",
            "an acceleration that is constant over the interval, of variance `q`, independent "
            "between intervals",
            "variance of the acceleration, which is constant over the interval",
            sp.ImmutableDenseMatrix([[T**2 / 2], [T]]),
        ),
        continuous(
            "continuous_white_acceleration",
            "white acceleration of density `q`, all through the interval",
            "two-sided power density of the acceleration",
        ),
    )
