"""The kinematic model of position, velocity and acceleration, up to its process noise."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.model import Model
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
)


def position_velocity_acceleration_model(
    name: str, title: str, process_noise: sp.ImmutableDenseMatrix, strength: Quantity
) -> Model:
    """Position, velocity and acceleration, position measured with variance sigma_v^2."""
    step, deviation = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
    return Model(
        name=name,
        title=title,
        transition=sp.ImmutableDenseMatrix([[1, step, step**2 / 2], [0, 1, step], [0, 0, 1]]),
        process_noise=process_noise,
        measurement=sp.ImmutableDenseMatrix([[1, 0, 0]]),
        measurement_noise=sp.ImmutableDenseMatrix([[deviation**2]]),
        quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, strength),
        state_units=(METRE, METRE / SECOND, METRE / SECOND**2),
    )
