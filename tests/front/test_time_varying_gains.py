"""When steady gains will do, and how long least squares does."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.time_varying import (
    PROCESS_NOISES,
    Factors,
    covariance_of,
    error_ratio,
    gain_schedule,
    hand_over_sample,
    samples_to_steady_gains,
    schedule_variance,
    start,
    step,
    three_states,
)
from gainproof.verify.oracles import least_squares, recursion
from gainproof.verify.oracles.doubling import steady_state
from gainproof.verify.oracles.matrices import add, matrix, product, subtract, transpose
from gainproof.verify.oracles.multiprecision import context, fraction, number_in
from gainproof.verify.oracles.riccati import closed_loop, predict, update
from gainproof.verify.oracles.state_space import StateSpace

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize("name", cases(NAMES, {NAMES[0], NAMES[-1]}.__contains__))
SHAPES = {
    "random-velocity": ((0, 0), (0, 1)),
    "random-acceleration": ((Fraction(1, 4), Fraction(1, 2)), (Fraction(1, 2), 1)),
    "continuous-white-acceleration": ((Fraction(1, 3), Fraction(1, 2)), (Fraction(1, 2), 1)),
}


def model(name: str, index: Fraction) -> StateSpace:
    """In units of the interval and of the measured position's deviation."""
    return StateSpace(
        matrix([[1, 1], [0, 1]], Fraction),
        matrix(SHAPES[name], lambda x: Fraction(x) * index * index),
        matrix([[1, 0]], Fraction),
        matrix([[1]], Fraction),
    )


@EVERY
def test_the_distance_is_multiplied_by_closed_loops_exactly(name: str) -> None:
    """P_k - B_k = A(P_k-1)...A(P_0) (P_0 - B_0) (A(B_k-1)...A(B_0))', and one start stays above."""
    system = model(name, Fraction(2, 3))
    p, b = matrix([[9, 1], [1, 5]], Fraction), matrix([[1, 0], [0, "1/2"]], Fraction)
    left = right = matrix([[1, 0], [0, 1]], Fraction)
    first = subtract(p, b)
    bound = first
    for _ in range(6):
        one, other = update(system, p), update(system, b)
        left = product(closed_loop(system, one.gain), left)
        right = product(closed_loop(system, other.gain), right)
        bound = product(right, first, transpose(right))
        p, b = predict(system, one.updated), predict(system, other.updated)
        gap = subtract(p, b)
        assert gap == product(left, first, transpose(right))
        for below in (gap, subtract(bound, gap)):
            assert below[0][0] > 0
            # what one sample takes away has rank one
            assert below[0][0] * below[1][1] - below[0][1] ** 2 >= 0


@EVERY
@pytest.mark.parametrize("index", cases([0.01, 0.1, 1.0], lambda index: index != 0.1))
@pytest.mark.parametrize("first", [50.0, 1e-3], ids=["above", "below"])
def test_the_ratio_is_that_of_the_run(name: str, index: float, first: float) -> None:
    """Over many samples, by multiprecision: complex poles make single quotients swing."""
    system = model(name, Fraction(index))
    steady = steady_state(system, 60).state.predicted
    own = context(400)
    number = number_in(own)
    ratio = float(error_ratio(index, name))
    count = int(12 / -np.log(ratio))
    begin = matrix([[first, 0], [0, first]], lambda x: number(Fraction(x)))
    states = recursion.transient(system, begin, 3 * count + 1, number)
    far, near = (
        max(
            abs(x - number(fraction(y)))
            for row, known in zip(each.predicted, steady, strict=True)
            for x, y in zip(row, known, strict=True)
        )
        for each in (states[count], states[3 * count])
    )
    measured = float(own.log(near / far)) / (2 * count)
    assert measured == pytest.approx(np.log(ratio), rel=0.15)


@EVERY
@pytest.mark.parametrize("share", cases([0.1, 0.01, 1e-6], lambda share: share != 0.01))
def test_samples_to_steady_gains(name: str, share: float) -> None:
    indices = np.array([0.003, 0.05, 1.0, 30.0])
    found = samples_to_steady_gains(indices, share, name)
    assert found.dtype == np.int64
    steady = gain_schedule(indices, 1, name)
    assert steady.alpha.shape == (1, 4)
    for index, count in zip(indices.tolist(), found.tolist(), strict=True):
        noise = PROCESS_NOISES[name].steady.gains(index)
        f = start(1.0, index * index, 1.0, name)
        outside = []
        for number in range(1, 2 * count + 50):
            now = step(f, 1.0, index * index, 1.0, process_noise=name)
            f = now.factors
            near = abs(now.position_gain / noise.alpha - 1) <= share
            if not (near and abs(now.velocity_gain / noise.beta - 1) <= share):
                outside.append(number)
        assert max(outside, default=0) == count
        # the rate tells it but for a factor that does not depend on the share
        rate = np.log(share) / np.log(error_ratio(index, name))
        assert abs(count - rate) <= 4 + 1.2 / np.sqrt(index)


