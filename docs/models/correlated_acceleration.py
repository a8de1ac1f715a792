"""A manoeuvre that fades, after Singer: exponentially correlated acceleration."""

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
SHAKE = Quantity("shake", "w", "deviation of the acceleration's increment", METRE / SECOND**2)
CORRELATION = Quantity("correlation", r"\rho", "correlation of successive accelerations", Unit())
w, rho = SHAKE.symbol, CORRELATION.symbol

MODEL = Model(
    name="correlated-acceleration",
    title="Exponentially correlated acceleration",
    transition=sp.ImmutableDenseMatrix([[1, T, T**2 / 2], [0, 1, T], [0, 0, rho]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix(sp.diag(0, 0, 1)),
    measurement=sp.ImmutableDenseMatrix([[1, 0, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND, METRE / SECOND**2),
    parameters=(Parameter(CORRELATION, below_one=True),),
)
