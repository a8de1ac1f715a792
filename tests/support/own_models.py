"""Models of a user's own as tests write them: position-like state measured, numbers in F and Q."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from gainproof.derive.model import Model, Parameter
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
    Unit,
)

T, DEVIATION = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
SHAKE = Quantity("shake", "w", "strength of the noise", METRE)
Rows = Sequence[Sequence[Any]]


def free_number(name: str, *, below_one: bool = False, **options: str) -> Parameter:
    """A parameter of that name."""
    return Parameter(Quantity(name, name, f"number {name}", Unit()), below_one, **options)


def own_model(transition: Rows, noise: Rows, /, **changes: Any) -> Model:
    """A model given by its matrices in units T = 1, its states a length and its rates."""
    size = len(transition)
    units = [METRE / SECOND**power for power in range(size)]
    scale = sp.diag(*(T**-power for power in range(size)))
    fields: dict[str, Any] = {
        "name": "trial",
        "title": "Trial",
        "transition": sp.ImmutableDenseMatrix(scale * sp.Matrix(transition) * scale.inv()),
        "process_noise": sp.ImmutableDenseMatrix(
            SHAKE.symbol**2 * scale * sp.Matrix(noise) * scale
        ),
        "measurement": sp.ImmutableDenseMatrix([[1] + [0] * (size - 1)]),
        "measurement_noise": sp.ImmutableDenseMatrix([[DEVIATION**2]]),
        "quantities": (SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
        "state_units": tuple(units),
    }
    return Model(**{**fields, **changes})
