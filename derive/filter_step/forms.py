"""A step in the order of operations in which it is printed.

The forms take anything with + - * /: SymPy's symbols, where they are proved, and the nodes of
graphs, from which kernels are printed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Interacting:
    """Positions, velocities and observed positions by axis; K1 and K2 by rows."""

    position: Sequence[Any]
    velocity: Sequence[Any]
    observed: Sequence[Any]
    position_gain: Sequence[Sequence[Any]]
    velocity_gain: Sequence[Sequence[Any]]


def predicted(state: Sequence[Any], interval: Any) -> list[Any]:
    """Position, velocity and, of three, acceleration an interval later."""
    if len(state) == 2:
        position, velocity = state
        return [position + interval * velocity, velocity]
    position, velocity, acceleration = state
    half = (interval / 2) * acceleration
    mean = velocity + half
    moved = mean + half  # before the mean is used for the last time: then that is done in place
    return [position + interval * mean, moved, acceleration]


def stepped(state: Sequence[Any], interval: Any, observed: Any, gains: Sequence[Any]) -> list[Any]:
    """The state after the update: each gain takes the innovation over the interval once more.

    The gains come after all quotients, so that their products may take the quotients' places.
    """
    ahead = predicted(state, interval)
    rates = [observed - ahead[0]]
    for _ in gains[1:]:
        rates.append(rates[-1] / interval)
    corrections = [gain * rate for gain, rate in zip(gains, rates, strict=True)]
    return [value + each for value, each in zip(ahead, corrections, strict=True)]


def interacting(given: Interacting, interval: Any) -> tuple[list[Any], list[Any]]:
    """Positions and velocities after the update, each taking the innovations of all axes."""
    moves = zip(given.position, given.velocity, strict=True)
    ahead = [position + interval * velocity for position, velocity in moves]
    innovation = [z - x for z, x in zip(given.observed, ahead, strict=True)]

    def corrected(values: Sequence[Any], gain: Sequence[Sequence[Any]]) -> list[Any]:
        return [value + _weighed(row, innovation) for value, row in zip(values, gain, strict=True)]

    return (
        corrected(ahead, given.position_gain),
        corrected(given.velocity, given.velocity_gain),
    )


def _weighed(row: Sequence[Any], values: Sequence[Any]) -> Any:
    total = row[0] * values[0]
    for weight, value in zip(row[1:], values[1:], strict=True):
        total = total + weight * value
    return total
