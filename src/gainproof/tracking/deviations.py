"""Deviations of estimates: variances above 0, or an error that names the detection."""

from __future__ import annotations

import numpy as np

from gainproof.tracking.arrays import Ints, Reals
from gainproof.tracking.conversion import NoCovarianceError
from gainproof.tracking.motion import Estimate

NAMES = (("x", "m"), ("the velocity along x", "m/s"), ("y", "m"), ("the velocity along y", "m/s"))


def deviations(after: Estimate, detection: Ints) -> Reals:
    """(n, 4) of estimates after the detections of one scan, whose places are `detection`, (n,).

    Raises NoCovarianceError where a variance is not above 0, or a number is not finite: rounding
    took more digits than there are.
    """
    variances = np.diagonal(after.covariance, axis1=1, axis2=2)
    sound = (variances > 0) & np.isfinite(variances) & np.isfinite(after.state)
    if not sound.all():
        row, which = np.unravel_index(int(np.argmin(sound)), sound.shape)
        name, unit = NAMES[int(which)]
        raise NoCovarianceError(
            f"the variance of {name} after this detection is to be above 0 and finite, got "
            f"{variances[row, which]:.3g} ({unit})^2 at {after.state[row, which]:.6g} {unit}: "
            "deviations, intervals and --acceleration are further apart than float64 has digits",
            int(detection[row]),
            field="",
        )
    return np.sqrt(variances)
