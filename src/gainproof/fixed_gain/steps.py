"""One step of many tracks: prediction over an interval, then a position, or none.

States are structures of arrays: positions apart from velocities. Everything is broadcast together,
so that gains and intervals may be numbers, one for each track, or one for each axis: positions of
shape (3, tracks) take gains of shape (3, 1). `out` may be the states themselves.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import filter_step

Real = float | np.floating[Any] | NDArray[np.floating[Any]]


class Moving(NamedTuple):
    """Position in m and velocity in m/s after a step."""

    position: Real
    velocity: Real


class Accelerating(NamedTuple):
    """Position in m, velocity in m/s and acceleration in m/s^2 after a step."""

    position: Real
    velocity: Real
    acceleration: Real


def step_two_states(
    position: ArrayLike,
    velocity: ArrayLike,
    interval: ArrayLike,
    observed: ArrayLike,
    alpha: ArrayLike,
    beta: ArrayLike,
    detected: ArrayLike = True,
    *,
    out: tuple[Any, Any] | None = None,
) -> Moving:
    """Tracks of position (m) and velocity (m/s) an interval (s) later, with what is observed (m).

    The gains may differ from step to step and from track to track; of a filter that keeps its gains
    over unequal intervals, alpha and beta are these gains. Where `detected` is false the state is
    predicted alone, whatever stands for the observation (NaN too).

    Domain, types, proved bounds and errors are those of `gainproof.generated.filter_step`;
    TypeError where `detected` is not true or false. Inputs are checked before `out` is touched.
    """
    gains, observations = _masked(detected, (alpha, beta), (observed,))
    return Moving(
        *filter_step.step_two_states(position, velocity, interval, *observations, *gains, out=out)
    )


def step_three_states(
    position: ArrayLike,
    velocity: ArrayLike,
    acceleration: ArrayLike,
    interval: ArrayLike,
    observed: ArrayLike,
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    detected: ArrayLike = True,
    *,
    out: tuple[Any, Any, Any] | None = None,
) -> Accelerating:
    """The same with an acceleration (m/s^2); gamma takes the innovation over t^2."""
    gains, observations = _masked(detected, (alpha, beta, gamma), (observed,))
    return Accelerating(
        *filter_step.step_three_states(
            position, velocity, acceleration, interval, *observations, *gains, out=out
        )
    )


def step_interacting(
    position: ArrayLike,
    velocity: ArrayLike,
    interval: ArrayLike,
    observed: ArrayLike,
    position_gain: ArrayLike,
    velocity_gain: ArrayLike,
    detected: ArrayLike = True,
    *,
    out: tuple[Any, Any] | None = None,
) -> Moving:
    """Tracks in three coordinates, each corrected by the innovations of all.

    position, velocity, observed: shape (3, ...), in m and m/s. position_gain: K1, velocity_gain: K2
    (1/s), shape (3, 3) or (3, 3, ...). interval (s) and `detected` broadcast with what follows the
    3. `out`: two arrays of shape (3, ...), the states themselves among them.

    ValueError besides for what has no axis of three.
    """
    states = [_axes(name, x) for name, x in (("position", position), ("velocity", velocity))]
    matrices = (("position_gain", position_gain), ("velocity_gain", velocity_gain))
    gains = [entry for name, x in matrices for row in _axes(name, x) for entry in _axes(name, row)]
    gains, observations = _masked(detected, gains, _axes("observed", observed))
    given = (*states[0], *states[1], interval, *observations, *gains)
    if out is None:
        found = filter_step.step_interacting(*given)
        return Moving(np.stack(found[:3]), np.stack(found[3:]))
    if not isinstance(out, tuple) or len(out) != 2:
        raise ValueError("out must be a tuple of two arrays (position, velocity)")
    rows = tuple(
        row
        for name, x in zip(("position", "velocity"), out, strict=True)
        for row in _out_rows(name, x)
    )
    filter_step.step_interacting(*given, out=rows)
    return Moving(*out)


def _masked(detected: Any, gains: Any, observed: Any) -> tuple[list[ArrayLike], list[ArrayLike]]:
    """Gains and observations, 0 where nothing was observed: exactly the prediction is left."""
    if detected is True:
        return list(gains), list(observed)
    seen = np.asarray(detected)
    if seen.dtype != np.bool_:
        raise TypeError(f"detected must be true or false, got {seen.dtype}")
    if seen.all():
        return list(gains), list(observed)
    return [_kept(seen, gain) for gain in gains], [_kept(seen, z) for z in observed]


def _kept(seen: NDArray[np.bool_], value: ArrayLike) -> ArrayLike:
    array = np.asarray(value)
    if array.dtype.kind not in "iuf":
        return value  # the kernel says what is wrong
    try:
        return np.where(seen, array, array.dtype.type(0))
    except ValueError:
        raise ValueError(
            f"detected of shape {seen.shape} does not broadcast with gains or observations of "
            f"shape {array.shape}"
        ) from None


def _axes(name: str, value: ArrayLike) -> list[Any]:
    array = np.asarray(value)
    if not array.ndim or len(array) != 3:
        raise ValueError(f"{name} must have axes of three coordinates, got shape {array.shape}")
    return [array[0], array[1], array[2]]


def _out_rows(name: str, value: Any) -> list[Any]:
    if not isinstance(value, np.ndarray):
        raise TypeError(f"out {name} must be an array, got {type(value).__name__}")
    if value.ndim < 2:
        raise ValueError(f"out {name} must have shape (3, ...) of arrays, got {value.shape}")
    return _axes(f"out {name}", value)
