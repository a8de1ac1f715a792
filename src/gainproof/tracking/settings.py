"""What a tracker is told, with its defaults."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.tracking import conversion, gains

LARGEST = 1e9
"""Beyond this no acceleration, speed or range of a setting is taken, in m and s."""
MOST_SCANS = 64
LEAST_GATE = 1e-12


@dataclass(frozen=True)
class Settings:
    """filter, conversion: names of `FILTERS` and `CONVERSIONS`. acceleration: sigma_w, the
    deviation of the target's acceleration, m/s^2. gate: the probability that a target's detection
    lies within its gate. most_speed: the fastest target that is looked for, m/s. confirm: a track
    needs so many detections in so many scans, the first two make its start. drop: a track ends
    after so many scans in a row without a detection. nominal_range: where the fixed gains are the
    exact ones, m; None: the median of all measured ranges.
    """

    filter: str = gains.DEFAULT
    conversion: str = conversion.DEFAULT
    acceleration: float = 0.98
    gate: float = 0.999
    most_speed: float = 400.0
    confirm: tuple[int, int] = (3, 4)
    drop: int = 5
    nominal_range: float | None = None

    def __post_init__(self) -> None:
        """Raises BadInputError for what cannot be used."""
        for kind, name, known in (
            ("filter", self.filter, gains.FILTERS),
            ("conversion", self.conversion, conversion.CONVERSIONS),
        ):
            if name not in known:
                raise unknown_name(kind, name, known)
        _require_above_zero("acceleration", self.acceleration)
        _require_above_zero("speed", self.most_speed)
        if self.nominal_range is not None:
            _require_above_zero("nominal range", self.nominal_range)
        if not LEAST_GATE <= self.gate <= 1 - LEAST_GATE:
            raise BadInputError(
                "the gate is a probability between 0 and 1, at least "
                f"{LEAST_GATE:g} from both, got {self.gate!s}"
            )
        needed, scans = self.confirm
        if not 2 <= needed <= scans <= MOST_SCANS:
            raise BadInputError(
                f"a track needs M detections in N scans, M from 2 to N and N up to {MOST_SCANS}, "
                f"got {needed} in {scans}"
            )
        if not 1 <= self.drop <= MOST_SCANS:
            raise BadInputError(
                f"a track is dropped after 1 to {MOST_SCANS} missed scans, got {self.drop}"
            )


def _require_above_zero(what: str, value: float) -> None:
    if not (math.isfinite(value) and 1 / LARGEST <= value <= LARGEST):
        raise BadInputError(
            f"the {what} is between {1 / LARGEST:g} and {LARGEST:g} in m and s, got {value!s}"
        )
