"""Acceleration constant over each interval, independent between intervals (RA filter)."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.model import Model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import KALATA, LECTURE, RICCATI, SPECTRAL
from gainproof.derive.steady_state.two_state import derive_two_state
from gainproof.derive.subject import Subject

NAME = "random-acceleration"
TITLE = "Random acceleration (constant over each interval)"

STRENGTH = Quantity(
    "acceleration_deviation",
    r"\sigma_w",
    "standard deviation of the acceleration, constant over each interval",
    METRE / SECOND**2,
)


def model() -> Model:
    """Position and velocity with this noise."""
    step, sigma = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    shape = sp.ImmutableDenseMatrix([[step**2 / 2], [step]])
    noise = sp.ImmutableDenseMatrix(sigma**2 * shape * shape.T)
    return position_velocity_model(NAME, TITLE, noise, STRENGTH)


def build() -> Subject:
    """Derive the family."""
    return derive_two_state(model(), (LECTURE.key, KALATA.key, SPECTRAL.key, RICCATI.key))
