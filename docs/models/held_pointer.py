"""A pointer held by a damped spring: both the position and the velocity are pulled back."""

import sympy as sp

from gainproof.derive.model import Model
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
)

T, sigma_v = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
SHAKE = Quantity("shake", "w", "deviation of the velocity's increment", METRE / SECOND)
w = SHAKE.symbol
pull, keep = sp.Rational(1, 4), sp.Rational(4, 5)

MODEL = Model(
    name="held-pointer",
    title="A pointer on a damped spring",
    transition=sp.ImmutableDenseMatrix([[sp.Rational(9, 10), T / 2], [-pull / T, keep]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix([[0, 0], [0, 1]]),
    measurement=sp.ImmutableDenseMatrix([[1, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND),
)
