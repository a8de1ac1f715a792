"""Converted measurements from Gauss-Hermite sums over the noises, in balls.

Independent because no characteristic function is written down: a place is a range times cosines and
sines of angles, noise is added to each, and every mean is a sum over nodes of a normal variable.
Where noises are independent the mean of a product of a function of each is the product of means;
`correlated` sums over both noises at once. What is known given the measurement
has the noise taken off instead of added. Means over places that are themselves means are sums
within sums.

The sum of n nodes errs, of a cosine of k noises with deviation s, near n!/(2 n)! (k s)^(2 n): with
40 nodes below 1e-22 for two noises of 2 radians, 1e-46 for two of 1 radian. Ranges enter with their
squares at most, for which 3 nodes are exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import flint

from gainproof.verify.oracles import polar_enclosure
from gainproof.verify.oracles.noisy_directions import (
    ZERO,
    Ball,
    Matrix,
    Noise,
    Number,
    Vector,
    balls,
    direction_of,
    nested,
    noises_of,
    place_of_means,
    products,
    turned,
)

BITS = 1000
NODES = 40


@dataclass(frozen=True)
class Moments:
    """Mean and covariance of x, y, z."""

    mean: Vector
    covariance: Matrix


def given_truth(truth: Sequence[Number], deviations: Sequence[Number]) -> Moments:
    """Of the converted measurement of a target at this range, elevation, azimuth."""
    with flint.ctx.workprec(BITS):
        r, e, a = balls(truth)
        return _moments(r, direction_of(e), direction_of(a), noises_of(deviations, NODES), 1)


def given_measurement(measured: Sequence[Number], deviations: Sequence[Number]) -> Moments:
    """Of the place of the target that was measured at this range, elevation, azimuth."""
    with flint.ctx.workprec(BITS):
        r, e, a = balls(measured)
        return _moments(r, direction_of(e), direction_of(a), noises_of(deviations, NODES), -1)


def averaged(measured: Sequence[Number], deviations: Sequence[Number]) -> Moments:
    """Means, given the measurement, of what is true given the truth: of the bias of the converted
    measurement, and of its covariance.
    """
    with flint.ctx.workprec(BITS):
        r, e, a = balls(measured)
        noises = noises_of(deviations, NODES)
        range_, elevation, azimuth = noises
        squares = sum((w * (r - n) ** 2 for n, w in range_), ZERO)
        both = squares + sum((w * n * n for n, w in range_), ZERO)
        up = nested(direction_of(e), elevation)
        around = nested(direction_of(a), azimuth)
        raw, shrunk = (
            products(square, one, other)
            for square, one, other in (
                (both, up.raw, around.raw),
                (squares, up.of_means, around.of_means),
            )
        )
        covariance = [
            [p - q for p, q in zip(*rows, strict=True)] for rows in zip(raw, shrunk, strict=True)
        ]
        bias = [
            p - q
            for p, q in zip(
                place_of_means(r, up.of_means, around.of_means),
                place_of_means(r, up.mean, around.mean),
                strict=True,
            )
        ]
        return Moments(bias, covariance)


def first_order(measured: Sequence[Number], deviations: Sequence[Number]) -> Moments:
    """The measured place, and the covariance to first order, from differences."""
    with flint.ctx.workprec(polar_enclosure.BITS):
        at, sizes = balls(measured), balls(deviations)
        rows = polar_enclosure.slopes(_plain, at)
        covariance = [
            [
                sum((p * q * s * s for p, q, s in zip(one, two, sizes, strict=True)), ZERO)
                for two in rows
            ]
            for one in rows
        ]
        return Moments(_plain(*at), covariance)


def correlated(
    at: Sequence[Number],
    deviations: Sequence[Number],
    correlation: Number,
    sign: int,
    count: int = NODES,
) -> Moments:
    """Of x and y at this range and azimuth with noise of both added (`sign` 1) or taken off (-1);
    `correlation` is that of the two noises. A sum over all nodes of both.
    """
    with flint.ctx.workprec(BITS):
        r, a, sr, sa, rho = balls([*at, *deviations, correlation])
        left = (1 - rho * rho).sqrt()
        means, squares = [ZERO] * 2, [ZERO] * 3
        for n, w in polar_enclosure.nodes(count):
            distance = r + sign * sr * n
            for m, v in polar_enclosure.nodes(count):
                around = direction_of(a + sign * sa * (rho * n + left * m))
                x, y = distance * around.real, distance * around.imag
                weight = w * v
                means = [t + weight * q for t, q in zip(means, (x, y), strict=True)]
                pairs = (x * x, x * y, y * y)
                squares = [t + weight * q for t, q in zip(squares, pairs, strict=True)]
        (x, y), (xx, xy, yy) = means, squares
        return Moments(means, [[xx - x * x, xy - x * y], [xy - x * y, yy - y * y]])


def _moments(r: Ball, e: flint.acb, a: flint.acb, noises: list[Noise], sign: int) -> Moments:
    range_, elevation, azimuth = noises
    up, around = turned(e, elevation, sign), turned(a, azimuth, sign)
    square = sum((w * (r + sign * n) ** 2 for n, w in range_), ZERO)
    means = place_of_means(r, up, around)
    raw = products(square, up, around)
    return Moments(
        means,
        [[raw[i][j] - means[i] * means[j] for j in range(3)] for i in range(3)],
    )


def correlated_in_space(
    at: Sequence[Number],
    deviations: Sequence[Number],
    correlations: Sequence[Number],
    count: int = NODES,
) -> Moments:
    """Of the converted measurement of a target at azimuth 0 and this range and elevation, whose
    noise of the range has these correlations with those of elevation and azimuth, independent.
    """
    with flint.ctx.workprec(BITS):
        r, e, sr, se, sa, up, around = balls([*at, *deviations, *correlations])
        left = (1 - up * up - around * around).sqrt()
        means, products_ = [ZERO] * 3, [[ZERO] * 3 for _ in range(3)]
        turns = [(k, u, direction_of(sa * k)) for k, u in polar_enclosure.nodes(count)]
        for m, v in polar_enclosure.nodes(count):
            rising = direction_of(e + se * m)
            for k, u, turn in turns:
                for n, w in polar_enclosure.nodes(3):
                    distance = r + sr * (up * m + around * k + left * n)
                    level, weight = distance * rising.real, u * v * w
                    place = [level * turn.real, level * turn.imag, distance * rising.imag]
                    for i, value in enumerate(place):
                        means[i] += weight * value
                        for j in range(3):
                            products_[i][j] += weight * value * place[j]
        covariance = [[products_[i][j] - means[i] * means[j] for j in range(3)] for i in range(3)]
        return Moments(means, covariance)


def place_of(polar_place: Vector) -> Vector:
    """x, y, z."""
    return _plain(*polar_place)


def _plain(r: Number, e: Number, a: Number) -> Vector:
    distance, *angles = balls([r, e, a])
    up, around = map(direction_of, angles)
    level = distance * up.real
    return [level * around.real, level * around.imag, distance * up.imag]
