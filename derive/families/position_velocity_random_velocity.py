"""Position and velocity measured, an independent velocity increment at every sample."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.quantity import METRE, SECOND, Quantity
from gainproof.derive.source import RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.position_velocity import derive_position_velocity

NAME = "position-velocity-random-velocity"
TITLE = "Position and velocity measured, random velocity (velocity random walk)"

STRENGTH = Quantity(
    "increment_deviation",
    r"\sigma_w",
    "standard deviation of the velocity increment between two samples",
    METRE / SECOND,
)


def build() -> Subject:
    """Derive the family."""
    noise = sp.ImmutableDenseMatrix([[0, 0], [0, STRENGTH.symbol**2]])
    model = measured_model(NAME, TITLE, noise, STRENGTH)
    return derive_position_velocity(model, (SPECTRAL.key, RICCATI.key))
