"""Kernels of alpha-beta filters against oracles that know F, H and K only."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Any

import flint
import numpy as np
import pytest
from fixed_gain_points import WORKING, kernels_of, worst_excess
from fixed_gain_truth import AlphaBetaTruth
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import truth_at
from one_of_each import cases
from printed_kernels import DTYPES, EPSILON, printed_kernels
from samples import samples

from gainproof.generated import alpha_beta
from gainproof.verify.oracles.fixed_gain import (
    ball,
    errors_at,
    predicted,
    root_moduli,
    steady_errors,
    updated,
)

KERNELS = kernels_of("alpha_beta")
NAMED = [kernel for kernel in printed_kernels() if kernel.family == "alpha_beta"]
SMALL = st.floats(-9, 0).map(lambda e: 10.0**e)
ALPHA = st.one_of(SMALL, st.floats(1e-3, 0.9999)).map(lambda x: min(x, 0.9999))
BETA = st.one_of(SMALL, st.floats(1e-3, 1.9999))
PLACE = st.floats(-8, 8).map(lambda e: 10.0**e)


def rounded(dtype: str, *values: float) -> list[Any]:
    kind = np.dtype(dtype).type
    return [kind(value) for value in values]


def covariances(alpha: flint.arb, beta: flint.arb) -> dict[str, flint.arb]:
    found = {}
    for kind, p in (("predicted", predicted((alpha, beta))), ("updated", updated((alpha, beta)))):
        for i, j in ((0, 0), (0, 1), (1, 1)):
            found[f"{kind}_{i + 1}{j + 1}"] = p[i, j]
    return found


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(12), deadline=None)
@given(ALPHA, BETA)
def test_variances(dtype: str, alpha: float, beta: float) -> None:
    given_ = rounded(dtype, alpha, beta)
    with flint.ctx.workprec(WORKING):
        truth = covariances(*(ball(float(x)) for x in given_))
        assert worst_excess(KERNELS["variances"], dtype, given_, truth) <= 1


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(12), deadline=None)
@given(PLACE, PLACE)
def test_the_whole_region_by_its_coordinates(dtype: str, x: float, y: float) -> None:
    """The gains are those whose characteristic polynomial has x and y, by their definition."""
    given_ = rounded(dtype, x, y)
    with flint.ctx.workprec(WORKING):
        x_, y_ = (ball(float(value)) for value in given_)
        # c(1) = beta, and d(s) = beta (1 + x s + y s^2) with d(1) = 4
        beta = 4 / (1 + x_ + y_)
        alpha = beta * x_ / 2
        assert (
            worst_excess(
                KERNELS["gains_of_coordinates"], dtype, given_, {"alpha": alpha, "beta": beta}
            )
            <= 1
        )
        truth = covariances(alpha, beta)
        assert worst_excess(KERNELS["variances_of_coordinates"], dtype, given_, truth) <= 1


def test_a_wrong_variance_is_noticed() -> None:
    with flint.ctx.workprec(WORKING):
        truth = covariances(ball(0.3), ball(0.2))
        truth["predicted_22"] = truth["predicted_22"] * (1 + ball(2.0**-48))
        assert worst_excess(KERNELS["variances"], "float64", (0.3, 0.2), truth) > 1


SLOW = 0.02  # of the largest pole's distance from 1, so that runs end


@pytest.mark.parametrize("dtype", cases(DTYPES, lambda dtype: dtype == "float64"))
@settings(max_examples=samples(6), deadline=None)
@given(st.floats(0.05, 0.95), st.floats(0.02, 1.9))
def test_lags_are_those_of_a_run(dtype: str, alpha: float, beta: float) -> None:
    given_ = rounded(dtype, alpha, beta)
    gains = [Fraction(float(x)) for x in given_]
    if root_moduli([float(x) for x in given_])[0] > 1 - SLOW:
        return
    ahead, after = steady_errors(gains, 2)
    words = ("position", "velocity")
    truth = {f"predicted_{word}_lag": x for word, x in zip(words, ahead, strict=True)}
    truth |= {f"updated_{word}_lag": x for word, x in zip(words, after, strict=True)}
    with flint.ctx.workprec(WORKING):
        balls = {name: flint.arb(str(x)) for name, x in truth.items()}
        assert worst_excess(KERNELS["lags"], dtype, given_, balls) <= 1


@pytest.mark.parametrize("order", [0, 1])
def test_no_lag_behind_rest_and_constant_velocity(order: int) -> None:
    ahead, after = steady_errors([Fraction(1, 2), Fraction(1, 4)], order)
    assert all(abs(x) < 1e-45 for x in (*ahead, *after))


def test_the_error_behind_a_jerk_grows_by_the_reciprocal_of_beta_a_sample() -> None:
    gains = [Fraction(1, 2), Fraction(1, 4)]
    one, other = (errors_at(gains, 3, samples)[0] for samples in (900, 1000))
    assert abs((other - one) / 100 - 4) < 1e-40


@settings(max_examples=samples(12), deadline=None)
@given(ALPHA, BETA)
def test_poles_are_the_eigenvalues(alpha: float, beta: float) -> None:
    half, modulus, square = map(float, alpha_beta.closed_loop_poles(alpha, beta))
    root = complex(square) ** 0.5
    found = sorted((abs(half + root), abs(half - root)), reverse=True)
    # a double root moves by the root of the rounding
    assert np.allclose(found, root_moduli([alpha, beta]), atol=1e-7)
    assert abs(found[0] * found[1] - modulus**2) < 1e-12
    assert found[0] < 1


@pytest.mark.parametrize("alpha", [1e-6, 0.3, 0.5, 0.9, 0.999])
@pytest.mark.parametrize("name", ["random_velocity", "random_acceleration"])
def test_relations_are_those_of_the_kalman_filters(name: str, alpha: float) -> None:
    """The filter that the Riccati equation of the model gives, at the index of that alpha."""
    beta = truth_at(name, "alpha", alpha)["beta"].value
    assert abs(beta - AlphaBetaTruth().at("alpha", alpha)[f"{name}_beta"].value) < 1e-20


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kernel", "dtype"),
    cases(product(NAMED, DTYPES), lambda case: case[1] == "float64" or case[0] is NAMED[0]),
    ids=lambda given_: getattr(given_, "id", given_),
)
def test_each_named_filter_on_its_own_domain(kernel: Any, dtype: str) -> None:
    """Near its borders too, where the others do not exist."""
    kind = np.dtype(dtype).type
    low, high = kernel.domain[dtype]
    near = [low * (1 + 2.0**-e) for e in range(3, 20, 5)] + [high * (1 - 2.0**-e) for e in (4, 19)]
    for place in {low, high, *near}:
        exact = float(kind(place))
        truth = AlphaBetaTruth().at(kernel.argument, exact)
        for output, value in zip(kernel.outputs, kernel.function(kind(exact)), strict=True):
            bound = kernel.promises[dtype][output].bound * EPSILON[dtype]
            true = truth[output].value
            with flint.ctx.workprec(WORKING):
                error = abs(ball(float(value)) / true - 1)
                assert error < ball(bound), (output, exact)


def test_minimum_variance_is_best_among_all_of_its_lag() -> None:
    """Against every tenth of the admissible alphas at many lags, by the oracle's variances."""
    for lag in (0.3, 1.0, 4.0, 100.0):
        best = alpha_beta.minimum_variance_by_lag(lag)
        least = float(best.minimum_variance_predicted_11)
        for part in range(1, 40):
            alpha = (2 - 0.5 / lag) * part / 40
            assert float(predicted((ball(alpha), ball(1 / lag)))[0, 0].mid()) >= least * (1 - 1e-12)
