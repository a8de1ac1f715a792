"""Block 101 of the source's figure 1: measured range and bearing turned into coordinates."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from gainproof.generated import polar_coordinates
from gainproof.tracking.arrays import Reals
from gainproof.tracking.measured import Measured, Polar


def _classical(polar: Polar) -> tuple[Reals, ...]:
    """x, y and the covariance to first order."""
    east, north = polar_coordinates.to_cartesian_in_plane(polar.range, polar.bearing)
    noise = polar_coordinates.noise_covariance_in_plane(
        polar.range, polar.bearing, polar.range_deviation, polar.bearing_deviation
    )
    return tuple(np.asarray(each, np.float64) for each in (east, north, *noise))


CONVERSIONS: Mapping[str, Callable[[Polar], tuple[Reals, ...]]] = {
    "classical": _classical,
}
DEFAULT = "classical"


def converted(polar: Polar, conversion: str = DEFAULT) -> Measured:
    """The measurements as coordinates, each with the covariance of its noise.

    Raises ValueError for a conversion there is not, for what is outside a kernel's domain, and
    where a covariance is none (not positive definite), with the place.
    """
    if conversion not in CONVERSIONS:
        known = ", ".join(CONVERSIONS)
        raise ValueError(f"conversion is one of {known}, got {conversion!r}")
    if not polar.range.size:
        shape = polar.range.shape
        return Measured(np.zeros((*shape, 2)), np.zeros((*shape, 2, 2)), polar)
    east, north, xx, xy, yy = CONVERSIONS[conversion](polar)
    covariance = np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], -2)
    fine = (xx > 0) & (yy > 0) & (xx * yy - xy * xy > 0)
    if not fine.all():
        worst = int(np.argmin(fine))
        degrees = float(np.rad2deg(polar.bearing_deviation.flat[worst]))
        raise NoCovarianceError(
            f"the {conversion} conversion gives no covariance (none that is positive definite) "
            f"where the bearing's deviation is {degrees:.4g} degrees",
            worst,
        )
    return Measured(np.stack([east, north], -1), covariance, polar)


class NoCovarianceError(ValueError):
    """A conversion's covariance is none; `place` is the index of the first such measurement."""

    def __init__(self, message: str, place: int) -> None:
        super().__init__(message)
        self.place = place
