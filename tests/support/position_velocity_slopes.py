"""Partial derivatives of steady states with position and velocity measured, from matrices alone."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from kernel_truth import STEADY_STATES

from gainproof.verify.oracles import differences, doubling
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.position_velocity import model

DIGITS = 70


def entries(name: str, index: Fraction, ratio: Fraction) -> dict[str, Any]:
    """Gain and covariances of the doubling, which knows the matrices alone."""
    noise = STEADY_STATES[name]["process_noise"]
    state = doubling.steady_state(model(noise, index, ratio), DIGITS).state
    places = {f"{i + 1}{j + 1}": (i, j) for i in range(2) for j in range(2)}
    kinds = {"gain": state.gain, "predicted": state.predicted, "updated": state.updated}
    return {
        f"{kind}_{place}": rows[i][j]
        for kind, rows in kinds.items()
        for place, (i, j) in places.items()
    }


@cache
def slopes(name: str, index: Fraction, ratio: Fraction, by: str) -> Mapping[str, Fraction]:
    """Every derivative by "tracking_index" or "velocity_ratio", by differences of the doubling.

    They are good to some 35 digits of the entry over the parameter.
    """

    def values(at: Fraction) -> list[Any]:
        point = (at, ratio) if by == "tracking_index" else (index, at)
        return list(entries(name, *point).values())

    at = index if by == "tracking_index" else ratio
    found = differences.derivatives(values, at, levels=8, digits=DIGITS)
    names = entries(name, index, ratio)
    return {entry: fraction(slope.value) for entry, slope in zip(names, found, strict=True)}
