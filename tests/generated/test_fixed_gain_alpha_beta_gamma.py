"""Kernels of alpha-beta-gamma filters against oracles that know F, H and K only."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from fixed_gain_points import WORKING, kernels_of, worst_excess
from fixed_gain_triples import AlphaBetaGammaTruth
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import truth_at
from one_of_each import cases
from printed_kernels import DTYPES, EPSILON, printed_kernels
from samples import samples

from gainproof.generated import alpha_beta_gamma
from gainproof.verify.oracles.fixed_gain import (
    ball,
    errors_at,
    predicted,
    root_moduli,
    steady_errors,
    updated,
    variance_slope,
)

KERNELS = kernels_of("alpha_beta_gamma")
NAMED = [kernel for kernel in printed_kernels() if kernel.family == "alpha_beta_gamma"]
SMALL = st.floats(-4.5, -0.01).map(lambda e: 10.0**e)
PART = st.one_of(SMALL, st.floats(0.01, 0.999))
PLACE = st.floats(-3, 3).map(lambda e: 10.0**e)
WORDS = ("position", "velocity", "acceleration")


def rounded(dtype: str, *values: float) -> list[Any]:
    kind = np.dtype(dtype).type
    return [kind(value) for value in values]


def gains_of(alpha: flint.arb, beta: flint.arb, share: flint.arb) -> list[flint.arb]:
    """gamma is that share of the largest stable one, by the meaning of the share."""
    return [alpha, beta, share * 2 * alpha * beta / (2 - alpha)]


def covariances(gains: list[flint.arb]) -> dict[str, flint.arb]:
    found = {}
    for kind, p in (("predicted", predicted(gains)), ("updated", updated(gains))):
        for i in range(3):
            for j in range(i, 3):
                found[f"{kind}_{i + 1}{j + 1}"] = p[i, j]
    return found


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(8), deadline=None)
@given(PART, st.one_of(SMALL, st.floats(0.01, 1.99)), PART)
def test_variances(dtype: str, alpha: float, beta: float, share: float) -> None:
    given_ = rounded(dtype, alpha, beta, share)
    with flint.ctx.workprec(WORKING):
        gains = gains_of(*(ball(float(x)) for x in given_))
        truth = covariances(gains)
        a, b, c = gains
        # the sums of the terms whose differences these are: signs of a term turned
        g, m = 2 * a * b - c * (2 - a), 4 - 2 * a - b
        truth["updated_12_scale"] = b * (2 * a + b) * (2 * b - c) / (g * m)
        truth["updated_13_scale"] = c * (2 * g + b * (2 * b - c)) / (g * m)
        assert worst_excess(KERNELS["variances"], dtype, given_, truth) <= 1


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(8), deadline=None)
@given(PLACE, PLACE, PLACE)
def test_the_whole_region_by_its_coordinates(dtype: str, x: float, d: float, m: float) -> None:
    given_ = rounded(dtype, x, d, m)
    with flint.ctx.workprec(WORKING):
        x_, d_, m_ = (ball(float(value)) for value in given_)
        y = (d_ + m_) / x_
        gamma = 8 / (1 + x_ + y + d_)
        gains = [gamma * (1 + y) / 4, gamma * x_ / 2, gamma]
        named: dict[str, flint.arb] = dict(zip(("alpha", "beta", "gamma"), gains, strict=True))
        assert worst_excess(KERNELS["gains_of_coordinates"], dtype, given_, named) <= 1
        truth = covariances(gains)
        assert worst_excess(KERNELS["variances_of_coordinates"], dtype, given_, truth) <= 1
        both = d_ * m_ / 8
        truth["updated_12_scale"] = x_ * (x_ + 1) * (1 + x_ + y) / 4 / both
        truth["updated_13_scale"] = (m_ + x_ + x_**2) / 2 / both
        truth["updated_23_scale"] = x_ * (x_ + 1) / both
        updated_ = KERNELS["updated_variances_of_coordinates"]
        assert worst_excess(updated_, dtype, given_, truth) <= 1


@settings(max_examples=samples(20), deadline=None)
@given(PLACE, PLACE, PLACE)
def test_all_places_of_the_region_are_stable_and_come_back(x: float, d: float, m: float) -> None:
    gains = [float(gain) for gain in alpha_beta_gamma.gains_of_coordinates(x, d, m)]
    # so near the border that rounded gains decide: left to the certificate
    if min(x, d, m) > 1e-2 and max(x, d, m) < 1e2:
        assert root_moduli(gains)[0] < 1


@pytest.mark.parametrize("dtype", cases(DTYPES, lambda dtype: dtype == "float64"))
@settings(max_examples=samples(4), deadline=None)
@given(st.floats(0.2, 0.95), st.floats(0.05, 1.5), st.floats(0.05, 0.9))
def test_lags_are_those_of_a_run(dtype: str, alpha: float, beta: float, share: float) -> None:
    given_ = rounded(dtype, alpha, beta, share)
    a, b, s = (Fraction(float(x)) for x in given_)
    gains = [a, b, s * 2 * a * b / (2 - a)]
    if root_moduli([float(x) for x in gains])[0] > 0.97:
        return
    ahead, after = steady_errors(gains, 3)
    truth = {f"predicted_{word}_lag": x for word, x in zip(WORDS, ahead, strict=True)}
    truth |= {f"updated_{word}_lag": x for word, x in zip(WORDS, after, strict=True)}
    with flint.ctx.workprec(WORKING):
        balls = {name: flint.arb(str(x)) for name, x in truth.items()}
        assert worst_excess(KERNELS["lags"], dtype, given_, balls) <= 1


GAINS = [Fraction(1, 2), Fraction(1, 4), Fraction(1, 16)]


@pytest.mark.parametrize("order", [0, 1, 2])
def test_no_lag_up_to_constant_acceleration(order: int) -> None:
    assert all(abs(x) < 1e-40 for x in errors_at(GAINS, order, 2000))


def test_the_error_behind_a_snap_grows_by_the_reciprocal_of_gamma_a_sample() -> None:
    one, other = (errors_at(GAINS, 4, samples)[0] for samples in (1500, 1600))
    assert abs((other - one) / 100 - 16) < 1e-35


@pytest.mark.parametrize("lag", [0.13, 0.5, 2.0, 1e3, 1e8])
def test_minimum_variance_has_no_slope_at_its_lag(lag: float) -> None:
    """The oracle's derivatives along alpha and beta vanish at the truth the kernels are held to."""
    found = AlphaBetaGammaTruth().at("lag", lag)
    with flint.ctx.workprec(WORKING):
        gains = [
            found[f"minimum_variance_{name}"].value.mid() for name in ("alpha", "beta", "gamma")
        ]
        gains = [flint.arb(gain) for gain in gains]
        variance = predicted(gains)[0, 0]
        for place in range(2):
            # a relative change of a gain by 1e-15 changes the variance by far less than that
            assert abs(variance_slope(gains, place) * gains[place] / variance) < 1e-30


