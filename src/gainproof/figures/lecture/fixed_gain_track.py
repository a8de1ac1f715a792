"""Tracks of alpha-beta filters, each coordinate by itself, with gains of their own at each sample.

The steps are a kernel's, with the interval as unit of time; the gains come from kernels or from the
lecture.
"""

from __future__ import annotations

import numpy as np

from gainproof.generated import filter_step, least_squares_line
from gainproof.plots.table import Reals


def followed(measured: Reals, alpha: Reals, beta: Reals) -> tuple[Reals, Reals]:
    """The smoothed positions, and the smoothed velocities times the interval.

    ``measured`` has the samples along its first axis, of any number of tracks and coordinates;
    ``alpha`` and ``beta`` have one gain a sample. The filter starts at the first measurement with
    no velocity: its gains of sample 0 are not used. ValueError where lengths differ.
    """
    if not len(measured) == len(alpha) == len(beta):
        raise ValueError(
            f"needs a gain for each of {len(measured)} samples, got {len(alpha)} and {len(beta)}"
        )
    position, velocity = np.empty_like(measured), np.zeros_like(measured)
    position[0] = measured[0]
    for k in range(1, len(measured)):
        position[k], velocity[k] = filter_step.step_two_states(
            position[k - 1], velocity[k - 1], 1.0, measured[k], alpha[k], beta[k]
        )
    return position, velocity


def handed_over(alpha: float, beta: float, samples: int) -> tuple[Reals, Reals]:
    """The gains of the line through all samples, until its position gain falls below ``alpha``;
    from there on the fixed pair. The lecture: least squares is for the start of a track.
    """
    line = least_squares_line.gains(np.arange(1.0, samples))
    young = np.concatenate([[True], np.asarray(line.alpha) >= alpha])
    first, second = (np.concatenate([[1.0], np.asarray(gain)]) for gain in line)
    return np.where(young, first, alpha), np.where(young, second, beta)
