"""Polar coordinates from turns in complex planes, differences and quadrature, in balls.

Independent because nothing of the map is written down: a place is one step north, turned upwards
and then to the right by multiplication with exp(i angle), first in the plane of north and up, then
in that of north and east; range and angles come back as moduli and arguments of complex numbers.
Derivatives are central differences of these, rates are differences along the path of a target, the
mean of a converted measurement is a sum over Gauss-Hermite nodes.

With 2800 bits and steps of 2^-500 of the arguments' size first and second differences are good to
more than 60 digits, also where the arguments' sizes are 10^50 apart: the error of a step is 2^-1000
and that of rounding 2^-1800 of the largest number that occurs. Gauss-Hermite sums of n nodes are
exact for polynomials of degree 2 n - 1: of a cosine with deviation s the error is near
n!/(2 n)! s^(2 n), for 40 nodes and two radians 10^-47.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

import flint

BITS = 2800
STEP = 500
NODES = 40

Ball = flint.arb
Number = float | Fraction | Ball
Vector = list[Ball]


def place(distance: Number, elevation: Number, bearing: Number) -> Vector:
    """x east, y north, z up of what is seen at that range, elevation and bearing."""
    with flint.ctx.workprec(BITS):
        upright = _turn(_ball(elevation)) * _ball(distance)
        level = _turn(_ball(bearing)) * upright.real
        return [level.imag, level.real, upright.imag]


def polar(x: Number, y: Number, z: Number) -> Vector:
    """Range, elevation and bearing of a place: moduli and arguments."""
    with flint.ctx.workprec(BITS):
        level = flint.acb(_ball(y), _ball(x))
        upright = flint.acb(abs(level), _ball(z))
        return [abs(upright), upright.arg(), level.arg()]


def slopes(function: Callable[..., Vector], at: Sequence[Number]) -> list[Vector]:
    """The derivatives of a function of several numbers: a row for each of its values."""
    with flint.ctx.workprec(BITS):
        point = [_ball(value) for value in at]
        columns = []
        for number, value in enumerate(point):
            step = _step(value)
            ends = []
            for sign in (1, -1):
                moved = list(point)
                moved[number] = value + sign * step
                ends.append(function(*moved))
            columns.append([(a - b) / (2 * step) for a, b in zip(*ends, strict=True)])
        return [list(row) for row in zip(*columns, strict=True)]


def polar_slopes(at: Sequence[Number]) -> list[Vector]:
    """The derivatives of range, elevation and bearing by the place, in the south too."""
    with flint.ctx.workprec(BITS):
        here = polar(*at)[2]

        def going_on(x: Number, y: Number, z: Number) -> Vector:
            distance, elevation, bearing = polar(x, y, z)
            return [distance, elevation, _near(bearing, here)]

        return slopes(going_on, at)


def covariance(at: Sequence[Number], deviations: Sequence[Number]) -> list[Vector]:
    """Of the place to first order, from independent deviations of range, elevation and bearing."""
    with flint.ctx.workprec(BITS):
        rows = slopes(place, at)
        sizes = [_ball(each) ** 2 for each in deviations]
        return [
            [
                sum((a * b * s for a, b, s in zip(one, other, sizes, strict=True)), _ball(0))
                for other in rows
            ]
            for one in rows
        ]


def rates(at: Sequence[Number], velocity: Sequence[Number]) -> tuple[Vector, Vector]:
    """First and second derivatives by time of range, elevation, bearing at a constant velocity.

    The place must not lie on the vertical axis.
    """
    with flint.ctx.workprec(BITS):
        start, moving = ([_ball(value) for value in each] for each in (at, velocity))
        speed = sum((abs(value) for value in moving), _ball(0))
        if speed == 0:
            return [_ball(0)] * 3, [_ball(0)] * 3
        step = _step(abs(flint.acb(start[0], start[1])) / speed)
        before, now, after = (
            polar(*(p + turn * step * v for p, v in zip(start, moving, strict=True)))
            for turn in (-1, 0, 1)
        )
        triples = list(zip(before, now, after, strict=True))
        # a path that crosses the south goes on turning
        triples[2] = (_near(before[2], now[2]), now[2], _near(after[2], now[2]))
        first = [(c - a) / (2 * step) for a, _, c in triples]
        second = [(a - 2 * b + c) / step**2 for a, b, c in triples]
        return first, second


def mean_place(at: Sequence[Number], deviations: Sequence[Number]) -> Vector:
    """The mean of the converted place under Gaussian noise of elevation and bearing.

    The turns are independent and act one after the other, linearly: so do their means.
    """
    with flint.ctx.workprec(BITS):
        distance, elevation, bearing = (_ball(value) for value in at)
        upright = _mean_turn(elevation, _ball(deviations[0])) * distance
        level = _mean_turn(bearing, _ball(deviations[1])) * upright.real
        return [level.imag, level.real, upright.imag]


@cache
def nodes(count: int) -> tuple[tuple[Ball, Ball], ...]:
    """Nodes and weights for means over the standard normal distribution.

    Nodes are zeros of a Hermite polynomial; the weight of each is one over the sum of the squares
    of the orthonormal polynomials there.
    """
    with flint.ctx.workprec(BITS):
        found = []
        for node in _zeros(count):
            before, value, total = _ball(0), _ball(1), _ball(1)
            for k in range(1, count):
                following = (node * value - _ball(k - 1).sqrt() * before) / _ball(k).sqrt()
                before, value = value, following
                total += value * value
            found.append((node, 1 / total))
        return tuple(found)


def _zeros(count: int) -> Vector:
    """Zeros of He_n by its recurrence, He_(n+1) = x He_n - n He_(n-1); all are real."""
    before, value = flint.fmpz_poly([0]), flint.fmpz_poly([1])
    for k in range(count):
        before, value = value, flint.fmpz_poly([0, 1]) * value - k * before
    pairs: Any = value.complex_roots()  # zeros with how often they occur
    return [zero.real for zero, _ in pairs]


def _turn(angle: Ball) -> flint.acb:
    return flint.acb(0, angle).exp()


def _mean_turn(angle: Ball, deviation: Ball) -> flint.acb:
    turns = (_turn(angle + node * deviation) * weight for node, weight in nodes(NODES))
    return sum(turns, flint.acb(0))


def _near(angle: Ball, other: Ball) -> Ball:
    """The same angle, within half a turn of another."""
    turns = round(float(((angle - other) / (2 * Ball.pi())).mid()))
    return angle - 2 * Ball.pi() * turns


def _step(value: Ball) -> Ball:
    size = abs(value) if value != 0 else _ball(1)
    return Ball(size.mid()) * _ball(2) ** -STEP


def _ball(value: Number | int) -> Ball:
    if isinstance(value, Fraction):
        return Ball(flint.fmpq(value.numerator, value.denominator))
    return Ball(value)
