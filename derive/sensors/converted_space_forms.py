"""Covariances of conversions in space, in forms without cancellation.

Matrices stand in the frame of the bearing: horizontally ahead, across, and up; across is not
correlated with the others. They take anything with + - * /. The noise of the elevation turns in the
vertical plane, where all is as in the plane; that of the azimuth turns what is ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gainproof.derive.sensors import converted_forms as forms
from gainproof.derive.sensors.converted_forms import Axes, Noise


@dataclass(frozen=True)
class Sight:
    """Cosine and sine of the elevation; in the vertical plane the noise that elevation has; of the
    azimuth k = exp(-sigma^2/2), its square L and 1 - L.
    """

    cos: Any
    sin: Any
    rising: Noise
    kept_root: Any
    kept: Any
    lost: Any

    @property
    def whole(self) -> Any:
        """r^2 + sigma_r^2."""
        return self.rising.r * self.rising.r + self.rising.s2


@dataclass(frozen=True)
class Frame:
    """Variances ahead, across and up, and the covariance of ahead and up."""

    ahead: Any
    across: Any
    up: Any
    tilt: Any


def classical(s: Sight, elevation: Any, azimuth: Any) -> Frame:
    """To first order, from the deviations of the angles."""
    rising = s.rising.r * elevation
    crossing = (s.rising.r * s.cos) * azimuth
    ahead, up, tilt = upright(s, (s.rising.s2, rising * rising))
    return Frame(ahead, crossing * crossing, up, tilt)


def upright(s: Sight, axes: Axes) -> tuple[Any, Any, Any]:
    """Variances ahead and up and their covariance, from those along and across the line of sight in
    the vertical plane.
    """
    along, over = axes
    c2, s2 = s.cos * s.cos, s.sin * s.sin
    return c2 * along + s2 * over, s2 * along + c2 * over, (s.cos * s.sin) * (along - over)


def level_square(s: Sight, kept: Any, lost: Any) -> Any:
    """The mean square of the cosine of an elevation of which noise keeps `kept` of the mean cosine
    of its double; `lost` is 1 less that.
    """
    return ((s.cos * s.cos) * (1 + kept) + (s.sin * s.sin) * lost) / 2


def spread(s: Sight) -> Frame:
    """Of the raw conversion given the truth; of the truth given the measurement."""
    square = s.rising.kept * s.rising.kept
    level = s.whole * level_square(s, square, s.rising.lost * (1 + s.rising.kept))
    return _turned(s, upright(s, forms.spread(s.rising)), level)


def _turned(s: Sight, upright: tuple[Any, Any, Any], level: Any) -> Frame:
    """With the azimuth's noise; `level` is the mean square of the distance from the z axis."""
    ahead, up, tilt = upright
    return Frame(
        s.kept * ahead + (s.lost * s.lost) * level / 2,
        level * (s.lost * (1 + s.kept)) / 2,
        up,
        s.kept_root * tilt,
    )


def debiased(s: Sight) -> Frame:
    """The mean, given the measurement, of the covariance given the truth."""
    square = s.rising.kept * s.rising.kept
    lost = (s.rising.lost * (1 + s.rising.kept)) * (1 + square)
    level = (s.whole + s.rising.s2) * level_square(s, square * square, lost)
    mean = _turned(s, upright(s, forms.debiased(s.rising)), level)
    turned, left = 1 + s.kept * s.kept, s.lost * (1 + s.kept)
    return Frame(
        (mean.ahead * turned + mean.across * left) / 2,
        (mean.ahead * left + mean.across * turned) / 2,
        mean.up,
        s.kept_root * mean.tilt,
    )


def unbiased(s: Sight, rising_root: Any) -> Frame:
    """The mean square error given the measurement of the conversion that is unbiased given the
    truth; `rising_root` is exp(-sigma^2/2) of the elevation.
    """
    own = spread(s)
    level, upwards = bias(s, rising_root)
    return Frame(
        own.ahead + level * level,
        own.across,
        own.up + upwards * upwards,
        own.tilt + level * upwards,
    )


def bias(s: Sight, rising_root: Any) -> tuple[Any, Any]:
    """Of the unbiased conversion given the measurement, ahead and up."""
    both = lost_of_both(s)
    level = ((s.rising.r * s.cos) * both) / (s.kept_root * rising_root)
    return level, ((s.rising.r * s.sin) * s.rising.lost) / rising_root


def lost_of_both(s: Sight) -> Any:
    """1 - L of both angles together."""
    return s.lost + s.kept * s.rising.lost


def in_coordinates(f: Frame, cos: Any, sin: Any) -> dict[str, Any]:
    """The entries by their names, the frame turned by the azimuth."""
    along, over = cos * cos, sin * sin
    return {
        "covariance_xx": along * f.ahead + over * f.across,
        "covariance_xy": (sin * cos) * (f.ahead - f.across),
        "covariance_xz": cos * f.tilt,
        "covariance_yy": over * f.ahead + along * f.across,
        "covariance_yz": sin * f.tilt,
        "covariance_zz": f.up,
    }
