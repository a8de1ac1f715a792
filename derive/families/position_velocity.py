"""Position and velocity measured, acceleration noise acting all through each interval."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import RICCATI, SPECTRAL, SUZUKI
from gainproof.derive.subject import Subject
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.position_velocity import Printed, derive_position_velocity
from gainproof.derive.vector_measurement.source_symbols import (
    REMARKS,
    source_elements,
    source_slots,
)

NAME = "position-velocity"
TITLE = "Position and velocity measured, continuous white acceleration"

STRENGTH = Quantity(
    "acceleration_deviation",
    r"\sigma_a",
    "standard deviation of the acceleration noise, averaged over one interval",
    METRE / SECOND**2,
)


def build() -> Subject:
    """Derive the family; noise of density sigma_a^2 T, integrated over one interval, is (7)."""
    step, density = SAMPLING_INTERVAL.symbol, STRENGTH.symbol**2 * SAMPLING_INTERVAL.symbol
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time], [1]])
    noise = (density * response * response.T).applyfunc(
        lambda entry: sp.integrate(entry, (time, 0, step))
    )
    model = measured_model(NAME, TITLE, sp.ImmutableDenseMatrix(noise), STRENGTH)
    printed = Printed(source_elements, source_slots, REMARKS)
    return derive_position_velocity(model, (SUZUKI.key, SPECTRAL.key, RICCATI.key), printed)
