"""Single poles of three states against the eigenvalues of a filter that knows no formula."""

from __future__ import annotations

import cmath
from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from kernel_truth import THREE_STATES, truth_at
from printed_kernels import PrintedKernel, printed_kernels

from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import state_space

KERNELS = {k.family: k for k in printed_kernels() if k.name == "closed_loop_poles"}
TURNS = {
    "acceleration_increments": (4 * 2**0.5, 12 * 3**0.5),
    "wiener_acceleration": (4 * 2**0.5, 12 * 3**0.5),
    "random_jerk": (6.17278, None),
    "continuous_white_jerk": (5.96680, 31.6),
}
POINTS = (1e-9, 0.01, 0.7, 5.0, 6.5, 30.0, 40.0, 1e5)


def eigenvalues(family: str, index: float) -> list[Any]:
    """Of F (I - K H), for the gain to which the Riccati equation runs."""
    gain = doubling.steady_state(state_space(THREE_STATES[family], index)).state.gain
    alpha, beta, gamma = (fraction(row[0]) for row in gain)
    # det(z I - F (I - K H)) by its traces
    second, first = alpha + beta + gamma / 2 - 3, 3 - 2 * alpha - beta + gamma / 2
    coefficients = [Fraction(1), second, first, alpha - 1]
    with mp.workdps(80):
        numbers = [mp.mpf(c.numerator) / c.denominator for c in coefficients]
        return list(mp.polyroots(numbers, maxsteps=400, extraprec=400))


@pytest.mark.parametrize("family", sorted(THREE_STATES))
def test_they_are_the_eigenvalues(family: str) -> None:
    for index in POINTS[:: 1 if family == "random_jerk" else 2]:
        found = KERNELS[family].function(index)
        half = cmath.sqrt(found.quarter_discriminant)
        mine = [complex(found.real_pole), found.half_sum + half, found.half_sum - half]
        for pole in eigenvalues(family, index):
            assert min(abs(complex(pole) - value) for value in mine) < 1e-7
        assert found.modulus == pytest.approx(abs(mine[1] * mine[2]) ** 0.5, rel=1e-12)


@pytest.mark.parametrize("family", sorted(TURNS))
def test_signs_change_where_they_should(family: str) -> None:
    middle, turn = TURNS[family]
    poles = KERNELS[family].function
    assert poles(middle * 0.999).half_sum > 0 > poles(middle * 1.001).half_sum
    if turn is None:
        values = poles(np.geomspace(1e-300, 1e60, 500)).quarter_discriminant
        assert np.all(values < 0)
    else:
        assert (
            poles(turn * 0.999).quarter_discriminant < 0 < poles(turn * 1.001).quarter_discriminant
        )


def near(kernel: PrintedKernel, output: str, index: float) -> Fraction:
    """The error over the true value."""
    true = truth_at(kernel.family, "tracking_index", index)[output].value
    top = Fraction(str(true.mid().str(60, radius=False)))
    return abs(Fraction(float(getattr(kernel.function(index), output))) / top - 1)


@pytest.mark.parametrize("family", sorted(TURNS))
def test_no_digit_is_lost_next_to_a_sign(family: str) -> None:
    """The floats round the index at which a value vanishes, relative to the value itself."""
    kernel = KERNELS[family]
    for place, output in zip(TURNS[family], ("half_sum", "quarter_discriminant"), strict=True):
        if place is None:
            continue
        low, high = place * 0.99, place * 1.01
        rising = float(getattr(kernel.function(high), output)) > 0
        while np.nextafter(low, high) < high:
            centre = (low + high) / 2
            positive = float(getattr(kernel.function(centre), output)) > 0
            low, high = (low, centre) if positive == rising else (centre, high)
        for index in (low, high):
            assert near(kernel, output, index) <= kernel.promises["float64"][output].error(
                "float64"
            )
