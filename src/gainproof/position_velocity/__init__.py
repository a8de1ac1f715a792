"""Position and velocity measured: the steady state in physical units, and the way back.

`steady_state` gives covariances and gains for a filter in metres and seconds; `velocity_ratio_for`
and `velocity_deviation_for` the velocity accuracy that a wanted position accuracy needs. The
numbers come from the printed kernels; NumPy is all that is imported.
"""

from gainproof.position_velocity.inverse import velocity_ratio_for
from gainproof.position_velocity.needed_deviation import velocity_deviation_for
from gainproof.position_velocity.process_noise import PROCESS_NOISES
from gainproof.position_velocity.steady_state import SteadyState, steady_state

__all__ = [
    "PROCESS_NOISES",
    "SteadyState",
    "steady_state",
    "velocity_deviation_for",
    "velocity_ratio_for",
]
