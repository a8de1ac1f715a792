"""Which accuracies can be had at all: between those of an exact velocity and of none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.fixed_gain.arguments import place_of
from gainproof.position_velocity.arguments import Reals


@dataclass(frozen=True)
class Limits:
    """The accuracy with the velocity known exactly (``least``) and with none (``greatest``)."""

    least: Reals
    greatest: Reals


def require_reachable(name: str, wanted: Reals, limits: Limits, index: Reals, unit: str) -> None:
    """ValueError for the first wanted number that is not between its limits, and which is in the
    way. All arrays are of one shape; ``unit`` stands behind the limits, " m" or nothing.
    """
    fine = (wanted > limits.least) & (wanted < limits.greatest)
    if fine.all():
        return
    first = int(np.argmin(fine))
    low, high, came = (x.flat[first] for x in (limits.least, limits.greatest, wanted))
    reason = (
        "no velocity accuracy is enough"
        if came <= low
        else "the position alone is enough, no velocity need be measured"
    )
    raise ValueError(
        f"{name} must lie above {low:.10g}{unit} (velocity known exactly) "
        f"and below {high:.10g}{unit} (no velocity measured) "
        f"for tracking index {index.flat[first]!s}, "
        f"got {came!s}{place_of(first, wanted.shape)}: {reason}"
    )
