"""Filters with fixed gains: steady covariance by Kronecker product, steady errors by long runs.

Independent because only F, H and K are known. The covariance solves the linear equation
P = A P A' + W, A = F (I - K H), written out entry by entry as (I - A x A) vec P = vec W and solved
in balls of python-flint, so that what is returned encloses the truth. The errors behind a moving
target come from running the filter on noise-free positions until its error stands still; no
equation for them is solved. Least variances are found by the sign of a derivative that solves the
differentiated equation.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import factorial
from typing import Any

import flint
import mpmath

from gainproof.verify.oracles.multiprecision import bits_for, context

Gains = Sequence[flint.arb]


def ball(value: float | Fraction | flint.arb) -> flint.arb:
    """A number as a ball of the working precision."""
    if isinstance(value, flint.arb):
        return value
    if isinstance(value, int):
        return flint.arb(value)
    exact = Fraction(value)
    return flint.arb(flint.fmpq(exact.numerator, exact.denominator))


def transition(size: int) -> flint.arb_mat:
    """F over one interval: x(t + 1) by Taylor."""
    return _matrix(
        [[Fraction(1, factorial(j - i)) if j >= i else 0 for j in range(size)] for i in range(size)]
    )


def closed_loop(gains: Gains) -> flint.arb_mat:
    """F (I - K H) with the first state measured."""
    return transition(len(gains)) * _rest(gains)


def _rest(gains: Gains) -> flint.arb_mat:
    size = len(gains)
    return _matrix(
        [[int(i == j) - (gains[i] if j == 0 else 0) for j in range(size)] for i in range(size)]
    )


def predicted(gains: Gains, noise: flint.arb_mat | None = None) -> flint.arb_mat:
    """Covariance of the prediction for measurement noise 1, and process noise if it is given."""
    column = transition(len(gains)) * _column(gains)
    driven = column * column.transpose()
    return steady(closed_loop(gains), driven if noise is None else driven + noise)


def updated(gains: Gains, noise: flint.arb_mat | None = None) -> flint.arb_mat:
    """The same after the update."""
    rest, column = _rest(gains), _column(gains)
    return rest * predicted(gains, noise) * rest.transpose() + column * column.transpose()


def steady(a: flint.arb_mat, driven: flint.arb_mat) -> flint.arb_mat:
    """P with P = A P A' + W. Raises ZeroDivisionError where the precision does not decide."""
    size = a.nrows()
    whole = _matrix(
        [
            [int((i, j) == (k, m)) - a[i, k] * a[j, m] for k in range(size) for m in range(size)]
            for i in range(size)
            for j in range(size)
        ]
    )
    column = _matrix([[driven[i, j]] for i in range(size) for j in range(size)])
    found = whole.solve(column)
    return _matrix([[found[i * size + j, 0] for j in range(size)] for i in range(size)])


def variance_slope(gains: Gains, place: int) -> flint.arb:
    """The derivative of the predicted position's variance with respect to one gain.

    P' = A P' A' + A' P A~ + ..., the differentiated equation, where A changes by -F e H.
    """
    size = len(gains)
    moving, p = transition(size), predicted(gains)
    a, column = closed_loop(gains), _column(gains)
    unit = moving * _matrix([[int(i == place)] for i in range(size)])
    turned = unit * _matrix([[-int(j == 0) for j in range(size)]])
    driven = turned * p * a.transpose() + unit * (moving * column).transpose()
    return steady(a, driven + driven.transpose())[0, 0]


def _column(gains: Gains) -> flint.arb_mat:
    return _matrix([[gain] for gain in gains])


def _matrix(rows: list[list[Any]]) -> flint.arb_mat:
    return flint.arb_mat([[ball(entry) for entry in row] for row in rows])


def steady_errors(
    gains: Sequence[Fraction], order: int, digits: int = 50, most_samples: int = 20_000
) -> tuple[list[Any], list[Any]]:
    """Truth less prediction, and less update, of each state behind a target at k^p/p!.

    The filter starts from nothing and runs until the errors stand still to that many digits.
    Raises ArithmeticError where they do not within the samples.
    """
    own = context(bits_for(2 * digits))
    numbers = [own.mpf(gain.numerator) / gain.denominator for gain in map(Fraction, gains)]
    last: list[Any] = []
    state = [own.mpf(0)] * len(numbers)
    for k in range(1, most_samples):
        ahead, state, true = _sample(own, numbers, state, order, k)
        errors = [t - x for t, x in zip(true, ahead, strict=True)]
        if last and all(
            abs(x - y) <= own.mpf(10) ** -digits * (abs(x) + own.mpf(10) ** -digits)
            for x, y in zip(errors, last, strict=True)
        ):
            return errors, [t - x for t, x in zip(true, state, strict=True)]
        last = errors
    raise ArithmeticError(f"the errors still move after {most_samples} samples")


def errors_at(gains: Sequence[Fraction], order: int, samples: int, digits: int = 50) -> list[Any]:
    """Truth less prediction after so many samples, where there is no limit."""
    own = context(bits_for(2 * digits))
    numbers = [own.mpf(gain.numerator) / gain.denominator for gain in map(Fraction, gains)]
    state = [own.mpf(0)] * len(numbers)
    ahead, true = state, state
    for k in range(1, samples + 1):
        ahead, state, true = _sample(own, numbers, state, order, k)
    return [t - x for t, x in zip(true, ahead, strict=True)]


def _sample(
    own: Any, gains: list[Any], state: list[Any], order: int, k: int
) -> tuple[list[Any], list[Any], list[Any]]:
    """Prediction, update and truth at sample k."""
    size = len(gains)
    ahead = [sum(state[j] / factorial(j - i) for j in range(i, size)) for i in range(size)]
    true = [
        own.mpf(k) ** (order - n) / factorial(order - n) if order >= n else own.mpf(0)
        for n in range(size)
    ]
    innovation = true[0] - ahead[0]
    return ahead, [x + g * innovation for x, g in zip(ahead, gains, strict=True)], true


def root_moduli(gains: Sequence[float]) -> list[float]:
    """Moduli of the closed loop's eigenvalues, largest first."""
    size = len(gains)
    rows = [
        [
            float(
                sum(
                    Fraction(1, factorial(k - i)) * (int(k == j) - (Fraction(gains[k]) * (j == 0)))
                    for k in range(i, size)
                )
            )
            for j in range(size)
        ]
        for i in range(size)
    ]
    values = mpmath.mp.eig(mpmath.matrix(rows), left=False, right=False)
    return sorted((abs(complex(value)) for value in values), reverse=True)
