"""One step of the Riccati equation, over any kind of number.

The definition of the steady state, used by several oracles: innovation variance H M H' + R,
gain M H' over it, updated covariance, and the next predicted covariance.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from gainproof.verify.oracles.matrices import (
    Matrix,
    add,
    identity,
    matrix,
    product,
    solve,
    subtract,
    symmetric,
    transpose,
)
from gainproof.verify.oracles.state_space import StateSpace, SteadyState


def in_numbers(model: StateSpace, number: Callable[[Any], Any]) -> StateSpace:
    """The model with every entry converted by ``number``."""
    return StateSpace(
        matrix(model.transition, number),
        matrix(model.process_noise, number),
        matrix(model.measurement, number),
        matrix(model.measurement_noise, number),
    )


def update(model: StateSpace, predicted: Matrix) -> SteadyState:
    """Gain, innovation variance and updated covariance that belong to a predicted covariance.

    The updated covariance is formed as (I - K H) M (I - K H)' + K R K', a sum of two positive
    semidefinite terms, so that a small one is not the difference of two large ones.
    """
    h = model.measurement
    cross = product(predicted, transpose(h))
    innovation = symmetric(add(product(h, cross), model.measurement_noise))
    gain = transpose(solve(innovation, transpose(cross)))
    kept = subtract(identity(model.size, predicted[0][0] * 0 + 1), product(gain, h))
    updated = add(
        product(kept, predicted, transpose(kept)),
        product(gain, model.measurement_noise, transpose(gain)),
    )
    return SteadyState(predicted, symmetric(updated), gain, innovation)


def predict(model: StateSpace, updated: Matrix) -> Matrix:
    """The predicted covariance F X F' + Q."""
    f = model.transition
    return symmetric(add(product(f, updated, transpose(f)), model.process_noise))


def closed_loop(model: StateSpace, gain: Matrix) -> Matrix:
    """The matrix F (I - K H) that carries the prediction error from step to step."""
    f = model.transition
    return subtract(f, product(f, gain, model.measurement))


def residual(model: StateSpace, predicted: Matrix) -> Matrix:
    """F X F' + Q - M, zero where M is the steady state."""
    return subtract(predict(model, update(model, predicted).updated), predicted)
