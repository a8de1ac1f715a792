"""Kernels of second derivatives: their bounds, their signs, and the place where one turns."""

from __future__ import annotations

import math

import numpy as np
import pytest
from kernel_errors import broken_promises, log_uniform, measure
from kernel_truth import STEADY_STATES
from printed_kernels import DTYPES, PrintedKernel, printed_kernels

TURNS = {
    "random_velocity": 0.389260,
    "random_acceleration": 4 / (3 + 2 * math.sqrt(3)),
    "continuous_white_acceleration": 0.502673,
}


def second_derivatives(family: str) -> list[PrintedKernel]:
    found = [k for k in printed_kernels() if k.family == family]
    return [kernel for kernel in found if kernel.name.endswith("_second_derivatives")]


@pytest.mark.alike
@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("family", sorted(STEADY_STATES))
def test_the_bounds_hold_at_random_points_and_round_the_turn(family: str, dtype: str) -> None:
    kernels = second_derivatives(family)
    assert len(kernels) == 4
    turn, limits = TURNS[family], np.finfo(dtype)
    near = [turn * (1 + sign * 2.0**-k) for k in range(2, 54, 5) for sign in (1, -1)]
    points = [*near, *log_uniform(float(limits.tiny), float(limits.max), 25, 7)]
    assert broken_promises(kernels, dtype, measure(kernels, dtype, points)) == []


@pytest.mark.parametrize("family", sorted(STEADY_STATES))
def test_what_bends_down_and_what_bends_up(family: str) -> None:
    index = np.geomspace(1e-60, 1e60, 1001)
    named = {kernel.name: kernel.function(index) for kernel in second_derivatives(family)}
    for name in ("gain_second_derivatives", "predictor_gain_second_derivatives"):
        assert all((column < 0).all() for column in named[name])
    updated = named["updated_covariance_second_derivatives"]
    assert (updated.updated_22 > 0).all()
    assert (updated.updated_12 < 0).all()
    predicted = named["predicted_covariance_second_derivatives"]
    assert (predicted.predicted_12 > 0).all()
    assert (predicted.predicted_22 >= 2).all()
    np.testing.assert_array_equal(predicted.predicted_11 > 0, index > TURNS[family])


def test_no_digit_is_lost_next_to_the_turn_of_random_acceleration() -> None:
    """Elsewhere the terms of the difference measure the error, here the difference itself."""
    for family in STEADY_STATES:
        (kernel,) = (k for k in second_derivatives(family) if "predicted_11" in k.outputs)
        assert bool(kernel.by_terms) == (family != "random_acceleration")
