"""Filters before and beside their steady state: arrays of tracks, sample by sample.

`predict`, `update` and `step` carry covariances over any intervals, `gain_sequence` whole tracks;
`samples_to_steady_gains` says when the steady gains will do, `hand_over_sample` and `gain_schedule`
how long least squares does. `gainproof.time_varying.three_states` has the same for position,
velocity and acceleration. The numbers come from the printed kernels; NumPy is all that is imported.
"""

from gainproof.time_varying.covariance import Factors, covariance_of, factors_of
from gainproof.time_varying.hand_over import GainSchedule, gain_schedule, hand_over_sample
from gainproof.time_varying.process_noise import PROCESS_NOISES
from gainproof.time_varying.schedule_variance import ScheduleVariance, schedule_variance
from gainproof.time_varying.sequence import GainSequence, gain_sequence
from gainproof.time_varying.settling import error_ratio, samples_to_steady_gains
from gainproof.time_varying.track import Step, predict, start, step, update

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
    "update",
]
