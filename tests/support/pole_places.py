"""Where the poles of the filter with position and velocity measured turn real, from the model.

The innovation spectrum det((zI - F) R (I/z - F)' + Q)/det R is s c(z) c(1/z) with the closed-loop
polynomial c (cited: spectral factorisation). It is a quadratic in v = 2 - z - 1/z, and as z and 1/z
give one v, two poles meet off the unit circle exactly where two of its roots v do: where its
discriminant vanishes. Its coefficients come here from determinants at z = 1 and z = -1 over
rational numbers, and the discriminant by interpolation, since it is a quadratic in 1/S^2: no
formula of a derivation is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import flint

Noise = Sequence[Sequence[Fraction]]


def turning_places(noise: Noise, index: Fraction) -> tuple[flint.arb, flint.arb]:
    """The two values of 1/S^2 at which two poles meet, the larger first; one may be negative."""
    at = [_discriminant(noise, index, Fraction(n)) for n in (1, 2, 3)]
    second = (at[2] - 2 * at[1] + at[0]) / 2
    first = at[1] - at[0] - 3 * second
    constant = at[0] - first - second
    assert constant + 4 * first + 16 * second == _discriminant(noise, index, Fraction(4))
    middle = ball(-first / (2 * second))
    half = ball((first * first - 4 * second * constant) / (4 * second * second)).sqrt()
    return middle + half, middle - half


def _discriminant(noise: Noise, index: Fraction, inverse_square: Fraction) -> Fraction:
    """Of the quadratic in v, at an exact S."""
    constant = _spectrum(noise, index, inverse_square, 1)
    linear = (_spectrum(noise, index, inverse_square, -1) - constant - 16) / 4
    return linear * linear - 4 * constant


def _spectrum(noise: Noise, index: Fraction, inverse_square: Fraction, z: int) -> Fraction:
    """det((zI - F) R (I/z - F)' + Q)/det R for z = 1 or -1, F = [[1, 1], [0, 1]]."""
    square = 1 / inverse_square
    forward = ((Fraction(z - 1), Fraction(-1)), (Fraction(0), Fraction(z - 1)))
    r = (Fraction(1), square)
    entries = [
        [
            sum((forward[i][k] * r[k] * forward[j][k] for k in range(2)), Fraction(0))
            + index * index * noise[i][j]
            for j in range(2)
        ]
        for i in range(2)
    ]
    return (entries[0][0] * entries[1][1] - entries[0][1] * entries[1][0]) / square


def ball(number: Fraction) -> flint.arb:
    """The ball of an exact number."""
    return flint.arb(flint.fmpq(number.numerator, number.denominator))
