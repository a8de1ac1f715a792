"""From dimensionless numbers to metres and seconds."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.bad_input import BadInputError
from gainproof.design.sheet import Row, Sheet


@dataclass(frozen=True)
class Units:
    """What the user states: sampling interval in s, motion (acceleration in m/s^2 of two states,
    jerk in m/s^3 of three), standard deviation of the measured position in m. None: not stated.
    """

    interval: float | None = None
    motion: float | None = None
    deviation: float | None = None

    @property
    def stated(self) -> bool:
        return any(each is not None for each in (self.interval, self.motion, self.deviation))


def in_units(sheet: Sheet, row: Row, units: Units) -> Mapping[str, float]:
    """The row's numbers that the stated units allow, by what they are.

    lag in m: a_c T^2/beta (of three states, jerk times T^3/gamma); deviations of the predicted and
    the smoothed position in m; settling in s. Raises BadInputError where one is beyond float64.
    """
    found: dict[str, float] = {}
    if units.interval is not None and units.motion is not None:
        found["lag_m"] = _product(row.lag, units.motion, *[units.interval] * sheet.states)
    if units.deviation is not None:
        found["predicted_deviation_m"] = _product(units.deviation, row.predicted**0.5)
        found["smoothed_deviation_m"] = _product(units.deviation, row.smoothed**0.5)
    if units.interval is not None and row.samples is not None:
        found["settling_s"] = _product(row.samples, units.interval)
    return found


def _product(*factors: float) -> float:
    """Of factors of any size: only the product has to be a float."""
    if not all(map(math.isfinite, factors)):
        return math.inf
    try:
        found = float(math.prod(map(Fraction, factors)))
    except OverflowError:
        found = math.inf
    if found in (0.0, math.inf):
        raise BadInputError(
            "--interval, --acceleration, --jerk or --deviation too large or too small: a lag, an "
            "error or a settling time in these units is beyond float64"
        )
    return found
