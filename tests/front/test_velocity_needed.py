"""The inverse problem: the answer is right to the bound it promises, or the limit is named."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES
from numpy.typing import NDArray
from samples import samples

from gainproof.position_velocity import (
    PROCESS_NOISES,
    steady_state,
    velocity_deviation_for,
    velocity_ratio_for,
)
from gainproof.position_velocity.bracketing import MOST_ROUNDS, increasing_root
from gainproof.position_velocity.process_noise import DEFAULT
from gainproof.position_velocity.variance import COVARIANCES, position_variance
from gainproof.verify.oracles import doubling
from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import NotConverged

Reals = NDArray[np.float64]
PROMISED = Fraction(1, 2**50)
# nearer to an end than the stated errors of both kernels a variance may be refused, as is said
NEAR = 2.0**-46
# of the kernels, 53 bits: more than any of them states
BOUND = Fraction(64, 2**53)
NOISES = [
    pytest.param(noise, marks=[] if noise == DEFAULT else pytest.mark.thorough)
    for noise in sorted(PROCESS_NOISES)
]
SHARES = st.floats(-9, 9).map(lambda odds: 1 / (1 + 10.0**odds))


def ends(index: Reals, covariance: str = "predicted", noise: str = DEFAULT) -> list[Reals]:
    """The variances at the least and the greatest velocity ratio that the kernels take."""
    variance = position_variance(covariance, noise)
    ratios = variance.smallest_ratio, variance.largest_ratio
    return [variance.at(index, np.array(ratio)) for ratio in ratios]


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("covariance", COVARIANCES)
@settings(max_examples=samples(3), deadline=None)
@given(index=st.floats(-6, 6).map(lambda e: 10.0**e), share=SHARES)
@example(index=10.0**5.5, share=0.5)
def test_the_answer_is_exact_for_a_wanted_variance_within_the_promise(
    noise: str, covariance: str, index: float, share: float
) -> None:
    """Judged by doubling, at the very S that was returned."""
    low, high = (float(end) for end in ends(np.array(index), covariance, noise))
    # near 0, where some limits are, in the logarithm
    wanted = low + (high - low) * share if share > 0.5 else low * (high / low) ** (2 * share)
    assume(low * (1 + NEAR) < wanted < high * (1 - NEAR))
    ratio = float(velocity_ratio_for(index, wanted, covariance=covariance, process_noise=noise))
    shape = STEADY_STATES[noise.replace("-", "_")]["process_noise"]
    truth = oracle.named(doubling.steady_state(oracle.model(shape, index, ratio), 30).state)
    apart = fraction(truth[f"{covariance}_11"]) / Fraction(wanted) - 1
    assert abs(apart) <= PROMISED + BOUND


def test_a_hundred_thousand_answers_by_the_kernel_itself() -> None:
    generator = np.random.default_rng(4)
    index = 10.0 ** generator.uniform(-6, 6, 100_000)
    variance = position_variance()
    low, high = ends(index)
    wanted = low + (high - low) / (1 + 10.0 ** generator.uniform(-9, 9, index.size))
    inside = (low < wanted) & (wanted < high)
    index, wanted = index[inside], wanted[inside]
    ratio = np.asarray(velocity_ratio_for(index, wanted))
    apart = np.abs(variance.at(index, ratio) / wanted - 1)
    assert apart.max() <= 2.0**-50


def test_scalars_arrays_and_shapes() -> None:
    assert isinstance(velocity_ratio_for(1.0, 1.0), np.float64)
    found = np.asarray(velocity_ratio_for([[1.0], [1.5]], [1.2, 2.0, 2.5]))
    assert found.shape == (2, 3)
    assert found[1, 2] == velocity_ratio_for(1.5, 2.5)
    assert np.all(np.diff(found, axis=1) > 0)
    assert velocity_ratio_for(np.empty(0), 1.0).shape == (0,)


def test_what_no_velocity_can_give_says_so() -> None:
    with pytest.raises(ValueError, match=r"no velocity accuracy is enough$") as low:
        velocity_ratio_for(1.0, 0.5833)
    assert "must lie above 0.5833333333 (velocity" in str(low.value)
    assert "below 3.110797474 (no velocity" in str(low.value)
    with pytest.raises(ValueError, match=r"got 3.2 at index 1: the position alone is enough"):
        velocity_ratio_for(1.0, [1.0, 3.2])
    with pytest.raises(ValueError, match=r"updated position .* the position alone is enough"):
        velocity_ratio_for(1.0, 1.0, covariance="updated")


def test_an_answer_beyond_the_kernels_says_so() -> None:
    """At this index the step of G1 ends far below the least ratio that the kernels take."""
    variance = position_variance()
    index = np.array(1e-11)
    wanted = float(variance.known_exactly(index)) * (1 + 1e-9)
    with pytest.raises(ValueError, match="must be one with a velocity ratio above 1e-12, got"):
        velocity_ratio_for(index, wanted)


@pytest.mark.alike
@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("covariance", COVARIANCES)
@pytest.mark.parametrize("index", [1e-6, 0.03, 1.0, 70.0, 1e6])
def test_limits_are_those_of_the_oracle(noise: str, covariance: str, index: float) -> None:
    shape = STEADY_STATES[noise.replace("-", "_")]["process_noise"]
    variance = position_variance(covariance, noise)
    name = f"{covariance}_11"
    known = oracle.limit(shape, index, name, "infinity", 30).value
    found = Fraction(float(variance.not_measured(np.array(index))))
    assert abs(found / fraction(known) - 1) <= BOUND
    found = Fraction(float(variance.known_exactly(np.array(index))))
    if found == 0:
        with pytest.raises(NotConverged):
            oracle.limit(shape, index, name, "zero", 30)
    else:
        known = oracle.limit(shape, index, name, "zero", 30).value
        assert abs(found / fraction(known) - 1) <= Fraction(8, 2**53)


def test_other_bad_arguments() -> None:
    with pytest.raises(ValueError, match="covariance must be one of predicted, updated"):
        velocity_ratio_for(1.0, 1.0, covariance="filtered")
    with pytest.raises(ValueError, match="position_variance_ratio must be a number above 0"):
        velocity_ratio_for(1.0, np.nan)
    with pytest.raises(ValueError, match="wanted_deviation must be a number above 0"):
        velocity_deviation_for(1.0, 1.0, 1.0, -1.0)


@pytest.mark.parametrize("covariance", COVARIANCES)
def test_in_units_there_and_back(covariance: str) -> None:
    """The answer as the velocity deviation of a filter gives that filter's position deviation."""
    interval, position, acceleration = 10.0, 100.0, 0.5
    deviations = np.array([1.0, 5.0, 20.0])
    state = steady_state(interval, position, deviations, acceleration)
    accuracy = np.sqrt(getattr(state, covariance)[:, 0, 0])
    found = velocity_deviation_for(
        interval, position, acceleration, accuracy, covariance=covariance
    )
    assert np.allclose(found, deviations, rtol=1e-13)


