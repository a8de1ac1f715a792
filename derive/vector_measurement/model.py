"""The kinematic model with position and velocity measured, up to its process noise."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.model import Model, Ratio
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity, Unit

POSITION_DEVIATION = Quantity(
    "position_deviation", r"\sigma_o", "standard deviation of the measured position", METRE
)
VELOCITY_DEVIATION = Quantity(
    "velocity_deviation", r"\sigma_d", "standard deviation of the measured velocity", METRE / SECOND
)
VELOCITY_RATIO = Quantity(
    "velocity_ratio", "S", "velocity deviation over position deviation, times T", Unit()
)


def measured_model(
    name: str, title: str, process_noise: sp.ImmutableDenseMatrix, strength: Quantity
) -> Model:
    """Position and velocity, both measured, with variances sigma_o^2 and sigma_d^2."""
    step = SAMPLING_INTERVAL.symbol
    return Model(
        name=name,
        title=title,
        transition=sp.ImmutableDenseMatrix([[1, step], [0, 1]]),
        process_noise=process_noise,
        measurement=sp.ImmutableDenseMatrix([[1, 0], [0, 1]]),
        measurement_noise=sp.ImmutableDenseMatrix(
            [[POSITION_DEVIATION.symbol**2, 0], [0, VELOCITY_DEVIATION.symbol**2]]
        ),
        quantities=(SAMPLING_INTERVAL, POSITION_DEVIATION, VELOCITY_DEVIATION, strength),
        state_units=(METRE, METRE / SECOND),
        measurement_units=(METRE, METRE / SECOND),
        deviation=POSITION_DEVIATION,
        ratios=(Ratio(VELOCITY_RATIO, VELOCITY_DEVIATION),),
    )
