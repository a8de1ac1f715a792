"""Ratios of two steps over boxes, tight where natural interval division is not."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.corners import extremes
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.step_ranges import Value, none_as_zero, sum_of


def ratio(a: Value, b: Value, width: Array) -> Interval:
    """|a|/|b| over boxes of the given width, under every possible rounding.

    Along an axis where the slopes differ by one sign the ratio is monotone and an end suffices;
    else it moves away from either end by no more than the largest difference of slopes allows.
    """
    low, high = _exact(a, b, width)
    wide = (1.0 + sum_of(a.drift, b.drift)) * interval.SLACK
    low, high = low / wide, high * wide
    if a.stray is not None or b.stray is not None:
        low, high = _astray(a, b, (low, high), wide)
    return interval.down_or_zero(low), interval.up_or_infinite(high)


def _exact(a: Value, b: Value, width: Array) -> Interval:
    least = np.nextafter(a.slope[0] - b.slope[1], -np.inf)
    most = np.nextafter(a.slope[1] - b.slope[0], np.inf)
    return extremes(interval.divide(a.size, b.size), (least, most), width)


def _astray(a: Value, b: Value, tight: Interval, wide: float) -> Interval:
    """(a +- lost)/(b +- lost), from the tight a/b with b at its least, and from the ranges."""
    lost_a, lost_b = none_as_zero(a.stray) * wide, none_as_zero(b.stray) * wide
    lost = (lost_a > 0) | (lost_b > 0)
    least_b = b.size[0][0] / wide
    above, below = least_b + lost_b, np.fmax(least_b - lost_b, 0.0)
    most_b = b.size[1][0] * wide + lost_b
    plain_low = np.fmax(a.size[0][0] / wide - lost_a, 0.0) / most_b / wide
    plain_high = (a.size[1][0] * wide + lost_a) / below * wide
    tight_low = tight[0] * (least_b / above) - lost_a / above * wide
    tight_high = tight[1] * (least_b / below) + lost_a / below * wide
    return (
        np.where(lost, np.fmax(tight_low / wide, plain_low), tight[0]),
        np.where(lost, np.fmin(tight_high * wide, plain_high), tight[1]),
    )
