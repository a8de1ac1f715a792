"""Range, range rate and their derivatives from distances alone, by differences in balls.

Independent because the only formula is Pythagoras' for the distance of two points. A range rate is
a central difference of distances in time, along the motions; a derivative by a coordinate is one of
ranges or of range rates as that coordinate is moved; second derivatives are differences of these,
down to third differences of distances. No unit vector and no inner product is formed.

With 2800 bits and steps of 2^-400 of the distance, and of the time in which it is covered, third
differences are good to more than 60 digits: the error of a step is 2^-800, that of rounding
2^-1600, where coordinates are at most 10^120 times the distance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import flint

BITS = 2800
STEP = 400

Ball = flint.arb
Number = float | Fraction | Ball
Vector = list[Ball]
Function = Callable[[Vector], Ball]


def distance(target: Sequence[Number], station: Sequence[Number]) -> Ball:
    """Of two points."""
    with flint.ctx.workprec(BITS):
        apart = [a - b for a, b in zip(_balls(target), _balls(station), strict=True)]
        # not as powers: of balls that hold 0 python-flint has none
        return sum((each * each for each in apart), Ball(0)).sqrt()


def rate(
    target: Sequence[Number],
    target_velocity: Sequence[Number],
    station: Sequence[Number],
    station_velocity: Sequence[Number],
) -> Ball:
    """How fast the distance of two moving points grows."""
    with flint.ctx.workprec(BITS):
        places = _balls(target), _balls(station)
        moving = _balls(target_velocity), _balls(station_velocity)
        speed = sum((abs(value) for each in moving for value in each), Ball(0))
        if speed == 0:
            return Ball(0)
        step = _size(distance(*places) / speed)

        def after(time: Ball) -> Ball:
            return distance(
                *(
                    [p + time * v for p, v in zip(place, velocity, strict=True)]
                    for place, velocity in zip(places, moving, strict=True)
                )
            )

        return (after(step) - after(-step)) / (2 * step)


def slopes(function: Function, at: Sequence[Number], size: Number) -> Vector:
    """The derivatives of a function by several coordinates; it bends over lengths of this size."""
    return [_slope(function, at, number, size) for number in range(len(at))]


def curvatures(function: Function, at: Sequence[Number], size: Number) -> list[Vector]:
    """The second derivatives by several coordinates."""

    def slope(number: int) -> Function:
        return lambda place: _slope(function, place, number, size)

    return [slopes(slope(number), at, size) for number in range(len(at))]


def _slope(function: Function, at: Sequence[Number], number: int, size: Number) -> Ball:
    with flint.ctx.workprec(BITS):
        point, step = _balls(at), _size(_ball(size))
        ends = []
        for sign in (1, -1):
            moved = list(point)
            moved[number] += sign * step
            ends.append(function(moved))
        return (ends[0] - ends[1]) / (2 * step)


def _size(value: Ball) -> Ball:
    return Ball(abs(value).mid()) * Ball(2) ** -STEP


def _balls(values: Sequence[Number]) -> Vector:
    return [_ball(value) for value in values]


def _ball(value: Number) -> Ball:
    if isinstance(value, Fraction):
        return Ball(flint.fmpq(value.numerator, value.denominator))
    return Ball(value)
