"""Whether formulas have a value anywhere: a test against those that have none compares nothing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath

DIGITS = 60


def require_values(source: str, values: Mapping[str, Any]) -> None:
    """Raise ValueError for a kernel whose formulas have no real value at any of its points.

    `source`: the text of `formulas_source`; `values`: what tests read of each kernel.
    """
    space: dict[str, Any] = {}
    exec(compile(source, "formulas", "exec"), space)  # noqa: S102 (text that was just printed)
    before = mpmath.iv.dps
    mpmath.iv.dps = DIGITS
    try:
        for kernel in values:
            points = next(iter(values[kernel]["points"].values()))
            if kernel in space and not any(_known(space[kernel], each["at"]) for each in points):
                raise ValueError(f"{kernel}: its formulas have no real value at any point tried")
    finally:
        mpmath.iv.dps = before


def _known(formula: Any, at: list[float]) -> bool:
    """Whether a point has a finite interval for an output; more digits may make it narrow."""
    try:
        found = formula(*map(mpmath.iv.mpf, at))
    except (ZeroDivisionError, ValueError, NotImplementedError):
        return False
    return any(mpmath.isfinite(mpmath.mpf(value.delta)) for value in found.values())
