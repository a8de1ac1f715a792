"""The physical front: metres and seconds against an oracle in the same units, and its guards."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.position_velocity import PROCESS_NOISES, SteadyState, steady_state
from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import StateSpace, exact

ARGUMENTS = ("sampling_interval", "position_deviation", "velocity_deviation",
             "acceleration_deviation")  # fmt: skip
# bounds of the kernels and of the way to units, times the condition of the steady state with
# respect to Lambda and S (at most 2 for every entry that was met)
TOLERANCE = Fraction(1, 10**14)
DEVIATION = st.floats(-3, 3).map(lambda e: 10.0**e)


def physical_model(arguments: tuple[float, ...], process_noise: str) -> StateSpace:
    """The model in metres and seconds with exact entries, as the words describe each noise."""
    t, o, d, a = map(exact, arguments)
    one, zero = Fraction(1), Fraction(0)
    shapes = {
        "continuous-white-acceleration": ((t**4 / 3, t**3 / 2), (t**3 / 2, t**2)),
        "random-acceleration": ((t**4 / 4, t**3 / 2), (t**3 / 2, t**2)),
        "random-velocity": ((zero, zero), (zero, t**2)),
    }
    return StateSpace(
        ((one, t), (zero, one)),
        matrix(shapes[process_noise], lambda x: a * a * x),
        ((one, zero), (zero, one)),
        ((o * o, zero), (zero, d * d)),
    )


def largest_error(found: SteadyState, truth: Any) -> Fraction:
    """The largest relative error of any entry of covariances and gain."""
    worst = Fraction(0)
    for mine, known in (
        (found.predicted, truth.predicted),
        (found.updated, truth.updated),
        (found.gain, truth.gain),
    ):
        for i in range(2):
            for j in range(2):
                true = fraction(known[i][j])
                worst = max(worst, abs(Fraction(float(mine[i, j])) / true - 1))
    return worst


@pytest.mark.parametrize("process_noise", sorted(PROCESS_NOISES))
@settings(max_examples=samples(4), deadline=None)
@given(arguments=st.tuples(DEVIATION, DEVIATION, DEVIATION, DEVIATION))
def test_entries_are_those_of_the_riccati_equation_in_units(
    process_noise: str, arguments: tuple[float, float, float, float]
) -> None:
    truth = doubling.steady_state(physical_model(arguments, process_noise), 30).state
    assert largest_error(steady_state(*arguments, process_noise), truth) < TOLERANCE


def test_another_noise_or_another_interval_is_seen() -> None:
    arguments = (2.0, 50.0, 10.0, 3.0)
    truth = doubling.steady_state(physical_model(arguments, "random-acceleration"), 30).state
    assert largest_error(steady_state(*arguments, "random-acceleration"), truth) < TOLERANCE
    for wrong in (
        steady_state(*arguments),
        steady_state(2.0 * (1 + 1e-12), 50.0, 10.0, 3.0, "random-acceleration"),
    ):
        assert largest_error(wrong, truth) > TOLERANCE


def test_units_of_another_length_and_time_change_only_the_units() -> None:
    """Powers of two: exactly."""
    metres, twice = steady_state(2.0, 50.0, 10.0, 3.0), steady_state(4.0, 400.0, 40.0, 6.0)
    # lengths times 8, times times 2
    units = 64.0 / np.array([[1.0, 2.0], [2.0, 4.0]])
    assert np.array_equal(twice.predicted, metres.predicted * units)
    assert np.array_equal(twice.updated, metres.updated * units)
    assert np.array_equal(twice.gain, metres.gain * [[1.0, 2.0], [0.5, 1.0]])


def test_arrays_are_broadcast_and_equal_the_numbers_one_by_one() -> None:
    intervals, deviations = np.array([[1.0], [2.0], [5.0]]), np.array([0.5, 3.0])
    found = steady_state(intervals, 10.0, deviations, 0.1)
    assert found.predicted.shape == found.updated.shape == found.gain.shape == (3, 2, 2, 2)
    assert found.tracking_index.shape == found.velocity_ratio.shape == (3, 2)
    for i in range(3):
        for j in range(2):
            one = steady_state(float(intervals[i, 0]), 10, float(deviations[j]), 0.1)
            assert np.array_equal(found.predicted[i, j], one.predicted)
            assert np.array_equal(found.gain[i, j], one.gain)


def test_nothing_overflows_on_the_way_to_an_ordinary_index() -> None:
    """T^2 underflows, sigma_a overflows when squared: Lambda is 1, S is 1."""
    found = steady_state(1e-170, 1e-100, 1e70, 1e240)
    plain = steady_state(1.0, 1.0, 1.0, 1.0)
    assert np.isclose(found.tracking_index, 1.0, rtol=1e-12)
    assert np.isclose(found.gain[0, 0], plain.gain[0, 0], rtol=1e-12)
    assert np.isclose(found.predicted[0, 0] / 1e-200, plain.predicted[0, 0], rtol=1e-12)


def test_what_no_float_can_hold_is_infinite_or_zero_and_never_nan() -> None:
    huge = steady_state(1.0, 1e200, 1e200, 1e200)
    assert np.all(np.isinf(huge.predicted))
    tiny = steady_state(1.0, 1e-200, 1e-200, 1e-200)
    assert np.all(tiny.predicted == 0)
    for found in (huge, tiny):
        assert np.all(np.isfinite(found.gain))
        assert not np.any(np.isnan(found.updated))


@pytest.mark.parametrize("name", ARGUMENTS)
@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan, np.inf])
def test_an_argument_out_of_its_domain_is_named(name: str, bad: float) -> None:
    arguments: dict[str, Any] = dict.fromkeys(ARGUMENTS, 1.0)
    with pytest.raises(ValueError, match=f"{name} must be a number above 0 and finite, got"):
        steady_state(**{**arguments, name: bad})
    place = np.array([[1.0, 1.0], [bad, 1.0]])
    with pytest.raises(ValueError, match=r"at index \(1, 0\)"):
        steady_state(**{**arguments, name: place})


def test_other_bad_arguments() -> None:
    with pytest.raises(ValueError, match="shapes do not fit together: sampling_interval"):
        steady_state([1.0, 2.0], [1.0, 2.0, 3.0], 1.0, 1.0)
    with pytest.raises(TypeError, match="velocity_deviation must be real numbers, got complex128"):
        steady_state(1.0, 1.0, 1j, 1.0)
    with pytest.raises(ValueError, match="process_noise must be one of continuous-white"):
        steady_state(1.0, 1.0, 1.0, 1.0, "white")
    with pytest.raises(
        ValueError,
        match=r"tracking_index = acceleration_deviation .* got inf",
    ):
        steady_state(1e200, 1e-200, 1.0, 1.0)
    with pytest.raises(ValueError, match=r"velocity_ratio = .* 1e\+20 at index 1"):
        steady_state(1.0, 1.0, [1.0, 1e20], 1.0)


def test_the_index_of_numbers_is_a_number() -> None:
    found = steady_state(2.0, 1.0, 1.0, 1.0)
    assert isinstance(found.tracking_index, float)
    assert isinstance(found.velocity_ratio, float)
