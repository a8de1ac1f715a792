"""What the noises of three states add to covariances, against Lyapunov by Kronecker product.

Each Q is summed up here from the motion of a target whose third derivative is an impulse or
constant; with the Kalman gains of a family all of it together is that family's covariance, whose
kernels come from the Riccati equation.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from fixed_gain_points import WORKING, kernels_of, worst_excess
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.generated import (
    acceleration_increments,
    alpha_beta_gamma,
    continuous_white_jerk,
    random_jerk,
    wiener_acceleration,
)
from gainproof.verify.oracles.fixed_gain import ball, closed_loop, steady

KERNELS = kernels_of("alpha_beta_gamma")
NOISES = ("acceleration", "jerk", "white_jerk")
SMALL = st.floats(-4.5, -0.01).map(lambda e: 10.0**e)
PART = st.one_of(SMALL, st.floats(0.01, 0.999))
PLACE = st.floats(-3, 3).map(lambda e: 10.0**e)
Matrix = list[list[Fraction]]


def covariance(noise: str) -> Matrix:
    """Entries int t^i/i! t^j/j! of powers that run backwards from the second."""
    powers = (2, 1, 0)
    scale = (Fraction(1, 2), Fraction(1), Fraction(1))
    if noise == "white_jerk":
        return [
            [a * b / (m + n + 1) for b, n in zip(scale, powers, strict=True)]
            for a, m in zip(scale, powers, strict=True)
        ]
    column = [a / (n + 1) if noise == "jerk" else a for a, n in zip(scale, powers, strict=True)]
    return [[a * b for b in column] for a in column]


def truth(gains: list[flint.arb], matrix: Matrix) -> Mapping[str, flint.arb]:
    """D = A D A' + Q and (I - K H) D (I - K H)'. Scales are less than twice the entry before the
    update and more than its share that is left: here the entry itself stands for them.
    """
    ahead = steady(closed_loop(gains), flint.arb_mat([[ball(x) for x in row] for row in matrix]))
    rest = flint.arb_mat(
        [[int(i == j) - (gains[i] if j == 0 else 0) for j in range(3)] for i in range(3)]
    )
    after = rest * ahead * rest.transpose()
    found: dict[str, flint.arb] = {}
    for i in range(3):
        for j in range(i, 3):
            ij = f"{i + 1}{j + 1}"
            found |= {f"predicted_{ij}": ahead[i, j], f"updated_{ij}": after[i, j]}
            found[f"updated_{ij}_scale"] = ahead[i, j]
    return found


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("dtype", cases(["float64", "float32"], lambda x: x == "float64"))
@settings(max_examples=samples(6), deadline=None)
@given(PART, st.one_of(SMALL, st.floats(0.01, 1.99)), PART)
def test_by_the_gains(noise: str, dtype: str, alpha: float, beta: float, share: float) -> None:
    kind = np.dtype(dtype).type
    given_: list[Any] = [kind(x) for x in (alpha, beta, share)]
    with flint.ctx.workprec(WORKING):
        a, b, s = (ball(float(x)) for x in given_)
        true = truth([a, b, s * 2 * a * b / (2 - a)], covariance(noise))
        assert worst_excess(KERNELS[f"{noise}_noise_variances"], dtype, given_, true) <= 1


@pytest.mark.parametrize("noise", NOISES)
@settings(max_examples=samples(6), deadline=None)
@given(PLACE, PLACE, PLACE)
def test_by_the_coordinates(noise: str, x: float, d: float, m: float) -> None:
    with flint.ctx.workprec(WORKING):
        x_, d_, m_ = map(ball, (x, d, m))
        y = (d_ + m_) / x_
        gamma = 8 / (1 + x_ + y + d_)
        true = truth([gamma * (1 + y) / 4, gamma * x_ / 2, gamma], covariance(noise))
        kernel = KERNELS[f"{noise}_noise_variances_of_coordinates"]
        assert worst_excess(kernel, "float64", [x, d, m], true) <= 1


@pytest.mark.parametrize(
    ("family", "noise", "more"),
    [
        (acceleration_increments, "acceleration", 1.0),
        (wiener_acceleration, "acceleration", 0.0),
        (random_jerk, "jerk", 0.0),
        (continuous_white_jerk, "white_jerk", 0.0),
    ],
)
def test_with_the_gains_of_kalman_all_of_it_is_the_family(
    family: Any, noise: str, more: float
) -> None:
    """Measurement noise and process noise together, before and after the update."""
    index = np.geomspace(0.01, 30.0, 9)
    gains = [np.asarray(gain) for gain in family.gains(index)[:3]]
    share = gains[2] * (2 - gains[0]) / (2 * gains[0] * gains[1])
    given_ = (gains[0], gains[1], share)
    own = alpha_beta_gamma.variances(*given_)._asdict()
    added = getattr(alpha_beta_gamma, f"{noise}_noise_variances")(*given_)._asdict()
    last = np.array(added["predicted_33"])
    added["predicted_33"] = last + more
    added["updated_33"] = last if more else added["updated_33"]
    own["updated_33"] = own["predicted_33"]
    for kind in ("predicted", "updated"):
        wanted = getattr(family, f"{kind}_covariance")(index)._asdict()
        for name, value in wanted.items():
            assert own[name] + index**2 * added[name] == pytest.approx(value, rel=1e-11), name
