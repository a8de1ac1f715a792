"""Three states: how long a fitted parabola does, and what that costs.

The oracles: least squares over all samples at once, and the recursion of whole matrices in
fractions, started from the normal equations of three positions.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from recursion_triples import ROW, model, three_positions
from samples import samples

from gainproof.time_varying.three_states import (
    PROCESS_NOISES,
    covariance_of,
    gain_schedule,
    hand_over_sample,
    schedule_variance,
    start,
    step,
)
from gainproof.verify.oracles import least_squares, recursion
from gainproof.verify.oracles.matrices import add, identity, matrix, product, subtract, transpose
from gainproof.verify.oracles.riccati import predict

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize(
    "name", cases(NAMES, {"acceleration-increments", "random-jerk"}.__contains__)
)
ONE = Fraction(1)


@EVERY
@settings(max_examples=samples(12), deadline=None)
@given(st.floats(-9, 6).map(lambda e: 10.0**e))
def test_hand_over(name: str, index: float) -> None:
    last = int(hand_over_sample(index, name))
    alpha = Fraction(float(PROCESS_NOISES[name].steady.gains(index).alpha))
    slack = 1 + Fraction(1, 10**14)
    assert least_squares.gains(2, last)[0] * slack >= alpha
    assert least_squares.gains(2, last + 1)[0] < alpha * slack


def test_hand_over_at_whole_numbers() -> None:
    """Where the steady gain is that of a sample to the last digit, that sample is still fitted."""
    module = PROCESS_NOISES["acceleration-increments"].steady
    for k in range(3, 40):
        index = float(module.index_from_alpha(float(least_squares.gains(2, k)[0]))[0])
        assert int(hand_over_sample(index * (1 + 1e-13), "acceleration-increments")) == k - 1
        assert int(hand_over_sample(index * (1 - 1e-13), "acceleration-increments")) == k


@EVERY
def test_a_schedule_is_the_fit_and_then_the_steady_gains(name: str) -> None:
    indices = np.array([0.05, 0.6])
    schedule = gain_schedule(indices, 20, name)
    last = np.asarray(hand_over_sample(indices, name))
    steady = PROCESS_NOISES[name].steady.gains(indices)
    assert [each[0].tolist() for each in schedule] == [[1, 1], [0, 0], [0, 0]]
    assert [each[1].tolist() for each in schedule] == [[1, 1], [1, 1], [0, 0]]
    for number in range(2, 20):
        fit = [float(x) for x in least_squares.gains(2, number)]
        for each, fitted, known in zip(schedule, fit, steady, strict=True):
            wanted = np.where(number <= last, fitted, known)
            assert each[number] == pytest.approx(wanted, rel=2e-15)


@EVERY
def test_the_schedule_costs_little_and_is_never_better(name: str) -> None:
    found = schedule_variance(np.array([1e-3, 0.03, 0.3, 2.0, 50.0]), 300, name)
    ratio = found.scheduled / found.least
    assert ratio.shape == (298, 5)
    assert (ratio >= 1 - 1e-12).all()
    assert (ratio[0] == 1).all()
    assert ratio.max() < 1.02
    assert ratio[-1, 1:] == pytest.approx(1, abs=1e-9)


@EVERY
def test_kalman_gains_are_above_both(name: str) -> None:
    """From three positions on: above those of the fit, and above the steady ones."""
    index = 0.05
    schedule = gain_schedule(index, 60, name)
    f = start(1.0, 1.0, index * index, 1.0, name)
    for k in range(3, 60):
        now = step(f, 1.0, index * index, 1.0, process_noise=name)
        f = now.factors
        assert now.position_gain >= schedule.alpha[k] * (1 - 1e-14)
    assert covariance_of(f).shape == (3, 3)


@EVERY
def test_schedule_against_joseph_in_fractions(name: str) -> None:
    """From the batch of three positions on, over the hand-over, with the exact gains of fits."""
    index = Fraction(1, 4)
    system = model(name, index)
    last = int(hand_over_sample(float(index), name))
    steady = PROCESS_NOISES[name].steady.gains(float(index))
    x = three_positions(name, index)
    for k in range(3, 14):
        fit = least_squares.gains(2, k) if k <= last else [Fraction(float(g)) for g in steady]
        gain = matrix([[g] for g in fit], Fraction)
        kept = subtract(identity(3, ONE), product(gain, ROW))
        p = predict(system, x)
        x = add(product(kept, p, transpose(kept)), product(gain, transpose(gain)))
    found = schedule_variance(float(index), 14, name)
    assert float(found.scheduled[-1]) == pytest.approx(float(x[0][0]), rel=1e-13)
    best = recursion.transient(system, predict(system, three_positions(name, index)), 11)
    assert float(found.least[-1]) == pytest.approx(float(best[-1].updated[0][0]), rel=1e-13)


def test_what_is_refused() -> None:
    with pytest.raises(ValueError, match="beyond sample 2"):
        hand_over_sample(1e-60)
    with pytest.raises(ValueError, match="samples must be at least 3"):
        schedule_variance(1.0, 2)
