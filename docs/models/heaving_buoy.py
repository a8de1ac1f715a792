"""A buoy that heaves: an undamped swing whose angle in one interval has the cosine 24/25."""

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
cosine, sine = sp.Rational(24, 25), sp.Rational(7, 25)

MODEL = Model(
    name="heaving-buoy",
    title="Heave of a buoy, an undamped oscillation",
    transition=sp.ImmutableDenseMatrix([[cosine, sine * T], [-sine / T, cosine]]),
    process_noise=w**2 * sp.ImmutableDenseMatrix([[0, 0], [0, 1]]),
    measurement=sp.ImmutableDenseMatrix([[1, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE),
    state_units=(METRE, METRE / SECOND),
)
