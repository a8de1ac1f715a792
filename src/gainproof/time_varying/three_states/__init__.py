"""Filters of position, velocity and acceleration before and beside their steady state.

What `gainproof.time_varying` has for two states, under the same names: `predict`, `update` and
`step` over any intervals, `gain_sequence` for whole tracks, `samples_to_steady_gains`,
`hand_over_sample` and `gain_schedule`. The numbers come from the printed kernels; NumPy is all that
is imported.
"""

from gainproof.time_varying.three_states.covariance import (
    Factors,
    covariance_of,
    factors_of,
    uncorrelated,
)
from gainproof.time_varying.three_states.hand_over import (
    GainSchedule,
    gain_schedule,
    hand_over_sample,
)
from gainproof.time_varying.three_states.process_noise import PROCESS_NOISES
from gainproof.time_varying.three_states.schedule_variance import (
    ScheduleVariance,
    schedule_variance,
)
from gainproof.time_varying.three_states.sequence import GainSequence, gain_sequence
from gainproof.time_varying.three_states.settling import error_ratio, samples_to_steady_gains
from gainproof.time_varying.three_states.track import Step, predict, start, step, update

__all__ = [
    "PROCESS_NOISES",
    "Factors",
    "GainSchedule",
    "GainSequence",
    "ScheduleVariance",
    "Step",
    "covariance_of",
    "error_ratio",
    "factors_of",
    "gain_schedule",
    "gain_sequence",
    "hand_over_sample",
    "predict",
    "samples_to_steady_gains",
    "schedule_variance",
    "start",
    "step",
    "uncorrelated",
    "update",
]
