"""A velocity that fades: exponentially correlated, rho = exp(-T/tau) from sample to sample."""

import sympy as sp

from gainproof.derive.model import Model, Parameter
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
    Unit,
)

T, sigma_v = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
SHAKE = Quantity("shake", "w", "deviation of the velocity's increment", METRE / SECOND)
CORRELATION = Quantity("correlation", r"\rho", "correlation of successive velocities", Unit())
w, rho = SHAKE.symbol, CORRELATION.symbol

MODEL = Model(
    name="correlated-velocity",
    title="Exponentially correlated velocity",
    transition=sp.ImmutableDenseMatrix([[1, (1 - rho) * T], [0, rho]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix([[0, 0], [0, 1]]),
    measurement=sp.ImmutableDenseMatrix([[1, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND),
    parameters=(Parameter(CORRELATION, below_one=True),),
)