def test_a_start_of_ones_own() -> None:
    steady = PROCESS_NOISES["random-acceleration"].steady
    p = steady.updated_covariance(0.5)
    cross = p.updated_12 / p.updated_22
    own = Factors(p.updated_11 - cross * p.updated_12, cross, p.updated_22)
    assert samples_to_steady_gains(0.5, 1e-6, "random-acceleration", own) == 0
    assert samples_to_steady_gains(0.5, 1e-6, "random-acceleration") > 5
    many = Factors(*(np.full(3, x) for x in own))
    assert samples_to_steady_gains(0.5, 1e-6, "random-acceleration", many).tolist() == [0, 0, 0]


@EVERY
@settings(max_examples=samples(12), deadline=None)
@given(st.floats(-7, 6).map(lambda e: 10.0**e))
def test_hand_over(name: str, index: float) -> None:
    last = int(hand_over_sample(index, name))
    alpha = Fraction(float(PROCESS_NOISES[name].steady.gains(index).alpha))
    slack = 1 + Fraction(1, 10**14)
    assert least_squares.gains(1, last)[0] * slack >= alpha
    assert least_squares.gains(1, last + 1)[0] < alpha * slack


def test_hand_over_at_whole_numbers() -> None:
    """Where the steady gain is that of a sample to the last digit, that sample is still fitted."""
    for name in NAMES:
        module = PROCESS_NOISES[name].steady
        for k in range(2, 40):
            index = float(module.index_from_alpha(float(least_squares.gains(1, k)[0]))[0])
            assert int(hand_over_sample(index * (1 + 1e-13), name)) == k - 1 + (k == 1)
            assert int(hand_over_sample(index * (1 - 1e-13), name)) == k


@EVERY
def test_the_schedule_costs_little_and_is_never_better(name: str) -> None:
    indices = np.array([1e-3, 0.03, 0.3, 2.0, 50.0])
    found = schedule_variance(indices, 300, name)
    ratio = found.scheduled / found.least
    assert ratio.shape == (299, 5)
    assert (ratio >= 1 - 1e-14).all()
    assert (ratio[0] == 1).all()
    assert ratio.max() < 1.05
    assert ratio[-1, 1:] == pytest.approx(1, abs=1e-9)


@EVERY
def test_kalman_gains_are_above_both(name: str) -> None:
    """From two positions on: above those of the fit, and above the steady ones."""
    index = 0.05
    schedule = gain_schedule(index, 60, name)
    f = start(1.0, index * index, 1.0, name)
    for k in range(2, 60):
        now = step(f, 1.0, index * index, 1.0, process_noise=name)
        f = now.factors
        assert now.position_gain >= schedule.alpha[k] * (1 - 1e-14)
    assert covariance_of(f).shape == (2, 2)


def test_schedule_against_joseph_in_fractions() -> None:
    name, index = "random-acceleration", Fraction(1, 4)
    system = model(name, index)
    schedule = gain_schedule(float(index), 9, name)
    h = system.measurement
    x = matrix([[1, 0], [0, 10**6]], Fraction)
    for k in range(1, 9):
        gain = matrix([[schedule.alpha[k]], [schedule.beta[k]]], lambda g: Fraction(float(g)))
        kept = subtract(matrix([[1, 0], [0, 1]], Fraction), product(gain, h))
        p = predict(system, x)
        x = add(product(kept, p, transpose(kept)), product(gain, transpose(gain)))
    found = schedule_variance(float(index), 9, name).scheduled[-1]
    assert float(found) == pytest.approx(float(x[0][0]), rel=1e-13)


def test_what_is_refused() -> None:
    with pytest.raises(ValueError, match="share must lie above 1e-12 and below 1, got 1"):
        samples_to_steady_gains(1.0, 1)
    with pytest.raises(ValueError, match=r"may take .* samples, over 2000000"):
        samples_to_steady_gains(1e-12, 0.01)
    with pytest.raises(ValueError, match="beyond sample 2"):
        hand_over_sample(1e-40)
    with pytest.raises(ValueError, match="samples must be at least 2"):
        schedule_variance(1.0, 1)


@pytest.mark.parametrize("schedule", [gain_schedule, three_states.gain_schedule])
def test_a_schedule_of_no_sample_is_none(schedule: Callable[..., Any]) -> None:
    for number in (0, -1):
        with pytest.raises(ValueError, match="samples should be a whole number from 1 on, got"):
            schedule(1.0, number)
    with pytest.raises(TypeError):
        schedule(1.0, 2.5)
