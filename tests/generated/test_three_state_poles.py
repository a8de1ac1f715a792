"""Single poles of three states against the eigenvalues of a filter that knows no formula."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from kernel_errors import broken_promises, log_uniform, measure
from kernel_truth import THREE_STATES, truth_at
from one_of_each import cases
from printed_kernels import DTYPES, PrintedKernel, printed_kernels

from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.matrices import identity, matrix, product, subtract
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import state_space

KERNELS = {k.family: k for k in printed_kernels() if k.name == "closed_loop_poles"}
NEVER_REAL = "random_jerk"
"""Its pair is complex for every index."""
POINTS = (1e-9, 0.01, 0.7, 5.0, 6.5, 30.0, 40.0, 1e5)


def power_sums(family: str, index: float) -> list[Fraction]:
    """Of the eigenvalues p, sum p^k for k = 0..4: the traces of the powers of F (I - K H), for the
    gain to which the Riccati equation runs.
    """
    model = state_space(THREE_STATES[family], index)
    gain = matrix(doubling.steady_state(model).state.gain, fraction)
    unit = identity(3, Fraction(1))
    loop = product(model.transition, subtract(unit, product(gain, model.measurement)))
    powers = [unit]
    for _ in range(4):
        powers.append(product(powers[-1], loop))
    return [sum((power[i][i] for i in range(3)), Fraction(0)) for power in powers]


def symmetric_sums(power: list[Fraction]) -> tuple[Fraction, Fraction, Fraction]:
    """Sum, sum of products of two, product of the eigenvalues: Newton's identities."""
    first = power[1]
    second = (first * power[1] - power[2]) / 2
    return first, second, (second * power[1] - first * power[2] + power[3]) / 3


def eigenvalues(family: str, index: float) -> list[Any]:
    first, second, third = symmetric_sums(power_sums(family, index))
    with mp.workdps(80):
        numbers = [mp.mpf(c.numerator) / c.denominator for c in (1, -first, second, -third)]
        return list(mp.polyroots(numbers, maxsteps=400, extraprec=400))


def discriminant(family: str, index: float) -> Fraction:
    """Product of the squared differences of the eigenvalues, negative where two are complex: the
    determinant of Hankel's matrix of the power sums, a square of Vandermonde's.
    """
    s = power_sums(family, index)
    return (
        s[0] * (s[2] * s[4] - s[3] * s[3])
        - s[1] * (s[1] * s[4] - s[3] * s[2])
        + s[2] * (s[1] * s[3] - s[2] * s[2])
    )


def sums_of_pairs(family: str, index: float) -> Fraction:
    """(p + q)(q + r)(r + p): while p and q are complex of the sign of p + q, as the rest is a
    modulus squared.
    """
    first, second, third = symmetric_sums(power_sums(family, index))
    return first * second - third


def crossing(
    value: Callable[[str, float], Fraction], family: str, low: float, high: float
) -> float:
    """Where it changes sign between two indices, by halving."""
    rising = value(family, high) > 0
    assert (value(family, low) > 0) is not rising
    for _ in range(24):  # to a millionth of the range
        centre = (low + high) / 2
        low, high = (low, centre) if (value(family, centre) > 0) == rising else (centre, high)
    return low


@cache
def turns(family: str) -> tuple[float, float | None]:
    """The indices at which the half sum of the pair vanishes and at which it becomes real."""
    assert discriminant(family, 1.0) < 0
    assert discriminant(family, 12.0) < 0
    middle = crossing(sums_of_pairs, family, 1.0, 12.0)
    if family == NEVER_REAL:
        assert all(discriminant(family, 10.0**power) < 0 for power in range(-6, 7))
        return middle, None
    return middle, crossing(discriminant, family, 12.0, 100.0)


@pytest.mark.parametrize("family", sorted(THREE_STATES))
def test_they_are_the_eigenvalues(family: str) -> None:
    for index in POINTS[:: 1 if family == "random_jerk" else 2]:
        found = KERNELS[family].function(index)
        half = cmath.sqrt(found.quarter_discriminant)
        mine = [complex(found.real_pole), found.half_sum + half, found.half_sum - half]
        for pole in eigenvalues(family, index):
            assert min(abs(complex(pole) - value) for value in mine) < 1e-7
        assert found.modulus == pytest.approx(abs(mine[1] * mine[2]) ** 0.5, rel=1e-12)


@pytest.mark.parametrize("family", cases(sorted(THREE_STATES), "random_jerk".__eq__))
def test_signs_change_where_they_should(family: str) -> None:
    middle, turn = turns(family)
    poles = KERNELS[family].function
    assert poles(middle * 0.999).half_sum > 0 > poles(middle * 1.001).half_sum
    if turn is None:
        values = poles(np.geomspace(1e-300, 1e154, 500)).quarter_discriminant
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


@pytest.mark.parametrize(
    "family", cases(sorted(THREE_STATES), (NEVER_REAL, "continuous_white_jerk").__contains__)
)
def test_no_digit_is_lost_next_to_a_sign(family: str) -> None:
    """The floats round the index at which a value vanishes, relative to the value itself."""
    kernel = KERNELS[family]
    for place, output in zip(turns(family), ("half_sum", "quarter_discriminant"), strict=True):
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


WIDE = {
    family: [k for k in printed_kernels() if k.family == family and k.domain["float64"][1] > 1e308]
    for family in THREE_STATES
}
"""What takes every index; with covariances beside them, whose squares overflow, few are tried."""


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize(
    "family", cases(sorted(THREE_STATES), lambda family: family == "random_jerk")
)
def test_they_are_right_for_every_index(family: str, dtype: str) -> None:
    kernels = WIDE[family]
    assert KERNELS[family] in kernels
    low, high = KERNELS[family].domain[dtype]
    numbers = np.finfo(dtype)
    assert (low, high) == (float(numbers.smallest_subnormal), float(numbers.max))
    ends = [low, 2 * low, float(numbers.tiny), high / 4, np.nextafter(high, 0), high]
    points = [*ends, *log_uniform(low, high, 24, seed=5), *log_uniform(1, high, 24, seed=6)]
    if dtype == "float64":
        points += [1e-300, 1e300]
    for stated in KERNELS[family].promises[dtype].values():
        places = (stated.highest, stated.highest * 1.001, stated.highest * 4)
        points += [stated.lowest, *(place for place in places if place < high)]
    assert not broken_promises(kernels, dtype, measure(kernels, dtype, points))


@pytest.mark.parametrize("family", sorted(THREE_STATES))
def test_where_they_end(family: str) -> None:
    """Every output is promised to the index 1e300 and beyond, but for those that go by 1/Lambda^2:
    these while they are normal numbers.
    """
    stated = KERNELS[family].promises["float64"]
    soon = {name for name, promise in stated.items() if promise.highest < 1e307}
    quickly = {"random_jerk": {"real_pole", "quarter_discriminant"}}
    quickly["continuous_white_jerk"] = {"real_pole"}
    assert soon == quickly.get(family, set())
    assert all(promise.lowest == 5e-324 for promise in stated.values())
    for name in soon:
        poles = KERNELS[family].function(np.array([stated[name].highest]))
        assert abs(float(getattr(poles, name)[0])) == pytest.approx(2.0**-1022, rel=1e-9)
