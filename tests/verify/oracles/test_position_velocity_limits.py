"""Limits of the velocity ratio beside what the mathematics of each limit gives in closed form.

With no velocity left the position's predicted variance is the source's equation (20). With the
velocity known exactly only the position is left to be estimated: a scalar filter whose process
noise is what the exact velocities before and after an interval leave open of the displacement,
Lambda^2 (q11 - q12^2) for unit q22.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest
from kernel_truth import STEADY_STATES
from one_of_each import cases

from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles.multiprecision import carried, context

SOURCE = STEADY_STATES["continuous_white_acceleration"]["process_noise"]
DIGITS = 40
OWN = context(256)
INDICES = [Fraction(10) ** power for power in (-6, -3, -1, 0, 1, 3, 6)]


def limit(index: Fraction, name: str, side: str) -> Any:
    return carried(oracle.limit(SOURCE, index, name, side, DIGITS).value, OWN)


def number(value: Fraction) -> Any:
    return OWN.mpf(value.numerator) / value.denominator


def known_velocity(index: Fraction) -> tuple[Any, Any]:
    """Predicted and updated variance of the position when the velocity is known exactly.

    The scalar filter: m = u + A d with u = m / (m + 1), the positive root.
    """
    a = number(index) ** 2
    left_open = a * (OWN.mpf(1) / 3 - OWN.mpf(1) / 4)
    updated = (OWN.sqrt(left_open * (left_open + 4)) - left_open) / 2
    return updated + a / 3, updated


def equation_20(index: Fraction) -> Any:
    """The source's (20), with r = 4 / Lambda."""
    r = 4 / number(index)
    w = OWN.mpf(2) / 3 + OWN.sqrt(r**2 + OWN.mpf(1) / 3)
    bracket = (OWN.sqrt(w) + 1 / OWN.sqrt(2)) ** 2 - OWN.mpf(1) / 6
    return 4 * OWN.sqrt(w) * bracket / (OWN.sqrt(2) * r**2)


def agree(found: Any, known: Any) -> bool:
    return bool(abs(found / known - 1) < OWN.mpf(10) ** -30)


@pytest.mark.parametrize("index", cases(INDICES, lambda index: index in INDICES[::3]))
def test_with_the_velocity_known_exactly(index: Fraction) -> None:
    predicted, updated = known_velocity(index)
    assert agree(limit(index, "predicted_11", "zero"), predicted)
    assert agree(limit(index, "updated_11", "zero"), updated)
    # the velocity then is what one interval adds
    assert agree(limit(index, "predicted_22", "zero"), number(index) ** 2)
    assert agree(limit(index, "predicted_12", "zero"), number(index) ** 2 / 2)


@pytest.mark.parametrize("index", INDICES)
def test_without_velocity(index: Fraction) -> None:
    assert agree(limit(index, "predicted_11", "infinity"), equation_20(index))


def test_a_wrong_limit_is_seen() -> None:
    index = Fraction(1)
    wrong = equation_20(index * Fraction(10**15 + 1, 10**15))
    assert not agree(limit(index, "predicted_11", "infinity"), wrong)
    assert not agree(limit(index, "predicted_11", "zero"), known_velocity(Fraction(2))[0])


def test_the_improvement_ratio_of_small_r_is_the_source_s_number() -> None:
    """0.536 in the source; 4 - 2 sqrt(3) = 0.535898384862245... by both limits."""
    index = Fraction(10) ** 40
    ratio = limit(index, "predicted_11", "zero") / limit(index, "predicted_11", "infinity")
    # what is left at this index is of order 1 / Lambda
    assert abs(ratio - (4 - 2 * OWN.sqrt(3))) < OWN.mpf(10) ** -30
    assert mpmath.nstr(ratio, 3) == "0.536"
    assert mpmath.nstr(ratio, 15) == "0.535898384862245"


def test_the_improvement_ratio_of_large_r_falls_without_end() -> None:
    """It falls like r^(-1/2): the position is known to r^(-1) with the velocity, to r^(-1/2)
    without.
    """
    ratios = []
    for index in (Fraction(1, 10**12), Fraction(1, 10**16)):
        best = limit(index, "predicted_11", "zero")
        ratios.append(best / limit(index, "predicted_11", "infinity"))
    assert abs(ratios[1] / ratios[0] * 100 - 1) < OWN.mpf(10) ** -5
