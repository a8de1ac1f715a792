"""Continuous white jerk noise, integrated over each interval."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.families.kinematic_acceleration import position_velocity_acceleration_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import KALATA, RICCATI, SPECTRAL
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import derive_three_state

NAME = "continuous-white-jerk"
TITLE = "Continuous white jerk"

STRENGTH = Quantity(
    "jerk_density",
    r"\tilde q",
    "two-sided power density of the jerk noise",
    METRE**2 / SECOND ** Fraction(5),
)


def build() -> Subject:
    """Derive the family; the noise is the integral of exp(A t) B B' exp(A t)' over one interval."""
    step, density = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time**2 / 2], [time], [1]])
    noise = (density * response * response.T).applyfunc(
        lambda entry: sp.integrate(entry, (time, 0, step))
    )
    model = position_velocity_acceleration_model(
        NAME, TITLE, sp.ImmutableDenseMatrix(noise), STRENGTH
    )
    return derive_three_state(model, (KALATA.key, SPECTRAL.key, RICCATI.key))
