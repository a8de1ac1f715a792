"""Acceleration constant over each half of an interval: a kinematic model of one's own."""

import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity

T = SAMPLING_INTERVAL.symbol
SHAKE = Quantity("shake", "w", "deviation of the velocity's change", METRE / SECOND)
# of an acceleration with the deviation a over each half, w^2 = a^2 T^2/2
noise = SHAKE.symbol**2 * sp.ImmutableDenseMatrix([[5 * T**2 / 16, T / 2], [T / 2, 1]])
MODEL = position_velocity_model("half-intervals", "Acceleration over half intervals", noise, SHAKE)
