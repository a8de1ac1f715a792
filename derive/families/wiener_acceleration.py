"""Discrete Wiener process acceleration: increments that act all through the next interval."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.families import acceleration_increments
from gainproof.derive.families.kinematic_acceleration import position_velocity_acceleration_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import KALATA, RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import derive_three_state

NAME = "wiener-acceleration"
TITLE = "Discrete Wiener process acceleration"

STRENGTH = Quantity(
    "increment_deviation",
    r"\sigma_w",
    "standard deviation of the acceleration increment between two samples",
    METRE / SECOND**2,
)


def build() -> Subject:
    """Derive the family; the jump comes before the state moves: its column is (T^2/2, T, 1)."""
    step, sigma = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    shape = sp.ImmutableDenseMatrix([[step**2 / 2], [step], [1]])
    noise = sp.ImmutableDenseMatrix(sigma**2 * shape * shape.T)
    model = position_velocity_acceleration_model(NAME, TITLE, noise, STRENGTH)
    return derive_three_state(
        model, (KALATA.key, SPECTRAL.key, RICCATI.key), acceleration_increments.model()
    )
