"""Velocity random walk: an independent velocity increment at every sample (RV filter)."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.quantity import METRE, SECOND, Quantity
from gainproof.derive.source import KALATA, LECTURE, RICCATI, SPECTRAL
from gainproof.derive.steady_state.two_state import derive_two_state
from gainproof.derive.subject import Subject

NAME = "random-velocity"
TITLE = "Random velocity (velocity random walk)"

STRENGTH = Quantity(
    "velocity_deviation",
    r"\sigma_w",
    "standard deviation of the velocity increment between two samples",
    METRE / SECOND,
)


def build() -> Subject:
    """Derive the family."""
    sigma = STRENGTH.symbol
    noise = sp.ImmutableDenseMatrix([[0, 0], [0, sigma**2]])
    model = position_velocity_model(NAME, TITLE, noise, STRENGTH)
    return derive_two_state(model, (LECTURE.key, KALATA.key, SPECTRAL.key, RICCATI.key))
