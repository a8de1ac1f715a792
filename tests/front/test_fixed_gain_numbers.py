"""Variances, lags and poles of any stable gains against Kronecker products in balls, long runs and
eigenvalues; inside the kernels' domain and beyond it.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.fixed_gain import three_states, two_states
from gainproof.fixed_gain.settling import samples_to_settle
from gainproof.fixed_gain.stability import is_stable
from gainproof.verify.oracles.fixed_gain import (
    ball,
    predicted,
    root_moduli,
    steady_errors,
    updated,
)

TWO = [(0.095, 0.01), (0.4571, 0.5), (0.9999, 1.9), (1.0, 1.0), (1.5, 0.5), (0.3, 3.3), (1.9, 0.1)]
THREE = [(0.3, 0.05, 0.004), (0.9, 1.5, 1.2), (1.0, 0.5, 0.2), (1.6, 0.6, 0.4), (0.2, 3.5, 0.7)]
# near the border of stability the truth changes by 2^-52 of the gains times their distance to it
NEAR = [(1.2, 1.6 - 1e-9), (0.5, 2.9999999), (0.3, 3.4 - 1e-9), (0.1, 3.8 - 1e-12)]
NEAR_THREE = [
    (0.3, 0.2, 0.3 * 0.2 / 0.85 * (1 - 1e-5)),
    (0.3, 0.2, 0.3 * 0.2 / 0.85 * (1 - 1e-9)),
    (1.3, 0.4, 0.52 / 0.35 * (1 - 1e-10)),
]


def covariance(matrix: flint.arb_mat) -> list[flint.arb]:
    size = matrix.nrows()
    return [matrix[i, j] for i in range(size) for j in range(i, size)]


def compare(gains: Sequence[float], found: Sequence[object], tolerance: float) -> None:
    """Entries over the product of deviations before the update."""
    with flint.ctx.workprec(400):
        exact = [ball(Fraction(gain)) for gain in gains]
        before = covariance(predicted(exact))
        after = covariance(updated(exact))[: len(found) - len(before)]
        size = len(gains)
        matrix = predicted(exact)
        places = [(i, j) for i in range(size) for j in range(i, size)]
        scales = [(matrix[i, i] * matrix[j, j]).sqrt() for i, j in places]
        for value, truth, scale in zip(found, [*before, *after], [*scales, *scales], strict=False):
            error = abs((ball(float(value)) - truth) / scale)  # type: ignore[arg-type]
            assert error < tolerance, (gains, value, truth)


INNER = st.one_of(
    st.floats(1e-3, 0.999),
    st.floats(-9.0, -1.0).map(lambda e: 1 - 10.0**e),
    st.floats(-6.0, -1.0).map(lambda e: 10.0**e),
)
"""Shares of what a border allows: anywhere, next to it, next to 0."""


@settings(max_examples=samples(30), deadline=None)
@given(INNER, INNER, INNER)
def test_the_whole_region_up_to_its_borders(first: float, second: float, third: float) -> None:
    """Gains are floats; the border they are near to is decided by them, not by the shares."""
    alpha = 2 * first
    beta = (4 - 2 * alpha) * second
    gamma = alpha * beta / (1 - alpha / 2) * third
    if is_stable(alpha, beta):
        compare((alpha, beta), two_states.variances(alpha, beta), 14 * 2.0**-52)
    if is_stable(alpha, beta, gamma):
        found = three_states.variances(alpha, beta, gamma)
        compare((alpha, beta, gamma), found, 32 * 2.0**-52)


@pytest.mark.parametrize("gains", TWO)
def test_variances_of_two_states(gains: tuple[float, float]) -> None:
    """At most 6 * 2^-52 by the kernels, 8 more for rounded coordinates."""
    compare(gains, two_states.variances(*gains), 14 * 2.0**-52)


@pytest.mark.parametrize("gains", NEAR)
def test_variances_next_to_the_border(gains: tuple[float, float]) -> None:
    """What is left to the border is found exactly, so that nothing is lost there."""
    compare(gains, two_states.variances(*gains), 14 * 2.0**-52)


@pytest.mark.parametrize("gains", NEAR_THREE)
def test_variances_of_three_states_next_to_the_border(gains: tuple[float, float, float]) -> None:
    compare(gains, three_states.variances(*gains), 32 * 2.0**-52)


@pytest.mark.parametrize("gains", THREE)
def test_variances_of_three_states(gains: tuple[float, float, float]) -> None:
    compare(gains, three_states.variances(*gains), 32 * 2.0**-52)


@pytest.mark.parametrize(
    "gains", [(0.4571, 0.5), (1.5, 0.5), (0.3, 3.3), (0.9, 1.5, 1.2), (1.6, 0.6, 0.4)]
)
def test_lags_as_long_runs_leave_them(gains: tuple[float, ...]) -> None:
    """Behind t^2/2, of three states t^3/6: unit acceleration and unit jerk."""
    found = two_states.lags(*gains) if len(gains) == 2 else three_states.lags(*gains)
    before, after = steady_errors([Fraction(gain) for gain in gains], len(gains), digits=25)
    for value, truth in zip(found, [*before, *after], strict=True):
        assert abs(float(value) - float(truth)) < 1e-13 * max(abs(float(before[1])), 1)


@pytest.mark.parametrize("gains", [*TWO, (0.5, 0.5, 0.1), (0.9, 1.5, 1.2), (1.6, 0.6, 0.4)])
def test_poles_have_the_moduli_of_the_loop(gains: tuple[float, ...]) -> None:
    found = two_states.poles(*gains) if len(gains) == 2 else three_states.poles(*gains)
    moduli = np.abs(found)
    assert moduli == pytest.approx(root_moduli(gains), abs=2e-7)
    assert moduli[0] == max(moduli)


def test_poles_of_gains_that_are_not_stable() -> None:
    assert np.abs(two_states.poles(0.5, 3.2)[0]) > 1
    assert samples_to_settle(two_states.poles(0.5, 3.2)) == np.inf


def test_arrays_are_mixed_from_inside_and_beyond() -> None:
    """Element by element what single gains give, whatever stands beside them."""
    alpha, beta = np.array([[0.4571, 1.5], [0.3, 0.095]]), np.array([[0.5, 0.5], [3.3, 0.01]])
    for function in (two_states.variances, two_states.lags):
        whole = function(alpha, beta)
        for place in np.ndindex(2, 2):
            single = function(alpha[place], beta[place])
            assert [np.asarray(x)[place] for x in whole] == list(single)
    assert two_states.poles(alpha, beta).shape == (2, 2, 2)
    assert np.shape(two_states.variances(np.empty(0), 0.5).predicted_11) == (0,)


@pytest.mark.parametrize("function", [two_states.variances, two_states.lags])
def test_gains_that_are_not_stable_have_no_variance_and_no_lag(function: object) -> None:
    with pytest.raises(ValueError, match=r"index 2: beta < 4 - 2 alpha fails: beta = 3.2"):
        function([0.1, 0.2, 0.5], [0.1, 0.1, 3.2])  # type: ignore[operator]


def test_stable_gains_that_no_kernel_reaches_are_named() -> None:
    with pytest.raises(ValueError, match=r"beyond the reach of the kernels: alpha = 1e-200"):
        two_states.variances([0.1, 1e-200], [0.1, 1e-100])
    with pytest.raises(ValueError, match=r"alpha = 1e-300, .* at index \(1, 1\)"):
        three_states.variances([[0.1, 1.2], [0.1, 1e-300]], 0.1, [[1e-3, 1e-3], [1e-3, 1e-310]])


def test_gains_too_small_for_coordinates_are_left_to_the_kernel() -> None:
    """A share of 0.9 with gains of 1e-12: what is left to the border loses less than 4 bits."""
    gains = 1e-12, 1e-13, 9e-26
    compare(gains, three_states.variances(*gains), 64 * 2.0**-52)
    both = three_states.variances(
        *([each, other] for each, other in zip(gains, THREE[0], strict=True))
    )
    assert both.predicted_11[0] == three_states.variances(*gains).predicted_11  # type: ignore[index]


def test_settling_counts_powers_of_the_largest_modulus() -> None:
    poles = np.array([[0.5, 0.1], [0.99, -0.2], [0.0, 0.0], [0.1, 0.0], [1.0, 0.0]])
    counted = samples_to_settle(poles)
    for row, count in zip(poles, counted, strict=True):
        largest = abs(row).max()
        if largest == 0:
            assert count == 2  # x_2 = A^2 x_0 = 0, and A is not 0
        elif largest < 1:
            assert largest**count <= 0.01 * (1 + 1e-12)
            assert count == 1 or largest ** (count - 1) > 0.01 * (1 - 1e-12)
        else:
            assert count == np.inf
    assert samples_to_settle(poles, 0.5)[0] == 1
    for wrong in (0, 1, -1, float("nan")):
        with pytest.raises(ValueError, match="share must be"):
            samples_to_settle(poles, wrong)
    with pytest.raises(ValueError, match="must hold the poles"):
        samples_to_settle(0.5)
    with pytest.raises(ValueError, match="poles must be finite"):
        samples_to_settle([float("nan")])
    with pytest.raises(TypeError, match="poles must be numbers"):
        samples_to_settle(["a"])


def test_a_start_is_gone_after_as_many_samples_as_poles_at_0() -> None:
    """F (I - K H) of alpha = beta = 1 and of alpha = 1, beta = 3/2, gamma = 1 written out."""
    two = np.array([[-1.0, 1.0], [-1.0, 1.0]])
    assert not (two @ two).any()
    assert samples_to_settle(two_states.poles(1, 1)) == 2
    moving = np.array([[1, 1, 0.5], [0, 1, 1], [0, 0, 1]])
    three = moving @ np.array([[0, 0, 0], [-1.5, 1, 0], [-1, 0, 1]])
    assert (three @ three).any()
    assert not (three @ three @ three).any()
    assert samples_to_settle(three_states.poles(1, 1.5, 1)) == 3


@pytest.mark.filterwarnings("error")
def test_huge_numbers_are_decided_or_refused_without_a_warning() -> None:
    assert not is_stable(1e155, 1e155, -1e155)
    for function, gains in (
        (two_states.poles, (1e308, 1e308)),
        (two_states.poles, (1e155, 1.0)),
        (three_states.poles, (1.0, [1.0, 1e308], 1.0)),
    ):
        with pytest.raises(ValueError, match="poles are computed for gains from -1e100 to 1e100"):
            function(*gains)
    assert np.isfinite(two_states.poles(1e100, -1e100)).all()
    assert np.isfinite(three_states.poles(1e100, -1e100, 1e100)).all()
    if np.finfo(np.longdouble).max > np.finfo(np.float64).max:
        with pytest.raises(ValueError, match="alpha must be a number that float64 holds"):
            two_states.variances(np.longdouble("1e4000"), 0.3)
