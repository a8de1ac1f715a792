"""Velocity noise and a platform that itself drifts: random velocity plus position increments."""

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
DRIFT = Quantity("drift", "r", "variance of the position's increment over (w T)^2", Unit())
w, r = SHAKE.symbol, DRIFT.symbol

MODEL = Model(
    name="drifting-platform",
    title="Random velocity on a drifting platform",
    transition=sp.ImmutableDenseMatrix([[1, T], [0, 1]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix([[r * T**2, 0], [0, 1]]),
    measurement=sp.ImmutableDenseMatrix([[1, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND),
    parameters=(Parameter(DRIFT),),
)
