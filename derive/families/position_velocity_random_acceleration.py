"""Position and velocity measured, acceleration constant over each interval."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.position_velocity import derive_position_velocity

NAME = "position-velocity-random-acceleration"
TITLE = "Position and velocity measured, random acceleration (constant over each interval)"

STRENGTH = Quantity(
    "acceleration_deviation",
    r"\sigma_w",
    "standard deviation of the acceleration, constant over each interval",
    METRE / SECOND**2,
)


def build() -> Subject:
    """Derive the family."""
    step, sigma = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    shape = sp.ImmutableDenseMatrix([[step**2 / 2], [step]])
    noise = sp.ImmutableDenseMatrix(sigma**2 * shape * shape.T)
    model = measured_model(NAME, TITLE, noise, STRENGTH)
    return derive_position_velocity(model, (SPECTRAL.key, RICCATI.key))