def no_hint(last: tuple[Reals, Reals], _before: tuple[Reals, Reals], _places: object) -> Reals:
    return np.full_like(last[0], np.nan)


def test_bracketing_ends_at_neighbours_whatever_the_function() -> None:
    """A jump has no root: the two floats beside it are found, without any hint."""
    calls = 0

    def jump(x: Reals, _places: object) -> Reals:
        nonlocal calls
        calls += 1
        return np.where(x < np.pi, 1.0, 3.0)

    (found,) = increasing_root(jump, np.array([2.0]), 1e-300, 1e300, np.ones(1), 0.0, no_hint)
    assert found < np.pi <= np.nextafter(found, 4.0)
    assert calls <= MOST_ROUNDS


def test_bracketing_survives_misleading_suggestions() -> None:
    def one_float_on(
        last: tuple[Reals, Reals], _before: tuple[Reals, Reals], _places: object
    ) -> Reals:
        return np.nextafter(last[0], np.inf)

    goal = np.array([2.0, 3.0, 1e100])
    found = increasing_root(
        lambda x, _places: x, goal, 1e-300, 1e300, np.full(3, 1e-200), 0.0, one_float_on
    )
    assert np.array_equal(np.nextafter(found, np.inf), goal) or np.array_equal(found, goal)


def test_in_units_the_limits_are_told_in_metres() -> None:
    with pytest.raises(ValueError, match="no velocity accuracy is enough") as low:
        velocity_deviation_for(10.0, 100.0, 0.5, [60.0, 30.0])
    text = str(low.value)
    assert "wanted_deviation must lie above 46.65" in text
    assert "and below 131.07" in text
    assert "got 30.0 at index 1" in text
