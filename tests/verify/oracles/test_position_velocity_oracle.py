"""With position and velocity measured, the general oracles agree with one another.

They share the matrices and nothing else. Three process noises, one of them with a variance of
rank one and without noise on the position.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES
from one_of_each import cases, further
from samples import samples
from vector_rounding import allowance

from gainproof.verify.oracles import doubling, noise, recursion, solver
from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState

NOISES: Mapping[str, Any] = {name: model["process_noise"] for name, model in STEADY_STATES.items()}
SOURCE = NOISES["continuous_white_acceleration"]
FAMILIES = cases(sorted(NOISES), lambda family: family == "continuous_white_acceleration")
TEN = Fraction(10)
CORNERS = [(i, s) for i in (-6, 0, 6) for s in (-6, 0, 6)]
# where a run in float64 settles within some thousand samples and keeps half of its digits
INDICES = st.floats(-10, 6).map(lambda e: 2.0**e)
RATIOS = st.floats(-6, 6).map(lambda e: 2.0**e)


def exactly(state: SteadyState) -> dict[str, Fraction]:
    """Entries of a multiprecision or float run as the fractions they are."""
    return {
        name: Fraction(x) if isinstance(x, float) else fraction(x)
        for name, x in oracle.named(state).items()
    }


def apart(one: SteadyState, other: SteadyState) -> float:
    """The largest relative difference of any entry."""
    left, right = exactly(one), exactly(other)
    return max(float(abs(left[name] / right[name] - 1)) for name in right)


def close(run: SteadyState, model: StateSpace, truth: SteadyState) -> bool:
    """Within the rounding errors of a float64 run."""
    allowed = allowance(model, truth)
    found, known = exactly(run), exactly(truth)
    return all(
        float(abs(found[name] - known[name])) <= allowed[name.split("_")[0]] for name in known
    )


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize(("index", "ratio"), CORNERS)
def test_doubling_gives_two_hundred_digits_over_the_whole_domain(
    family: str, index: int, ratio: int
) -> None:
    """The runs behind the two answers differ in precision, and each has checked itself by the
    Newton correction of its residual.
    """
    model = oracle.model(NOISES[family], TEN**index, TEN**ratio)
    many = doubling.steady_state(model, 200).state
    assert apart(doubling.steady_state(model, 60).state, many) < 1e-59


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(6), deadline=None)
@given(index=st.floats(-3, 6).map(lambda e: 2.0**e), ratio=RATIOS)
def test_recursion_in_multiprecision_agrees_with_doubling(
    family: str, index: float, ratio: float
) -> None:
    model = oracle.model(NOISES[family], index, ratio)
    run = recursion.run_multiprecision(model, 60).state
    assert apart(run, doubling.steady_state(model, 60).state) < 1e-57


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(6), deadline=None)
@given(index=INDICES, ratio=RATIOS)
def test_float_runs_agree_with_doubling(family: str, index: float, ratio: float) -> None:
    model = oracle.model(NOISES[family], index, ratio)
    truth = doubling.steady_state(model).state
    assert close(recursion.run_float(model).state, model, truth)
    assert close(solver.steady_state(model).state, model, truth)


MILLIONTH = Fraction(10**6 + 1, 10**6)
BREAKS: Mapping[str, StateSpace] = {
    "process noise": oracle.model([["1/3", "1/2"], ["1/2", MILLIONTH]], 1, 1),
    "tracking index": oracle.model(SOURCE, MILLIONTH, 1),
    "velocity ratio": oracle.model(SOURCE, 1, MILLIONTH),
}
RUNS: Mapping[str, Callable[[StateSpace], SteadyState]] = {
    "doubling": lambda model: doubling.steady_state(model).state,
    "recursion in float64": lambda model: recursion.run_float(model).state,
    "recursion in multiprecision": lambda model: recursion.run_multiprecision(model).state,
    "solver": lambda model: solver.steady_state(model).state,
}


@pytest.mark.parametrize("broken", sorted(BREAKS))
@pytest.mark.parametrize("run", sorted(RUNS))
def test_a_model_broken_in_the_sixth_digit_is_detected(broken: str, run: str) -> None:
    model = oracle.model(SOURCE, 1, 1)
    truth = doubling.steady_state(model).state
    assert close(RUNS[run](model), model, truth)
    assert not close(RUNS[run](BREAKS[broken]), model, truth)


@pytest.mark.parametrize("run", sorted(RUNS))
def test_the_filter_of_position_alone_is_another_one(run: str) -> None:
    both = RUNS[run](oracle.model(SOURCE, 1, 1))
    alone = oracle.named(RUNS[run](oracle.position_only(SOURCE, 1)))
    assert float(alone["predicted_11"]) > 1.5 * float(oracle.named(both)["predicted_11"])
    assert "gain_12" not in alone


def test_the_source_s_noise_is_white_acceleration_integrated() -> None:
    integrated = noise.white(*noise.chain(2))
    for row, known in zip(SOURCE, integrated, strict=True):
        for x, y in zip(row, known, strict=True):
            assert abs(Fraction(x) - fraction(y)) < Fraction(1, 10**39)


@pytest.mark.parametrize("index", [TEN**-6, further(Fraction(1)), TEN**6])
def test_without_velocity_the_limit_is_the_filter_of_position_alone(index: Fraction) -> None:
    """Two ways: S grows, or the row is left out of the measurement matrix."""
    alone = oracle.named(doubling.steady_state(oracle.position_only(SOURCE, index), 60).state)
    for name in sorted(alone):
        found = oracle.limit(SOURCE, index, name, "infinity", 50)
        assert found.apart < 1e-50
        assert abs(fraction(found.value) / fraction(alone[name]) - 1) < Fraction(1, 10**50)


def test_a_limit_that_is_zero_is_refused() -> None:
    for name, side in (("updated_22", "zero"), ("updated_12", "zero"), ("gain_12", "infinity")):
        with pytest.raises(NotConverged, match="no limit other than 0"):
            oracle.limit(SOURCE, 1, name, side)


@pytest.mark.parametrize(("index", "ratio"), [(0, 1), (1, 0), (-1, 1), (1, -2)])
def test_parameters_must_be_positive(index: int, ratio: int) -> None:
    with pytest.raises(ValueError, match="must be positive"):
        oracle.model(SOURCE, index, ratio)
