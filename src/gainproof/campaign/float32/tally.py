"""What is measured of one output, and how it joins: plain data, of few inputs or of all.

For each output: the worst error in units of 2^-23 times its scale, as the bounds have it, the input
where it is, and the worst in units in the last place of the scale; how many of the inputs for which
the bound is stated are `above` it, NaN among them; how many inputs lie `outside` these, and of how
many of them the result is not 0, subnormal or infinite, as documented.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.campaign.float32.reference import Compared

EPSILON = 2.0**-23
LEAST_NORMAL, LARGEST = 2.0**-126, (2 - EPSILON) * 2.0**127
EDGE = 2.0**-10
"""What rounding may make of a true value next to the ends of the normal numbers, relative."""
EXPONENT = 0x7FF0_0000_0000_0000
"""The bits of a double that say its power of two."""
COUNTED = ("above", "outside", "undocumented")
Tally = Mapping[str, Any]
Doubles = NDArray[np.float64]
Singles = NDArray[np.float32]


def tally(output: Compared, x: Singles, y: Singles, true: Doubles, scale: Doubles) -> Tally:
    """That of inputs in their order, of the results, and of what these should be."""
    low = int(np.searchsorted(x, np.float32(output.lowest), "left"))
    high = int(np.searchsorted(x, np.float32(output.highest), "right"))
    within = slice(low, high)
    beyond = np.abs(np.concatenate((y[:low], y[high:])))
    fine = (beyond <= LEAST_NORMAL * (1 + EDGE)) | (beyond >= LARGEST * (1 - EDGE))
    return {
        "bound": output.bound,
        **_errors(output.bound, x[within], np.abs(y[within] - true[within]), scale[within]),
        "outside": beyond.size,
        "undocumented": beyond.size - int(np.count_nonzero(fine)),
    }


def _errors(bound: float, x: Singles, error: Doubles, scale: Doubles) -> Tally:
    if not x.size:
        return {"worst": 0.0, "at": None, "ulp": 0.0, "above": 0}
    power = (scale.view(np.int64) & EXPONENT).view(np.float64)
    relative = error / np.abs(scale)
    place = int(np.argmax(relative))  # of the first NaN where there is one
    worst = _size(relative[place])
    above = 0 if worst <= bound else int(np.count_nonzero(~(relative <= bound * EPSILON)))
    return {
        "worst": worst,
        "at": float(x[place]),
        "ulp": _size(np.max(error / power)),
        "above": above,
    }


def _size(error: np.float64) -> float:
    """In units of 2^-23; NaN is worse than any number."""
    return float("inf") if np.isnan(error) else float(error) / EPSILON


def joined(tallies: Sequence[Tally]) -> Tally:
    """That of all inputs, from those of parts in their order; the first of equal worst errors."""
    worst = max(tallies, key=lambda each: each["worst"])
    sums = {word: sum(each[word] for each in tallies) for word in COUNTED}
    return {**worst, **sums, "ulp": max(each["ulp"] for each in tallies)}
