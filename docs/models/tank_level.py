"""The level of a tank that is moved by what flows in and out, nobody knows when: one state."""

import sympy as sp

from gainproof.derive.model import Model
from gainproof.derive.quantity import MEASUREMENT_DEVIATION, METRE, SAMPLING_INTERVAL, Quantity

FLOW = Quantity("flow", "w", "deviation of the level's change between samples", METRE)
sigma_v, w = MEASUREMENT_DEVIATION.symbol, FLOW.symbol

MODEL = Model(
    name="tank-level",
    title="The level of a tank",
    transition=sp.ImmutableDenseMatrix([[1]]),
    process_noise=sp.ImmutableDenseMatrix([[w**2]]),
    measurement=sp.ImmutableDenseMatrix([[1]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, FLOW),
    state_units=(METRE,),
)
