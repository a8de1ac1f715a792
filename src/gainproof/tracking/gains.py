"""Block 104: the gains of a tracking filter, for arrays of tracks.

All are matrices (..., 4, 2) for states (x, vx, y, vy): what an innovation (x, y) adds. Those of the
alpha-beta filters are gains of the steady state at a tracking index Lambda_i = sigma_w T^2 /
sqrt(R_i), i = x, y (18), T the time since the last update.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gainproof.generated import least_squares_line, random_acceleration, updated_gains
from gainproof.tracking.arrays import Bools, Ints, Reals
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import POSITION, VELOCITY, inverse
from gainproof.tracking.rows import Rows


@dataclass(frozen=True)
class Point(Rows):
    """A tracking index of x and of y with the gains there: arrays (..., 2). At the nominal point
    they are the fixed gains; the recursive update keeps one for every track.
    """

    index: Reals
    alpha: Reals
    beta: Reals


@dataclass(frozen=True)
class Sample:
    """All that a filter may ask for: the measurement, the time since the last update (s), sigma_w
    (m/s^2), the predicted covariance, the nominal point, the point of the last update, and how many
    detections the track had before (at least 2).
    """

    seen: Measured
    interval: Reals
    acceleration: float
    covariance: Reals
    nominal: Point
    last: Point
    number: Ints

    @property
    def index(self) -> Reals:
        """(18)."""
        return tracking_index(self.acceleration, self.interval[..., None], self.seen.variances)


def tracking_index(acceleration: float, interval: Reals | float, variance: Reals) -> Reals:
    """(5)."""
    (found,) = updated_gains.tracking_index(acceleration, interval, variance)
    return np.asarray(found, np.float64)


def exact_point(index: Reals) -> Point:
    """The gains (6), (7) of the index."""
    alpha, beta = random_acceleration.gains(index)
    return Point(index, np.asarray(alpha, np.float64), np.asarray(beta, np.float64))


def constant_point(nominal: Point, index: Reals) -> Point:
    """To first order from the nominal point, (28) to (30) with (32), (33)."""
    alpha, beta = updated_gains.first_order_gains(nominal.index, index)
    return Point(index, np.asarray(alpha, np.float64), np.asarray(beta, np.float64))


def recursive_point(last: Point, index: Reals) -> Point:
    """To first order from the point of the last update, (26), (27)."""
    found = updated_gains.recursive_gains(last.alpha, last.beta, last.index, index)
    alpha, beta = (np.asarray(each, np.float64) for each in found)
    return Point(index, alpha, beta)


def young(point: Point, number: Ints) -> Point:
    """The gains of the least-squares line as long as its alpha is not below that of the point: two
    positions are its beginning, and what they say of the velocity is soon improved.
    """
    line = least_squares_line.gains(number.astype(np.float64)[..., None])
    first = np.asarray(line.alpha) >= point.alpha
    alpha = np.where(first, line.alpha, point.alpha)
    return Point(point.index, alpha, np.where(first, line.beta, point.beta))


def is_usable(point: Point) -> Bools:
    """Where a filter with these gains is stable (alpha and beta above 0, 2 alpha + beta below 4)
    with alpha at most 1, as no smoothed position lies beyond the measured one.
    """
    alpha, beta = point.alpha, point.beta
    return np.asarray((alpha > 0) & (alpha <= 1) & (beta > 0) & (2 * alpha + beta < 4))


def limited(point: Point) -> tuple[Point, int]:
    """The exact gains where those of a first-order update are not usable, and in how many tracks
    that is so.
    """
    usable = is_usable(point)
    if usable.all():
        return point, 0
    exact = exact_point(point.index)
    alpha = np.where(usable, point.alpha, exact.alpha)
    beta = np.where(usable, point.beta, exact.beta)
    return Point(point.index, alpha, beta), int(np.count_nonzero(~usable.all(-1)))


def decoupled(point: Point, interval: Reals) -> Reals:
    """(31): x and y apart."""
    found = np.zeros((*point.alpha.shape[:-1], 4, 2))
    for axis in (0, 1):
        found[..., 2 * axis, axis] = point.alpha[..., axis]
        found[..., 2 * axis + 1, axis] = point.beta[..., axis] / interval
    return found


def line_of_sight(seen: Measured, interval: Reals, acceleration: float, number: Ints) -> Reals:
    """(9): gains of their own along the measured line of sight and across it, turned into x, y."""
    point = exact_point(tracking_index(acceleration, interval[..., None], seen.sight))
    point = young(point, number)
    bearing = seen.polar.bearing
    # x is along the line of sight at a bearing of 90 degrees
    cosine, sine = np.sin(bearing), np.cos(bearing)
    found = np.zeros((*point.alpha.shape[:-1], 4, 2))
    for rows, gains in ((POSITION, point.alpha), (VELOCITY, point.beta)):
        xx, xy, yy = updated_gains.line_of_sight_gains(gains[..., 0], gains[..., 1], cosine, sine)
        block = found[..., rows, :]
        block[..., 0, 0], block[..., 1, 1] = xx, yy
        block[..., 0, 1] = block[..., 1, 0] = xy
    found[..., VELOCITY, :] /= interval[..., None, None]
    return found


def kalman(seen: Measured, covariance: Reals) -> Reals:
    """P H' S^-1 with the whole predicted covariance, x and y together."""
    to_position = covariance[..., :, POSITION]
    innovation = to_position[..., POSITION, :] + seen.covariance
    found: Reals = to_position @ inverse(innovation)
    return found


class Gain(NamedTuple):
    """The matrices, the points that the next update may start from, and how many tracks got other
    gains as theirs would not have been stable with alpha at most 1.
    """

    matrix: Reals
    point: Point
    limited: int = 0


def _fixed(sample: Sample) -> Gain:
    shape = sample.seen.position.shape
    alpha, beta = (np.broadcast_to(x, shape) for x in (sample.nominal.alpha, sample.nominal.beta))
    return _of_axes(sample, Point(sample.index, alpha, beta))


def _constant(sample: Sample) -> Gain:
    point, others = limited(constant_point(sample.nominal, sample.index))
    return _of_axes(sample, point)._replace(limited=others)


def _recursive(sample: Sample) -> Gain:
    point, others = limited(recursive_point(sample.last, sample.index))
    return _of_axes(sample, point)._replace(point=point, limited=others)


def _line_of_sight(sample: Sample) -> Gain:
    seen, number = sample.seen, sample.number
    return Gain(line_of_sight(seen, sample.interval, sample.acceleration, number), sample.last)


def _exact(sample: Sample) -> Gain:
    return _of_axes(sample, exact_point(sample.index))


def _of_axes(sample: Sample, point: Point) -> Gain:
    return Gain(decoupled(young(point, sample.number), sample.interval), sample.last)


FILTERS: Mapping[str, Callable[[Sample], Gain]] = {
    "kalman": lambda sample: Gain(kalman(sample.seen, sample.covariance), sample.last),
    "fixed": _fixed,
    "first-order-constant": _constant,
    "first-order-recursive": _recursive,
    "exact": _exact,
    "line-of-sight": _line_of_sight,
}
DEFAULT = "kalman"
