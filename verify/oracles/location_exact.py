"""Weighted least squares of ranges and range rates, exact in fractions at rational distances.

Independent because nothing is whitened, scaled, projected or factorised and no printed derivative
enters: ranges and range rates are taken as rational functions of a displacement e, whose part of
first order is computed with dual numbers over Python's fractions, biases are ordinary columns, and
the normal equations, which no program in floats should form, are solved exactly. The square root of
a distance is taken in integers and has to be exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from gainproof.verify.oracles.matrices import (
    Matrix,
    Vector,
    identity,
    matrix,
    product,
    solve,
    transpose,
)

Row = tuple[Fraction, ...]


@dataclass(frozen=True)
class Dual:
    """a + b e with e^2 = 0."""

    value: Fraction
    slope: Fraction

    def __add__(self, other: Dual) -> Dual:
        return Dual(self.value + other.value, self.slope + other.slope)

    def __sub__(self, other: Dual) -> Dual:
        return Dual(self.value - other.value, self.slope - other.slope)

    def __mul__(self, other: Dual) -> Dual:
        slope = self.value * other.slope + self.slope * other.value
        return Dual(self.value * other.value, slope)

    def __truediv__(self, other: Dual) -> Dual:
        ratio = self.value / other.value
        return Dual(ratio, (self.slope - ratio * other.slope) / other.value)

    def root(self) -> Dual:
        """ValueError where the root is not rational."""
        found = rational_root(self.value)
        return Dual(found, self.slope / (2 * found))


@dataclass(frozen=True)
class Fit:
    """Least squares: how far to go from the place of linearisation, and the covariance of it."""

    step: Vector
    covariance: Matrix


def rational_root(square: Fraction) -> Fraction:
    """ValueError where there is none."""
    top, bottom = isqrt(square.numerator), isqrt(square.denominator)
    if top * top != square.numerator or bottom * bottom != square.denominator:
        raise ValueError(f"{square} is no square of a fraction")
    return Fraction(top, bottom)


def observed(station: Row, state: Sequence[Dual], is_rate: bool) -> Dual:
    """Range or range rate; station and state are position and then velocity."""
    d = len(station) // 2
    fixed = [Dual(part, Fraction(0)) for part in station]
    apart = [here - there for here, there in zip(state, fixed, strict=True)]
    total = _sum([part * part for part in apart[:d]])
    if not is_rate:
        return total.root()
    return _sum([p * v for p, v in zip(apart[:d], apart[d:], strict=True)]) / total.root()


def values(stations: Sequence[Row], state: Row, rows: Sequence[tuple[int, bool]]) -> Vector:
    """What (station, whether it is the rate) observe of the target without noise."""
    still = [Dual(part, Fraction(0)) for part in state]
    return tuple(observed(stations[i], still, is_rate).value for i, is_rate in rows)


def fit(
    stations: Sequence[Row],
    state: Row,
    rows: Sequence[tuple[int, bool]],
    unknowns: int,
    biases: Sequence[Row],
    covariance: Matrix,
    residual: Row,
) -> Fit:
    """The linear model at the state, in its first `unknowns` and in columns of biases."""
    columns = []
    for place in range(unknowns):
        moved = [Dual(part, Fraction(int(i == place))) for i, part in enumerate(state)]
        columns.append([observed(stations[i], moved, is_rate).slope for i, is_rate in rows])
    design = transpose(matrix([*columns, *biases]))
    weight = transpose(solve(covariance, design))
    spread = solve(product(weight, design), identity(len(design[0]), Fraction(1)))
    step = product(product(spread, weight), matrix([[part] for part in residual]))
    return Fit(tuple(row[0] for row in step), spread)


def _sum(parts: Sequence[Dual]) -> Dual:
    total = Dual(Fraction(0), Fraction(0))
    for part in parts:
        total += part
    return total
