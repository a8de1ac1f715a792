"""Acceleration constant over each half of an interval: a kinematic model of one's own."""

import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity

T = SAMPLING_INTERVAL.symbol
SHAKE = Quantity("shake", "w", "deviation of the acceleration", METRE / SECOND**2)
noise = SHAKE.symbol**2 * sp.ImmutableDenseMatrix([[5 * T**4 / 32, T**3 / 4], [T**3 / 4, T**2 / 2]])
MODEL = position_velocity_model("half-intervals", "Acceleration over half intervals", noise, SHAKE)
