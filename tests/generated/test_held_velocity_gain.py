"""Filters whose velocity gain is held: the best of the steady state, and best sample by sample."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.generated import alpha_beta
from gainproof.verify.oracles.fixed_gain import ball, root_moduli, updated


def smoothed(alpha: Fraction, beta: Fraction) -> float:
    return float(updated((ball(alpha), ball(beta)))[0, 0].mid())


@pytest.mark.parametrize("lag", [0.51, 0.7, 1.0, 4.0, 100.0])
def test_no_stable_filter_of_the_lag_smooths_better(lag: float) -> None:
    best = alpha_beta.minimum_smoothed_variance_by_lag(lag)
    least = float(best.minimum_smoothed_variance_updated_11)
    beta = 1 / Fraction(lag)
    border = 2 - beta / 2
    values = [smoothed(border * part / 60, beta) for part in range(1, 60)]
    assert min(values) >= least * (1 - 1e-12)
    assert least < 1


def test_at_half_the_lag_none_is_best_and_below_none_helps() -> None:
    """beta = 2: the nearer to the border alpha = 1 the better, 1 is not reached."""
    values = [smoothed(1 - Fraction(1, 10**n), Fraction(2)) for n in (1, 2, 4, 8)]
    assert values == sorted(values, reverse=True)
    assert all(1 < value < 1 + 3 * 10.0**-n for value, n in zip(values, (1, 2, 4, 8), strict=True))
    assert min(smoothed(Fraction(part, 200), Fraction(3)) for part in range(1, 100)) > 1


def fitted(alpha_of: str, beta: float, samples: int = 4000) -> tuple[float, float]:
    """The gain and smoothed variance that a filter runs into when each sample's gain fits best.

    Only the covariance recursion of any filter is run, in floats.
    """
    p = [[10.0, 0.0], [0.0, 1.0]]
    alpha = after = 0.0
    for _ in range(samples):
        share = p[0][0] + (p[0][1] if alpha_of == "predicted" else 0.0)
        alpha = share / (p[0][0] + 1) - (beta if alpha_of == "predicted" else 0.0)
        a, b = 1 - alpha, -beta
        x11 = a * a * p[0][0] + alpha * alpha
        x12 = a * (b * p[0][0] + p[0][1]) + alpha * beta
        x22 = b * b * p[0][0] + 2 * b * p[0][1] + p[1][1] + beta * beta
        p = [[x11 + 2 * x12 + x22, x12 + x22], [x12 + x22, x22]]
        after = x11
    return alpha, after


@pytest.mark.parametrize("beta", [0.01, 0.3, 1.0, 1.7])
def test_gains_that_fit_each_sample_settle_elsewhere(beta: float) -> None:
    alpha, after = fitted("smoothed", beta)
    assert abs(beta - 2 * alpha**2 / (2 - alpha)) < 1e-9
    assert abs(after - alpha) < 1e-9
    assert root_moduli([alpha, beta])[0] < 1
    best = alpha_beta.minimum_smoothed_variance_by_lag(1 / beta)
    assert after > float(best.minimum_smoothed_variance_updated_11) + 1e-5


@pytest.mark.parametrize("beta", [0.01, 0.3, 1.0, 1.7])
def test_gains_that_fit_each_prediction_are_not_of_minimum_variance(beta: float) -> None:
    alpha, _ = fitted("predicted", beta)
    x = 2 * alpha / beta
    assert abs((x + 1) * (x + 2) - 4 / beta) < 1e-6
    best = alpha_beta.minimum_variance_by_lag(1 / beta)
    assert abs(alpha - float(best.minimum_variance_alpha)) > 1e-3 * alpha
