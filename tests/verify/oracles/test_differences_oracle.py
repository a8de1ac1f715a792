"""High-precision differences: known derivatives, honest errors."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from gainproof.verify.oracles import differences
from gainproof.verify.oracles.multiprecision import context, number_in


def test_derivative_of_square_root_and_exponential() -> None:
    own = context(400)
    number = number_in(own)

    def function(at: Fraction) -> list[Any]:
        return [own.sqrt(number(at)), own.exp(number(at))]

    root, power = differences.derivatives(function, Fraction(2))
    assert abs(root.value - 1 / (2 * own.sqrt(2))) < 1e-28
    assert abs(power.value - own.exp(2)) < 1e-28
    assert abs(root.value - 1 / (2 * own.sqrt(2))) <= root.error
    assert abs(power.value - own.exp(2)) <= power.error


def test_a_polynomial_in_fractions_is_exact() -> None:
    (slope,) = differences.derivatives(lambda x: [x**3 - x], Fraction(1, 3))
    assert abs(slope.value + context(400).mpf(2) / 3) < 1e-75


def test_a_corner_shows_in_the_error() -> None:
    point = Fraction(1)
    (slope,) = differences.derivatives(lambda x: [abs(x - point - Fraction(1, 5000))], point)
    assert slope.error > abs(slope.value + 1) / 4 > 1e-3


def test_point_zero_is_refused() -> None:
    with pytest.raises(ValueError, match="other than 0"):
        differences.derivatives(lambda x: [x], Fraction(0))
