"""Random jerk: constant over each interval, independent between intervals."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.families.kinematic_acceleration import position_velocity_acceleration_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import KALATA, RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import derive_three_state

NAME = "random-jerk"
TITLE = "Random jerk (constant over each interval)"

STRENGTH = Quantity(
    "jerk_deviation",
    r"\sigma_j",
    "standard deviation of the jerk, constant over each interval",
    METRE / SECOND**3,
)


def build() -> Subject:
    """Derive the family."""
    step, sigma = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    shape = sp.ImmutableDenseMatrix([[step**3 / 6], [step**2 / 2], [step]])
    noise = sp.ImmutableDenseMatrix(sigma**2 * shape * shape.T)
    model = position_velocity_acceleration_model(NAME, TITLE, noise, STRENGTH)
    return derive_three_state(model, (KALATA.key, SPECTRAL.key, RICCATI.key))
