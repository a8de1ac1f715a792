"""The kernels of the closed-loop poles against the eigenvalues of a filter that knows no formula.

The gain is that of enclosures of the Riccati solution; the poles are the eigenvalues of F (I - K).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from kernel_truth import STEADY_STATES
from one_of_each import cases

from gainproof.position_velocity.process_noise import PROCESS_NOISES, kernels
from gainproof.verify.oracles import doubling
from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles.multiprecision import fraction

EPSILON = Fraction(1, 2**52)
ONE_OF_NOISES = cases(
    sorted(PROCESS_NOISES), lambda noise: noise == "continuous-white-acceleration"
)
POINTS = [10.0**e for e in (-6, -2.5, -0.4, 0, 0.3, 0.5, 1.2, 2, 3.5, 6)]


def poles(process_noise: str, index: float, ratio: float) -> Mapping[str, Fraction]:
    """Half the trace of F (I - K), its determinant, and the square of half the difference."""
    noise = STEADY_STATES[process_noise.replace("-", "_")]["process_noise"]
    state = doubling.steady_state(oracle.model(noise, Fraction(index), Fraction(ratio)), 80).state
    k = [[fraction(state.gain[i][j]) for j in range(2)] for i in range(2)]
    half = (2 - k[0][0] - k[1][0] - k[1][1]) / 2
    product = (1 - k[0][0]) * (1 - k[1][1]) - k[0][1] * k[1][0]
    return {"half_sum": half, "product": product, "quarter_discriminant": half * half - product}


def largest(true: Mapping[str, Fraction]) -> Fraction:
    """A bound of the larger pole's modulus within a factor of 2, squared."""
    return max(true["product"], true["half_sum"] ** 2)


def stated(kernel: Any, output: str) -> Fraction:
    """The bound that the docstring states in float64."""
    text = re.sub(r"\s+", " ", kernel.__doc__)
    found = re.search(rf" {output}: .*?at most ([.\d]+) \* 2\^-52 \(float64\)", text)
    assert found is not None
    return Fraction(found.group(1)) * EPSILON


@pytest.mark.parametrize("process_noise", ONE_OF_NOISES)
def test_poles_are_the_eigenvalues(process_noise: str) -> None:
    """Errors over the larger modulus (squared: the discriminant), a few of the stated bounds."""
    kernel = kernels(process_noise).closed_loop_poles
    for index in POINTS:
        for ratio in POINTS:
            true, found = poles(process_noise, index, ratio), kernel(index, ratio)
            size, few = largest(true), 6
            product = Fraction(float(found.modulus)) ** 2
            assert abs(product / true["product"] - 1) < 3 * stated(kernel, "modulus")
            away = Fraction(float(found.half_sum)) - true["half_sum"]
            assert away**2 < (few * stated(kernel, "half_sum")) ** 2 * size, (index, ratio)
            off = Fraction(float(found.quarter_discriminant)) - true["quarter_discriminant"]
            assert abs(off) < few * stated(kernel, "quarter_discriminant") * size, (index, ratio)


@pytest.mark.parametrize("process_noise", sorted(PROCESS_NOISES))
def test_the_discriminant_changes_its_sign_where_the_poles_turn(process_noise: str) -> None:
    module = kernels(process_noise)
    for index in (1e-4, 0.3, 7.0, 12.5, 300.0):
        places = module.real_poles(index)._asdict()
        for name, place in places.items():
            if place <= 0:
                continue
            outer = 1 if name == "positive_from" else -1
            for side in (1, -1):
                ratio = float(place * (1 + side * outer * 1e-9)) ** -0.5
                true = poles(process_noise, index, ratio)
                assert (true["quarter_discriminant"] > 0) == (side > 0), (index, name)
                assert (true["half_sum"] > 0) == (name == "positive_from")


def test_another_family_is_noticed() -> None:
    true = poles("random-acceleration", 3.0, 2.0)
    found = kernels("continuous-white-acceleration").closed_loop_poles(3.0, 2.0)
    assert not np.isclose(float(found.half_sum), float(true["half_sum"]), rtol=1e-3)
