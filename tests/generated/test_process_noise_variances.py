"""What a process noise adds to covariances, against the Lyapunov equation by Kronecker product."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import flint
import pytest
from fixed_gain_points import WORKING, kernels_of, worst_excess
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.generated import alpha_beta
from gainproof.verify.oracles.fixed_gain import ball, closed_loop, predicted, steady, updated

KERNELS = kernels_of("alpha_beta")
ENTRIES = {"11": ((1, 0), (0, 0)), "12": ((0, 1), (1, 0)), "22": ((0, 0), (0, 1))}


def truth(alpha: flint.arb, beta: flint.arb) -> Mapping[str, flint.arb]:
    """D = A D A' + Q, and after the update, for Q with entries 1 in one place and its mirror."""
    loop = closed_loop((alpha, beta))
    rest = flint.arb_mat([[1 - alpha, ball(0)], [-beta, ball(1)]])
    found = {}
    for name, entries in ENTRIES.items():
        ahead = steady(loop, flint.arb_mat([[ball(x) for x in row] for row in entries]))
        for kind, matrix in (("predicted", ahead), ("updated", rest * ahead * rest.transpose())):
            for i, j in ((0, 0), (0, 1), (1, 1)):
                found[f"{kind}_{i + 1}{j + 1}_by_q_{name}"] = matrix[i, j]
    # the sizes of its two terms
    below = alpha * beta * (4 - 2 * alpha - beta)
    found["updated_12_by_q_22_scale"] = (1 - alpha) * (alpha * (2 - alpha) + beta) / below
    return found


@pytest.mark.parametrize("dtype", ["float64", "float32"])
@settings(max_examples=samples(20), deadline=None)
@given(st.floats(1e-6, 0.9999), st.floats(1e-6, 1.9999))
def test_by_the_gains(dtype: str, alpha: float, beta: float) -> None:
    kind: Any = getattr(__import__("numpy"), dtype)
    given_ = [kind(alpha), kind(beta)]
    with flint.ctx.workprec(WORKING):
        true = truth(*(ball(float(x)) for x in given_))
        assert worst_excess(KERNELS["process_noise_variances"], dtype, given_, true) <= 1


@settings(max_examples=samples(20), deadline=None)
@given(st.floats(-6, 6), st.floats(-6, 6))
def test_by_the_coordinates(x: float, y: float) -> None:
    place = [10.0**x, 10.0**y]
    with flint.ctx.workprec(WORKING):
        x_, y_ = map(ball, place)
        beta = 4 / (1 + x_ + y_)
        true = truth(beta * x_ / 2, beta)
        kernel = KERNELS["process_noise_variances_of_coordinates"]
        assert worst_excess(kernel, "float64", place, true) <= 1


def test_a_random_acceleration_beside_the_measurement_noise() -> None:
    """All of it put together as the docstring says."""
    alpha, beta, q = 0.4, 0.3, 0.05
    q11, q12, q22 = q / 4, q / 2, q
    noise = flint.arb_mat([[ball(q11), ball(q12)], [ball(q12), ball(q22)]])
    own, added = alpha_beta.variances(alpha, beta), alpha_beta.process_noise_variances(alpha, beta)
    ahead, after = (kind((ball(alpha), ball(beta)), noise) for kind in (predicted, updated))
    common = q11 * added.predicted_22_by_q_11 + q12 * added.predicted_22_by_q_12
    second = own.updated_22 + common + q22 * added.updated_22_by_q_22
    pairs = (
        (
            own.predicted_11
            + (q11 - q12) * added.predicted_11_by_q_11
            + q22 * added.predicted_11_by_q_22,
            ahead[0, 0],
        ),
        (
            own.updated_12
            + (q11 - q12) * added.updated_12_by_q_11
            + q22 * added.updated_12_by_q_22,
            after[0, 1],
        ),
        (second, after[1, 1]),
        (second + q22, ahead[1, 1]),
    )
    for value, true in pairs:
        assert abs(float(value) - float(true.mid())) < 1e-12
