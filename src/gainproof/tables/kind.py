"""What a column may hold, and its units."""

from __future__ import annotations

import math
from dataclasses import dataclass

LENGTHS = {"m": 1.0, "km": 1e3, "cm": 1e-2, "mm": 1e-3}
SPEEDS = {"m/s": 1.0, "km/s": 1e3, "km/h": 1 / 3.6, "cm/s": 1e-2, "mm/s": 1e-3}
TIMES = {"s": 1.0, "min": 60.0, "ms": 1e-3}
ANGLES = {"deg": math.pi / 180, "rad": 1.0, "mrad": 1e-3}
FREQUENCIES = {"Hz": 1.0, "kHz": 1e3, "MHz": 1e6, "GHz": 1e9}
PURE = {"1": 1.0}

LEAST_DEVIATION, MOST_DEVIATION = 1e-9, 1e12
"""In m and m/s: beyond them squares and ratios run out of digits."""


@dataclass(frozen=True)
class Kind:
    """A column that a file may have: units with their size in metres, seconds and radians, none for
    words; whether it has to be there; what its numbers have to be.
    """

    units: dict[str, float] | None
    needed: bool = False
    above_zero: bool = False
    deviation: bool = False
    """Whether it is the deviation of noise, which is taken between LEAST and MOST deviation."""
    blank: bool = False
    """Whether a cell may be empty."""
