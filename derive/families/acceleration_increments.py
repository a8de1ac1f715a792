"""Acceleration increments: an independent jump of the acceleration at every sample."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.families.kinematic_acceleration import position_velocity_acceleration_model
from gainproof.derive.model import Model
from gainproof.derive.quantity import METRE, SECOND, Quantity
from gainproof.derive.source import KALATA, RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import derive_three_state

NAME = "acceleration-increments"
TITLE = "Acceleration increments (acceleration random walk)"

STRENGTH = Quantity(
    "increment_deviation",
    r"\sigma_w",
    "standard deviation of the acceleration increment between two samples",
    METRE / SECOND**2,
)


def model() -> Model:
    """The model; the jump comes after the state has moved."""
    noise = sp.ImmutableDenseMatrix(sp.diag(0, 0, STRENGTH.symbol**2))
    return position_velocity_acceleration_model(NAME, TITLE, noise, STRENGTH)


def build() -> Subject:
    """Derive the family."""
    return derive_three_state(model(), (KALATA.key, SPECTRAL.key, RICCATI.key))
