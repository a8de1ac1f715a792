"""A sled on a slack line: drag slows it, the pull fades, gusts shake it; numbers."""

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
PULL = Quantity("pull", "w", "deviation of the pull's increment", METRE / SECOND**2)
w = PULL.symbol

MODEL = Model(
    name="towed-sled",
    title="Damped motion under a pull that fades",
    transition=sp.ImmutableDenseMatrix(
        [
            [1, sp.Rational(9, 10) * T, sp.Rational(2, 5) * T**2],
            [0, sp.Rational(4, 5), sp.Rational(9, 10) * T],
            [0, 0, sp.Rational(1, 2)],
        ]
    ),
    process_noise=w**2
    * sp.ImmutableDenseMatrix(
        [[0, 0, 0], [0, T**2 / 5, T / 10], [0, T / 10, 1]],
    ),
    measurement=sp.ImmutableDenseMatrix([[1, 0, 0]]),
    measurement_noise=sp.ImmutableDenseMatrix([[sigma_v**2]]),
    quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, PULL),
    state_units=(METRE, METRE / SECOND, METRE / SECOND**2),
)
