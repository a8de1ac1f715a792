"""What is measured of one output, and how it joins: plain data, of few inputs or of all.

For each output: the worst error in units of 2^-23 times its scale, as the bounds have it, NaN being
infinite; the first input where it is; and the worst in units in the last place of the scale, all of
the inputs for which the bound is stated. How many inputs lie `outside` these, and of how many of
them the result is not 0, subnormal or infinite, as documented.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.campaign.float32.doubles import evaluator
from gainproof.campaign.float32.reference import Compared, Reference

EPSILON = 2.0**-23
EDGE = 2.0**-10
"""What rounding may make of a true value next to the ends of the normal numbers, relative."""
SMALL, LARGE = 2.0**-126 * (1 + EDGE), (2 - EPSILON) * 2.0**127 * (1 - EDGE)
EXPONENT = 0x7FF0_0000_0000_0000
"""The bits of a double that say its power of two."""
ONE_OVER = 0x7FE0_0000_0000_0000
"""These bits less those of a power of two are those of one over it."""
COUNTED = ("outside", "undocumented")
Tally = Mapping[str, Any]
Doubles = NDArray[np.float64]
Singles = NDArray[np.float32]


class Tallied:
    """What is measured of some inputs after others, by NumPy."""

    def __init__(self, reference: Reference) -> None:
        self.evaluated, self.outputs = evaluator(reference.kernel), reference.outputs
        self.parts: dict[str, list[Tally]] = {output.name: [] for output in self.outputs}

    def add(self, x: Singles, results: Sequence[Singles]) -> None:
        """Inputs in their order, and the results of each output."""
        with np.errstate(all="ignore"):
            rows = self.evaluated(x.astype(np.float64))
            for output, y in zip(self.outputs, results, strict=True):
                found = tally(output, x, y, rows[output.value], rows[output.scale])
                self.parts[output.name].append(found)

    def tallies(self) -> dict[str, Tally]:
        """Of each output."""
        return {name: joined(parts) for name, parts in self.parts.items()}


def tally(output: Compared, x: Singles, y: Singles, true: Doubles, scale: Doubles) -> Tally:
    """That of inputs in their order, of the results, and of what these should be."""
    low = int(np.searchsorted(x, np.float32(output.lowest), "left"))
    high = int(np.searchsorted(x, np.float32(output.highest), "right"))
    within = slice(low, high)
    beyond = np.abs(np.concatenate((y[:low], y[high:]))).astype(np.float64)
    fine = (beyond <= SMALL) | (beyond >= LARGE)
    return {
        **_errors(x[within], np.abs(y[within] - true[within]), scale[within]),
        "outside": beyond.size,
        "undocumented": beyond.size - int(np.count_nonzero(fine)),
    }


def _errors(x: Singles, error: Doubles, scale: Doubles) -> Tally:
    if not x.size:
        return {"worst": 0.0, "at": None, "ulp": 0.0}
    one_over = (ONE_OVER - (scale.view(np.int64) & EXPONENT)).view(np.float64)
    relative = _sizes(error / np.abs(scale))
    place = int(np.argmax(relative))
    return {
        "worst": float(relative[place]) / EPSILON,
        "at": float(x[place]),
        "ulp": float(np.max(_sizes(error * one_over))) / EPSILON,
    }


def _sizes(errors: Doubles) -> Doubles:
    """NaN is worse than any number."""
    return np.where(np.isnan(errors), np.inf, np.abs(errors))


def joined(tallies: Sequence[Tally]) -> Tally:
    """That of all inputs, from those of parts in their order; the first of equal worst errors."""
    worst = max(tallies, key=lambda each: (each["worst"], each["at"] is not None))
    sums = {word: sum(each[word] for each in tallies) for word in COUNTED}
    return {**worst, **sums, "ulp": max(each["ulp"] for each in tallies)}
