"""Continuous white acceleration noise, integrated over each interval."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import KALATA, RICCATI, SPECTRAL
from gainproof.derive.steady_state.two_state import derive_two_state
from gainproof.derive.subject import Subject

NAME = "continuous-white-acceleration"
TITLE = "Continuous white acceleration"

STRENGTH = Quantity(
    "acceleration_density",
    r"\tilde q",
    "two-sided power density of the acceleration noise",
    METRE**2 / SECOND ** Fraction(3),
)


def build() -> Subject:
    """Derive the family; the noise is the integral of exp(A t) B B' exp(A t)' over one interval."""
    step, density = SAMPLING_INTERVAL.symbol, STRENGTH.symbol
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time], [1]])
    noise = (density * response * response.T).applyfunc(
        lambda entry: sp.integrate(entry, (time, 0, step))
    )
    model = position_velocity_model(NAME, TITLE, sp.ImmutableDenseMatrix(noise), STRENGTH)
    return derive_two_state(model, (KALATA.key, SPECTRAL.key, RICCATI.key))
