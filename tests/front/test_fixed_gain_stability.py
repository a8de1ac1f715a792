"""Stability of any gains: the decision against eigenvalues, borders exactly, errors by name."""

from __future__ import annotations

import re
from fractions import Fraction

import numpy as np
import pytest

from gainproof.fixed_gain.stability import is_stable, stable_gains
from gainproof.verify.oracles.fixed_gain import root_moduli


@pytest.mark.parametrize("size", [2, 3])
def test_inequalities_decide_as_the_eigenvalues_of_the_loop(size: int) -> None:
    """Moduli of F (I - K H), where they are clearly not 1: the oracle knows no inequality."""
    generator = np.random.default_rng(size)
    gains = generator.uniform(-0.3, 2.6, (size, 300))
    found = np.asarray(is_stable(*gains))
    clear = 0
    for place in range(gains.shape[1]):
        largest = root_moduli([float(gain) for gain in gains[:, place]])[0]
        if abs(largest - 1) > 1e-6:
            clear += 1
            assert found[place] == (largest < 1), gains[:, place]
    assert clear > 290
    assert 20 < found.sum() < 200


def test_borders_are_decided_exactly() -> None:
    """One number of the format to either side of beta = 4 - 2 alpha; the border is not stable."""
    alpha = 0.3
    border = 4 - 2 * Fraction(alpha)
    nearest = float(border)
    for beta in (np.nextafter(nearest, 0), nearest, np.nextafter(nearest, 9)):
        assert bool(is_stable(alpha, beta)) == (Fraction(float(beta)) < border)
    assert not is_stable(0.5, 3.0)
    assert not is_stable(0.5, 0.25, 0.16666666666666669)
    assert is_stable(0.5, 0.25, 0.16666666666666666)
    assert is_stable(1e-200, 1e-200)
    # both products underflow: the floats' verdict would be a tie
    assert is_stable(1e-200, 1e-200, 1e-320) == (
        Fraction(1e-320) * (1 - Fraction(1e-200) / 2) < Fraction(1e-200) ** 2
    )
    assert is_stable(1e-150, 1e-150, 1e-301)


def test_the_border_of_three_states_is_decided_exactly() -> None:
    """gamma next to alpha beta/(1 - alpha/2), where rounded products tie or are the wrong way."""
    generator = np.random.default_rng(9)
    rounded = 0
    for alpha, beta in generator.uniform(0.01, 1.2, (200, 2)):
        border = Fraction(alpha) * Fraction(beta) / (1 - Fraction(alpha) / 2)
        for gamma in (
            np.nextafter(float(border), 0),
            float(border),
            np.nextafter(float(border), 9),
        ):
            wanted = Fraction(float(gamma)) < border
            assert bool(is_stable(alpha, beta, gamma)) == wanted
            rounded += (gamma * (1 - alpha / 2) < alpha * beta) != wanted
    assert rounded > 20


ERRORS = [
    ((0.5, 3.2), "beta < 4 - 2 alpha fails: beta = 3.2, 4 - 2 alpha = 3;"),
    (([0.5, 0.5], [1, 3.2]), "not a stable filter at index 1: beta < 4 - 2 alpha fails"),
    (([[0.5], [2.5]], [1, 1.5]), "at index (1, 0): beta < 4 - 2 alpha fails: beta = 1,"),
    ((-0.1, 1), "0 < alpha fails: alpha = -0.1; stable filters have 0 < alpha and 0 < beta <"),
    ((0.1, 0), "0 < beta fails: beta = 0;"),
    ((0.5, 0.5, 0), "0 < gamma fails: gamma = 0;"),
    (
        (0.5, 0.5, 0.5),
        "gamma (1 - alpha/2) < alpha beta fails: gamma (1 - alpha/2) = 0.375, alpha beta = 0.25;",
    ),
    ((float("nan"), 1), "alpha must be finite, got nan"),
    ((0.5, [1, float("inf")]), "beta must be finite, got inf at index 1"),
    (([0.1, 0.2], [0.1, 0.2, 0.3]), "shapes do not fit together: alpha (2,), beta (3,)"),
    (([[0.1], [0.2, 0.3]], 0.1), "alpha must be a number or an array, got rows of unlike"),
]


@pytest.mark.parametrize(("gains", "told"), ERRORS)
def test_what_fails_is_named(gains: tuple[float, ...], told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        stable_gains(*gains)


@pytest.mark.parametrize("wrong", ["a", True, 1j, None, np.array(["x"])])
def test_what_is_no_real_number_is_a_type_error(wrong: object) -> None:
    with pytest.raises(TypeError, match="beta must be real numbers, got"):
        is_stable(0.5, wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize("gains", [(), (0.5,), (0.1, 0.1, 0.1, 0.1)])
def test_two_or_three_gains_are_wanted(gains: tuple[float, ...]) -> None:
    with pytest.raises(TypeError, match="two or three gains are wanted"):
        is_stable(*gains)


def test_numbers_come_for_numbers_and_arrays_for_arrays() -> None:
    assert is_stable(0.5, 1).shape == ()
    assert is_stable([0.5], 1).shape == (1,)
    assert is_stable(np.empty((0, 3)), 1).shape == (0, 3)
    alpha, beta = stable_gains([0.5, 1], 0.25)
    assert alpha.shape == beta.shape == (2,)
    assert alpha.dtype == np.float64
