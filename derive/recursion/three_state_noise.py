"""Process noises of position, velocity and acceleration over an interval of any length."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.recursion.noise import NoiseError, Q, T


@dataclass(frozen=True)
class TripleNoise:
    """A process noise of strength q over an interval t, V diag(g1, g2, g3) V' with unit upper V.

    covariance: its matrix in t and q. shears: the entries 12, 23 and 13 of V over t, t and t^2.
    power: the acceleration's variance is g3 = q t^power. second, first: g2/(g3 t^2), g1/(g3 t^4).
    continuous: whether it acts all through the interval.
    """

    name: str
    words: str
    meaning: str
    covariance: sp.ImmutableDenseMatrix
    continuous: bool
    shears: tuple[sp.Rational, sp.Rational, sp.Rational]
    power: int
    second: sp.Rational
    first: sp.Rational


def through(name: str, words: str, meaning: str, shape: sp.ImmutableDenseMatrix) -> TripleNoise:
    """One independent number for each interval, through a shape."""
    return _read(name, words, meaning, sp.ImmutableDenseMatrix(Q * shape * shape.T), False)


def continuous(name: str, words: str, meaning: str) -> TripleNoise:
    """White jerk: what enters at each instant is carried to the interval's end by F."""
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time**2 / 2], [time], [1]])
    squares = (Q * response * response.T).applyfunc(lambda x: sp.integrate(x, (time, 0, T)))
    return _read(name, words, meaning, sp.ImmutableDenseMatrix(squares), True)


def _read(
    name: str, words: str, meaning: str, covariance: sp.ImmutableDenseMatrix, continuous: bool
) -> TripleNoise:
    last = covariance[2, 2]
    power = int(sp.degree(last, T))
    if sp.expand(last - Q * T**power) != 0:
        raise NoiseError(f"process noise {name}: the acceleration's variance {last} is no q t^n")
    v13, v23 = (sp.simplify(covariance[i, 2] / last) for i in (0, 1))
    g2 = sp.simplify(covariance[1, 1] - v23**2 * last)
    c12 = sp.simplify(covariance[0, 1] - v13 * v23 * last)
    v12 = sp.simplify(c12 / g2) if g2 != 0 else sp.Integer(0)
    g1 = sp.simplify(covariance[0, 0] - v13**2 * last - v12**2 * g2)
    parts = (v12 / T, v23 / T, v13 / T**2, g2 / (last * T**2), g1 / (last * T**4))
    numbers = [sp.simplify(part) for part in parts]
    if not all(x.is_Rational and x >= 0 for x in numbers):
        raise NoiseError(f"process noise {name}: the factors {numbers} are no numbers above zero")
    v12, v23, v13, second, first = numbers
    return TripleNoise(
        name, words, meaning, covariance, continuous, (v12, v23, v13), power, second, first
    )


def triple_noises() -> tuple[TripleNoise, ...]:
    """The process noises of the three-state families."""
    return (
        through(
            "acceleration_increments",
            "an independent increment of the acceleration at each sample, of variance `q`",
            "variance of the acceleration increment, the same for an interval of any length",
            sp.ImmutableDenseMatrix([[0], [0], [1]]),
        ),
        through(
            "wiener_acceleration",
            "an acceleration that acts over the interval and stays, of variance `q`: through "
            "`[t^2/2; t; 1]`",
            "variance of the acceleration that is added for the interval and stays",
            sp.ImmutableDenseMatrix([[T**2 / 2], [T], [1]]),
        ),
        through(
            "random_jerk",
            "a jerk that is constant over the interval, of variance `q`, independent between "
            "intervals",
            "variance of the jerk, which is constant over the interval",
            sp.ImmutableDenseMatrix([[T**3 / 6], [T**2 / 2], [T]]),
        ),
        continuous(
            "continuous_white_jerk",
            "white jerk of density `q`, all through the interval",
            "two-sided power density of the jerk",
        ),
    )
