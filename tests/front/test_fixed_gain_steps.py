"""Steps of many tracks against exact fractions, matrix by matrix; missed detections; in place."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from gainproof.fixed_gain import steps

UNIT = 2.0**-52
BOUNDS = {2: (2.51, 3.01), 3: (3.51, 4.01, 4.51)}
"""Of `generated/filter_step.py`, in units of 2^-52 over the sum of the terms' magnitudes."""


def exact(state: Sequence[Any], t: Any, z: Any, gains: Sequence[Any]) -> list[tuple[Any, Any]]:
    """F s + K (z - H F s), and the same with every term positive, by rows of F and K."""
    size = len(state)
    rows = [[Fraction(0)] * i + [Fraction(1), t, t * t / 2][: size - i] for i in range(size)]
    ahead = [sum(a * b for a, b in zip(row, state, strict=True)) for row in rows]
    sizes = [sum(abs(a * b) for a, b in zip(row, state, strict=True)) for row in rows]
    return [
        (x + k / t**n * (z - ahead[0]), s + abs(k) / t**n * (abs(z) + sizes[0]))
        for n, (x, s, k) in enumerate(zip(ahead, sizes, gains, strict=True))
    ]


def step(size: int, *given: Any, **options: Any) -> tuple[Any, ...]:
    function = steps.step_two_states if size == 2 else steps.step_three_states
    return function(*given, **options)


@pytest.mark.parametrize("size", [2, 3])
def test_a_step_is_the_filter_within_the_bound_over_its_terms(size: int) -> None:
    generator = np.random.default_rng(size)
    state = generator.normal(size=(size, 200)) * 10.0 ** generator.integers(-6, 7, (size, 200))
    t = generator.uniform(0.1, 20, 200)
    # half of the observations next to the prediction, where the innovation cancels
    near = state[0] + t * state[1] + (t * t / 2 * state[2] if size == 3 else 0)
    z = np.where(generator.random(200) < 0.5, near, generator.normal(size=200) * 1e4)
    gains = generator.uniform(0, 1.5, (size, 200))
    found = step(size, *state, t, z, *gains)
    for k in range(200):
        given = [[Fraction(float(x)) for x in values[:, k]] for values in (state, gains)]
        truth = exact(given[0], Fraction(float(t[k])), Fraction(float(z[k])), given[1])
        for n, (value, scale) in enumerate(truth):
            assert abs(Fraction(float(found[n][k])) - value) <= scale * BOUNDS[size][n] * UNIT


@pytest.mark.parametrize("size", [2, 3])
def test_a_missed_detection_is_a_prediction_alone(size: int) -> None:
    """Whatever stands for the observation, NaN too; exactly what gains of 0 leave."""
    generator = np.random.default_rng(7)
    state = generator.normal(size=(size, 50))
    gains = [0.4, 0.1, 0.01][:size]
    seen = generator.random(50) < 0.5
    z = np.where(seen, generator.normal(size=50), np.nan)
    found = step(size, *state, 2.0, z, *gains, seen)
    alone = step(size, *state, 2.0, 0.0, *[0.0] * size)
    full = step(size, *state, 2.0, np.where(seen, z, 0), *gains)
    for x, prediction, update in zip(found, alone, full, strict=True):
        assert (x[~seen] == prediction[~seen]).all()
        assert (x[seen] == update[seen]).all()
    with pytest.raises(TypeError, match="detected must be true or false"):
        step(size, *state, 2.0, 1.0, *gains, 1)
    with pytest.raises(ValueError, match=r"detected of shape \(3,\) does not broadcast with"):
        step(size, *state, 2.0, z, *gains, np.array([True, False, True]))
    with pytest.raises(ValueError, match=r"observed must be .* got nan at index"):
        step(size, *state, 2.0, z, *gains)


@pytest.mark.parametrize("count", [5, 200_000])
def test_in_place_gives_what_new_arrays_get(count: int) -> None:
    """Over several blocks too; with an output in another's place the whole input is kept."""
    generator = np.random.default_rng(3)
    state: Any = generator.normal(size=(3, count))
    z = generator.normal(size=count)
    wanted: Any = step(3, *state, 2.0, z, 0.4, 0.1, 0.01)
    same: Any = state.copy()
    step(3, *same, 2.0, z, 0.4, 0.1, 0.01, out=(same[0], same[1], same[2]))
    turned = state.copy()
    given = turned[0], turned[1], turned[2]
    step(3, *given, 2.0, z, 0.4, 0.1, 0.01, out=given[::-1])
    shifted = np.concatenate([state, np.zeros((3, 1))], axis=1)
    parts = [row[:-1] for row in shifted]
    step(3, *parts, 2.0, z, 0.4, 0.1, 0.01, out=tuple(row[1:] for row in shifted))
    for n in range(3):
        assert (same[n] == wanted[n]).all()
        assert (turned[2 - n] == wanted[n]).all()
        assert (shifted[n, 1:] == wanted[n]).all()


def test_bad_input_leaves_the_tracks_as_they_were() -> None:
    count = 200_000
    position, velocity = np.ones(count), np.ones(count)
    observed = np.ones(count)
    observed[-1] = np.nan
    with pytest.raises(ValueError, match=r"observed must be .*got nan at index 199999"):
        steps.step_two_states(position, velocity, 1.0, observed, 0.5, 0.1, out=(position, velocity))
    assert (position == 1).all()
    assert (velocity == 1).all()


@pytest.mark.parametrize("place", [0, 1023, 1024, 2499])
@pytest.mark.parametrize("bad", [1.0000001e4, -1.0000001e4, np.inf, -np.inf, np.nan])
def test_one_gain_beyond_its_domain_among_the_largest_is_found(place: int, bad: float) -> None:
    """Whether sums of squares tell that all are small or not: among rows of them and beyond."""
    for size in (1.0, 1e4):
        gains = np.resize([size, -size], 2500)
        states = np.zeros(2500), np.ones(2500)
        steps.step_two_states(*states, 1.0, 0.0, gains, 0.0)
        gains[place] = bad
        with pytest.raises(ValueError, match=f"alpha must be of magnitude .* at index {place}$"):
            steps.step_two_states(*states, 1.0, 0.0, gains, 0.0)


def test_gains_of_each_axis_and_intervals_of_each_track() -> None:
    generator = np.random.default_rng(4)
    position, velocity, observed = generator.normal(size=(3, 3, 10))
    t = generator.uniform(1, 3, 10)
    alpha, beta = np.array([[0.4], [0.5], [0.6]]), np.array([[0.1], [0.2], [0.3]])
    found: Any = steps.step_two_states(position, velocity, t, observed, alpha, beta)
    for axis in range(3):
        own: Any = steps.step_two_states(
            position[axis], velocity[axis], t, observed[axis], alpha[axis, 0], beta[axis, 0]
        )
        assert (np.asarray(found.position)[axis] == own.position).all()
        assert (np.asarray(found.velocity)[axis] == own.velocity).all()


def test_single_precision_stays() -> None:
    given: list[Any] = [np.float32(x) for x in (1.5, 2.0, 3.0, 4.0, 0.5, 0.25)]
    found: Any = steps.step_two_states(*given)
    assert found.position.dtype == np.float32
    assert [float(x) for x in found] == [5.75, float(np.float32(1.7083334))]
