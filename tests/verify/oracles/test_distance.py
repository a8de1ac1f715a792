"""Distances to a ball are decided for every number in it, and rounded upward."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest

from gainproof.verify.oracles import distance

WIDE = flint.arb(1, Fraction(1, 1024).__float__())


def test_within_holds_for_the_whole_ball() -> None:
    assert distance.within(1.0, WIDE, Fraction(1, 512))
    assert not distance.within(1.0, WIDE, Fraction(1, 1024))  # the far end is relatively farther
    assert distance.within(1.0, WIDE, Fraction(1, 1024), scale=flint.arb(4))


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
def test_nothing_is_close_to_a_number_that_is_none(value: float) -> None:
    assert not distance.within(value, WIDE, Fraction(10**9))
    assert distance.relative_error(value, WIDE) == float("inf")


def test_the_error_is_an_upper_bound_to_the_last_bit() -> None:
    with flint.ctx.workprec(300):
        third = flint.arb(1) / 3
    exact = 1 - 3 * Fraction(1 / 3)
    assert (
        0
        < exact
        <= Fraction(distance.relative_error(1 / 3, third))
        < exact * (1 + Fraction(1, 2**48))
    )
    assert not distance.within(1 / 3, third, exact * (1 - Fraction(1, 2**60)))
    assert distance.within(1 / 3, third, exact * (1 + Fraction(1, 2**60)))


def test_a_long_fraction_is_not_rounded_first() -> None:
    near = 2 + Fraction(1, 3**200)
    assert 0 < distance.relative_error(near, flint.arb(2)) < 1e-94


def test_the_midpoint_is_exact() -> None:
    with flint.ctx.workprec(120):
        third = flint.arb(1) / 3
    found = distance.middle(third)
    assert abs(found - Fraction(1, 3)) < Fraction(1, 2**119)
    assert found.denominator & (found.denominator - 1) == 0
