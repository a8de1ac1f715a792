"""The reduced cubic of three poles against the eigenvalues of F (I - K H) in balls."""

from __future__ import annotations

from typing import Any

import flint
import numpy as np
import pytest
from fixed_gain_points import WORKING, kernels_of, worst_excess
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.generated import alpha_beta_gamma
from gainproof.verify.oracles.fixed_gain import ball, closed_loop

KERNEL = kernels_of("alpha_beta_gamma")["closed_loop_poles"]


def gain(most: float) -> st.SearchStrategy[float]:
    """Anywhere, stable or not, small ones as often."""
    return st.one_of(st.floats(-3.5, 0.0).map(lambda e: most * 10.0**e), st.floats(1e-3, most))


def eigenvalues(gains: list[flint.arb]) -> list[flint.acb]:
    loop = flint.acb_mat(closed_loop(gains))
    found: list[flint.acb] = loop.eig(algorithm="rump", multiple=True)
    return found


def truth(gains: list[flint.arb]) -> dict[str, flint.arb]:
    """Symmetric functions of the poles; the scales are sums of terms over the gains."""
    z = eigenvalues(gains)
    mean = (z[0] + z[1] + z[2]) / 3
    w = [each - mean for each in z]
    between = (w[0] - w[1]) * (w[1] - w[2]) * (w[2] - w[0])
    a, b, c = gains
    s, v = a + b + c / 2, b + c + c / 2
    return {
        "mean_distance": (1 - mean).real,
        "reduced_linear": (sum((each * each for each in w), flint.acb(0)) / 6).real,
        "reduced_constant": (w[0] * w[1] * w[2] / 2).real,
        "discriminant": (between * between / 108).real,
        "reduced_linear_scale": s**2 / 9 + v / 3,
        "reduced_constant_scale": s * v / 6 + s**3 / 27 + c / 2,
        "discriminant_scale": (s * v * (s * v + 18 * c) + 4 * v**3 + 4 * s**3 * c + 27 * c**2)
        / 108,
    }


@pytest.mark.parametrize("dtype", cases(["float64", "float32"], lambda x: x == "float64"))
@settings(max_examples=samples(20), deadline=None)
@given(gain(2.0), gain(4.0), gain(8.0))
def test_the_reduced_cubic(dtype: str, alpha: float, beta: float, gamma: float) -> None:
    kind = np.dtype(dtype).type
    given_: list[Any] = [kind(alpha), kind(beta), kind(gamma)]
    with flint.ctx.workprec(WORKING):
        gains = [ball(float(each)) for each in given_]
        try:
            true = truth(gains)
        except ValueError:  # poles so near each other that their balls are not told apart
            return
        assert worst_excess(KERNEL, dtype, given_, true) <= 1


@settings(max_examples=samples(30), deadline=None)
@given(gain(2.0), gain(4.0), gain(8.0))
def test_the_poles_as_the_docstring_says(alpha: float, beta: float, gamma: float) -> None:
    found = alpha_beta_gamma.closed_loop_poles(alpha, beta, gamma)
    mean, p, q, rest = (float(each) for each in found)
    if abs(rest) < 1e-6 * (abs(p) ** 3 + q * q):
        return  # poles next to each other
    if rest > 0:
        t = np.arccos(q / p**1.5) / 3
        w = 2 * np.sqrt(p) * np.cos(t + 2 * np.pi * np.arange(3) / 3) + 0j
    else:
        r = np.cbrt(abs(q) + np.sqrt(-rest))
        real, turn = np.copysign(r + p / r, q), np.sqrt(3) / 2 * (r - p / r)
        w = np.array([real, -real / 2 + 1j * turn, -real / 2 - 1j * turn])
    with flint.ctx.workprec(WORKING):
        true = [complex(each) for each in eigenvalues([ball(x) for x in (alpha, beta, gamma)])]
    poles = 1 - mean + w
    for each in true:
        assert np.abs(poles - each).min() < 1e-9 * (1 + np.abs(true).max())


def test_a_threefold_pole_and_real_ones() -> None:
    """alpha = 1, beta = 3/2, gamma = 1: all at 0. Small gains behind alpha: all real."""
    all_at_0 = alpha_beta_gamma.closed_loop_poles(1.0, 1.5, 1.0)
    assert [float(each) for each in all_at_0] == [1.0, 0.0, 0.0, 0.0]
    assert alpha_beta_gamma.closed_loop_poles(0.5, 0.01, 1e-5).discriminant > 0
    assert alpha_beta_gamma.closed_loop_poles(0.5, 0.25, 0.0625).discriminant < 0
