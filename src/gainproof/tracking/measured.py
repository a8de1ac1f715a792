"""What a radar measured, as it came and as coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.tracking.arrays import Reals
from gainproof.tracking.rows import Rows


@dataclass(frozen=True)
class Polar(Rows):
    """Ranges (m, above 0) and bearings (rad, from north, clockwise), each with the deviation of its
    noise: arrays of one shape.
    """

    range: Reals
    bearing: Reals
    range_deviation: Reals
    bearing_deviation: Reals


@dataclass(frozen=True)
class Measured(Rows):
    """Converted measurements. position: (..., 2), m, east and north of the radar; covariance:
    (..., 2, 2), m^2; sight: (..., 2), m^2, the variances along the measured line of sight and
    across it, where the covariance is diagonal; polar: what they were converted from.
    """

    position: Reals
    covariance: Reals
    sight: Reals
    polar: Polar

    @property
    def variances(self) -> Reals:
        """(..., 2): of both coordinates."""
        return np.asarray(np.diagonal(self.covariance, axis1=-2, axis2=-1))
