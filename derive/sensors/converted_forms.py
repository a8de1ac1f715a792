"""Covariances of conversions along and across the line of sight, in forms without cancellation.

They take anything with + - * /: SymPy's symbols, where they are proved, and the nodes of graphs,
from which kernels are printed. `kept` is L = exp(-sigma^2) of the azimuth and `lost` is 1 - L,
which expm1 gives without a subtraction; r is the range, s2 the variance of its noise.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Axes = tuple[Any, Any]


@dataclass(frozen=True)
class Noise:
    """Range, variance of the range, L and 1 - L."""

    r: Any
    s2: Any
    kept: Any
    lost: Any


def spread(n: Noise) -> Axes:
    """Of the raw conversion given the truth; of the truth given the measurement."""
    short = n.r * n.lost
    radial = (short * short + n.s2 * (1 + n.kept * n.kept)) / 2
    return radial, ((n.r * n.r + n.s2) * (n.lost * (1 + n.kept))) / 2


def debiased(n: Noise) -> Axes:
    """The mean, given the measurement, of the covariance given the truth."""
    square = n.kept * n.kept
    whole = n.r * n.r + n.s2
    radial = whole * ((n.lost * n.lost) * (1 + n.kept + square)) + n.s2 * (1 + square * square)
    near = n.s2 * ((1 + n.kept) * (1 + n.lost + 2 * square))
    cross = n.lost * ((n.r * n.r) * (1 + square * n.kept) + near)
    return radial / 2, cross / 2


def unbiased(n: Noise) -> Axes:
    """The mean square error given the measurement of the conversion that is unbiased given the
    truth.
    """
    radial, cross = spread(n)
    short = n.r * n.lost
    return radial + (short * short) / n.kept, cross
