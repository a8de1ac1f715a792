"""Gates and assignment against brute force."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.tracking.association import assigned
from gainproof.tracking.gating import Pairs, gated, threshold
from gainproof.tracking.measured import Measured, Polar
from gainproof.tracking.motion import Estimate

LIMIT = 9.0


def least(squared: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> float:
    """The least sum of min(d^2, limit) over all one-to-one choices; inf is outside the gate."""
    n, m = squared.shape
    wide = np.full((n, m + n), LIMIT)
    wide[:, :m] = squared
    choices = permutations(range(m + n), n)
    return min(float(sum(wide[i, j] for i, j in enumerate(choice))) for choice in choices)


@given(
    st.integers(1, 3).flatmap(
        lambda n: st.lists(
            st.lists(
                st.one_of(st.just(np.inf), st.floats(0, LIMIT), st.sampled_from([0.0, 1.0, 9.0])),
                min_size=3,
                max_size=3,
            ),
            min_size=n,
            max_size=n,
        )
    )
)
@settings(max_examples=samples(20), deadline=None)
def test_the_sum_of_squares_is_the_least(rows: list[list[float]]) -> None:
    squared = np.array(rows)
    track, detection = np.nonzero(np.isfinite(squared))
    pairs = Pairs(track, detection, squared[track, detection])
    found = assigned(len(rows), pairs, LIMIT)
    used = found[found >= 0]
    assert len(set(used.tolist())) == used.size
    costs = [squared[i, j] if j >= 0 else LIMIT for i, j in enumerate(found.tolist())]
    assert np.isfinite(costs).all()
    assert sum(costs) == pytest.approx(least(squared), abs=1e-12)


def test_the_nearest_for_each_alone_would_be_worse() -> None:
    """Two tracks want the same detection: the sum decides."""
    pairs = Pairs(np.array([0, 0, 1]), np.array([0, 1, 0]), np.array([1.0, 1.5, 2.0]))
    assert assigned(2, pairs, LIMIT).tolist() == [1, 0]


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ([[8.9, 8.5]], [1]),
        ([[8.9], [8.8]], [-1, 0]),
        ([[0.2, 5.0], [4.5, np.inf]], [0, -1]),  # 0.2 + 9 is less than 5 + 4.5
        ([[0.2, 4.5], [4.5, np.inf]], [1, 0]),  # and 4.5 + 4.5 than 0.2 + 9
    ],
)
def test_none_costs_as_much_as_the_limit(rows: list[list[float]], expected: list[int]) -> None:
    squared = np.array(rows)
    track, detection = np.nonzero(np.isfinite(squared))
    pairs = Pairs(track, detection, squared[track, detection])
    assert assigned(len(rows), pairs, LIMIT).tolist() == expected


def test_without_pairs_nobody_has_a_detection() -> None:
    nothing = np.zeros(0, np.int64)
    assert assigned(3, Pairs(nothing, nothing, np.zeros(0)), LIMIT).tolist() == [-1, -1, -1]


def test_gates_hold_all_pairs_within_the_limit_and_no_others() -> None:
    draw = np.random.default_rng(2)
    n, m, limit = 40, 60, threshold(0.99)
    state = np.zeros((n, 4))
    state[:, ::2] = draw.uniform(0, 60, (n, 2))
    root = draw.standard_normal((n, 4, 4))
    covariance = root @ root.transpose(0, 2, 1)
    noise = draw.standard_normal((m, 2, 2))
    noise = noise @ noise.transpose(0, 2, 1) + 0.1 * np.eye(2)
    place = draw.uniform(0, 60, (m, 2))
    nothing = np.zeros(m)
    seen = Measured(place, noise, np.zeros((m, 2)), Polar(nothing, nothing, nothing, nothing))
    found = gated(Estimate(state, covariance), seen, limit)
    columns = (x.tolist() for x in (found.track, found.detection, found.squared))
    told = {(i, j): d for i, j, d in zip(*columns, strict=True)}
    for i in range(n):
        for j in range(m):
            off = place[j] - state[i, ::2]
            squared = off @ np.linalg.solve(covariance[i][::2, ::2] + noise[j], off)
            assert ((i, j) in told) == (squared <= limit)
            if squared <= limit:
                assert told[i, j] == pytest.approx(squared, rel=1e-9)


def test_the_gate_holds_its_share_of_two_normal_numbers() -> None:
    squared = np.sum(np.random.default_rng(1).standard_normal((100_000, 2)) ** 2, -1)
    for share in (0.5, 0.9, 0.999):
        held = np.mean(squared <= threshold(share))
        assert held == pytest.approx(share, abs=5 * (share * (1 - share) / 1e5) ** 0.5)
