"""Block 101 of the source's figure 1: measured range and bearing turned into coordinates."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np

from gainproof.generated import converted_measurements
from gainproof.tracking.arrays import Reals
from gainproof.tracking.measured import Measured, Polar

Conversion: TypeAlias = Callable[[Reals, Reals, Reals, Reals], tuple[Any, ...]]
CONVERSIONS: Mapping[str, Conversion] = {
    "modified-unbiased": converted_measurements.modified_unbiased_conversion_in_plane,
    "unbiased": converted_measurements.unbiased_conversion_in_plane,
    "debiased": converted_measurements.debiased_conversion_in_plane,
    "classical": converted_measurements.classical_conversion_in_plane,
}
"""Those that the source names, its own first; all printed by converted-measurements."""
DEFAULT = "modified-unbiased"
MOST_RATIO = 1e13
"""Of the variances along the line of sight and across it: the larger one's last digits in x and y
are a five-hundredth of the smaller; further apart nothing of that is left.
"""


def converted(polar: Polar, conversion: str = DEFAULT) -> Measured:
    """The measurements as coordinates, each with the covariance of its noise.

    Raises ValueError for a conversion there is not, for what is outside a kernel's domain, and,
    with the place, where a covariance is none (not positive definite) or its variances are
    further than `MOST_RATIO` apart.
    """
    if conversion not in CONVERSIONS:
        known = ", ".join(CONVERSIONS)
        raise ValueError(f"conversion is one of {known}, got {conversion!r}")
    if not polar.range.size:
        shape = polar.range.shape
        nothing = np.zeros((*shape, 2))
        return Measured(nothing, np.zeros((*shape, 2, 2)), nothing, polar)
    # the kernels count the angle from x towards y: their x is north and their y is east
    told = CONVERSIONS[conversion](
        polar.range, polar.bearing, polar.range_deviation, polar.bearing_deviation
    )
    north, east, yy, xy, xx, along, across = (np.asarray(each, np.float64) for each in told)
    covariance = np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], -2)
    # along the line of sight and across it the covariance is diagonal
    finite = np.isfinite(along) & np.isfinite(across)
    fine = finite & (along > 0) & (across > 0)
    if not fine.all():
        worst = int(np.argmin(fine))
        degrees = float(np.rad2deg(polar.bearing_deviation.flat[worst]))
        raise NoCovarianceError(
            f"the {conversion} conversion gives no covariance (none that is positive definite) "
            f"where the bearing's deviation is {degrees:.4g} degrees",
            worst,
        )
    apart = np.maximum(along, across) > MOST_RATIO * np.minimum(along, across)
    if apart.any():
        worst = int(np.argmax(apart))
        raise NoCovarianceError(
            "variances along the line of sight and across it are wanted that are at most "
            f"{MOST_RATIO:g} times apart, got {along.flat[worst]:.3g} and "
            f"{across.flat[worst]:.3g} m^2 ({conversion} conversion)",
            worst,
        )
    return Measured(np.stack([east, north], -1), covariance, np.stack([along, across], -1), polar)


class NoCovarianceError(ValueError):
    """A covariance is none, or none that float64 can hold: of the conversion of a measurement or,
    where `field` is empty, of an estimate after it; `place` is the index of the first such one.
    """

    def __init__(self, message: str, place: int, field: str = "sigma_bearing") -> None:
        super().__init__(message)
        self.place, self.field = place, field
