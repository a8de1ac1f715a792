"""Batch least squares over the whole track, exact in fractions.

Independent because it fits one polynomial to all samples at once by the normal equations; no
recursion and no printed gain enters. The accuracy rests on Python's fractions: every number is
exact.

Samples are taken at times 0, 1, ..., k (unit interval), with equal weight. A fit of degree d is
described by its value and its first d derivatives at the time of the newest sample, k.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import factorial

from gainproof.verify.oracles.matrices import (
    Matrix,
    Vector,
    identity,
    matrix,
    product,
    solve,
    transpose,
)
from gainproof.verify.oracles.state_space import exact


def weights(degree: int, newest: int) -> Matrix:
    """The (degree + 1) x (newest + 1) matrix that turns samples into value and derivatives at k.

    Row i gives the i-th derivative (per unit interval) at the time of the newest sample.
    Raises ValueError when there are too few samples for the degree.
    """
    _require_samples(degree, newest)
    design = tuple(
        tuple(Fraction(j - newest) ** i / factorial(i) for i in range(degree + 1))
        for j in range(newest + 1)
    )
    normal = product(transpose(design), design)
    return solve(normal, transpose(design))


def fit(degree: int, samples: Sequence[object]) -> Vector:
    """Value and first ``degree`` derivatives, at the newest sample, of the best polynomial."""
    column = tuple((exact(sample),) for sample in samples)
    return tuple(row[0] for row in product(weights(degree, len(samples) - 1), column))


def gains(degree: int, newest: int) -> Vector:
    """The weights of the newest innovation in the fit at sample ``newest``.

    The prediction from older samples does not contain the newest one, so the weight of the
    innovation (newest sample minus its prediction) is the weight of that sample itself. Its row
    of the design is (1, 0, ...), so the weights are the first column of the covariance.
    """
    return tuple(row[0] for row in covariance(degree, newest))


def covariance(degree: int, newest: int) -> Matrix:
    """The covariance of value and derivatives at k, for samples of variance one.

    The inverse of the normal matrix, whose entries are sums of powers of 0, 1, ..., k; works for
    any sample number, however large.
    """
    _require_samples(degree, newest)
    normal = tuple(
        tuple(
            (-1) ** (i + j) * power_sum(i + j, newest) / (factorial(i) * factorial(j))
            for j in range(degree + 1)
        )
        for i in range(degree + 1)
    )
    return solve(normal, identity(degree + 1, Fraction(1)))


def power_sum(power: int, last: int) -> Fraction:
    """0^power + 1^power + ... + last^power, exactly."""
    total = Fraction(0)
    for coefficient in reversed(_power_sum_polynomial(power)):
        total = total * last + coefficient
    return total


@cache
def _power_sum_polynomial(power: int) -> Vector:
    """Coefficients, from low to high, of the sum as a polynomial in its last term's number.

    It has degree ``power + 1`` and is interpolated from as many plain sums.
    """
    numbers = range(power + 2)
    sums = tuple((Fraction(sum(j**power for j in range(last + 1))),) for last in numbers)
    powers = tuple(tuple(Fraction(last) ** i for i in numbers) for last in numbers)
    return tuple(row[0] for row in solve(powers, sums))


def taylor(degree: int) -> Matrix:
    """The matrix that carries value and derivatives one interval ahead."""
    return tuple(
        tuple(Fraction(1, factorial(j - i)) if j >= i else Fraction(0) for j in range(degree + 1))
        for i in range(degree + 1)
    )


def run(
    gain_at: Callable[[int], Sequence[object]],
    samples: Sequence[object],
    first: int,
    start: Sequence[object],
) -> tuple[Vector, ...]:
    """The states of x = F x + K_k (z_k - H F x), exactly, from given gains and a given start.

    ``start`` is the state (value, derivatives) after sample ``first - 1``; samples ``first`` to
    the last are then worked in with the gains ``gain_at(k)``. The state after each is returned.
    """
    state = tuple(exact(x) for x in start)
    ahead = taylor(len(state) - 1)
    states = []
    for k in range(first, len(samples)):
        predicted = tuple(row[0] for row in product(ahead, matrix([[x] for x in state])))
        innovation = exact(samples[k]) - predicted[0]
        state = tuple(x + exact(g) * innovation for x, g in zip(predicted, gain_at(k), strict=True))
        states.append(state)
    return tuple(states)


def _require_samples(degree: int, newest: int) -> None:
    if degree < 0 or newest < degree:
        raise ValueError(
            f"a fit of degree {degree} needs degree >= 0 and a newest sample number >= degree, "
            f"got {newest}"
        )