def test_minimum_variance_is_best_among_many_of_its_lag() -> None:
    for lag in (0.2, 1.0, 30.0):
        least = float(alpha_beta_gamma.minimum_variance_by_lag(lag).minimum_variance_predicted_11)
        gamma = 1 / lag
        for step in range(1, 15):
            for other in range(1, 15):
                alpha = 2 * step / 15
                beta = (4 - 2 * alpha) * other / 15
                if gamma * (1 - alpha / 2) < alpha * beta * 0.999:
                    found = predicted([ball(alpha), ball(beta), ball(gamma)])[0, 0]
                    assert float(found.mid()) >= least * (1 - 1e-12)


@pytest.mark.parametrize("alpha", [1e-4, 0.3, 0.9, 0.999])
def test_relations_are_those_of_the_kalman_filter(alpha: float) -> None:
    """The filter that the Riccati equation of the model gives, at the index of that alpha."""
    kalman = truth_at("acceleration_increments", "alpha", alpha)
    found = AlphaBetaGammaTruth().at("alpha", alpha)
    for gain in ("beta", "gamma"):
        assert abs(kalman[gain].value - found[f"random_acceleration_{gain}"].value) < 1e-20


@pytest.mark.parametrize("alpha", [1e-4, 0.3, 0.9, 0.999])
def test_random_jerk_is_that_of_its_kalman_filter(alpha: float) -> None:
    kalman = truth_at("random_jerk", "alpha", alpha)
    found = AlphaBetaGammaTruth().at("alpha", alpha)
    for gain in ("beta", "gamma"):
        assert abs(kalman[gain].value - found[f"random_jerk_{gain}"].value) < 1e-20


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("kernel", NAMED, ids=lambda kernel: kernel.id)
def test_each_named_filter_near_its_borders(kernel: Any, dtype: str) -> None:
    kind = np.dtype(dtype).type
    low, high = kernel.domain[dtype]
    near = [low * (1 + 2.0**-e) for e in range(3, 20, 5)] + [high * (1 - 2.0**-e) for e in (4, 19)]
    for place in {low, high, *near}:
        exact = float(kind(place))
        truth = AlphaBetaGammaTruth().at(kernel.argument, exact)
        for output, value in zip(kernel.outputs, kernel.function(kind(exact)), strict=True):
            bound = kernel.promises[dtype][output].bound * EPSILON[dtype]
            with flint.ctx.workprec(WORKING):
                error = abs(ball(float(value)) / truth[output].value - 1)
                assert error < ball(bound), (output, exact)


@pytest.mark.parametrize("alpha", [0.1, 0.5, 0.9, 0.99])
def test_the_order_of_the_three_at_equal_lag(alpha: float) -> None:
    """Random jerk from its Riccati equation; random acceleration of its gamma, by bisection."""
    jerk = truth_at("random_jerk", "alpha", alpha)
    with flint.ctx.workprec(WORKING):
        gains = [flint.arb(jerk[name].value.mid()) for name in ("alpha", "beta", "gamma")]
        second, gamma = float(predicted(gains)[0, 0].mid()), float(gains[2].mid())
    first = float(alpha_beta_gamma.minimum_variance_by_lag(1 / gamma).minimum_variance_predicted_11)
    low, high = 1e-9, 1 - 1e-12
    for _ in range(200):
        middle = (low + high) / 2
        found = alpha_beta_gamma.random_acceleration_by_gain(middle)
        low, high = (middle, high) if found.random_acceleration_gamma < gamma else (low, middle)
    third = float(
        alpha_beta_gamma.random_acceleration_by_gain(low).random_acceleration_predicted_11
    )
    assert first < second < third
