"""Values of two parts: arithmetic keeps their difference, and never hides one."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gainproof.derive.any_two_state.signed_values import Signed, total

PARTS = st.none() | st.fractions(min_value=Fraction(1, 9), max_value=9)
VALUES = st.builds(Signed, PARTS, PARTS)


def value(x: Signed) -> Fraction:
    return (x.plus or Fraction(0)) - (x.minus or Fraction(0))


@given(VALUES, VALUES)
def test_sums_differences_and_products(x: Signed, y: Signed) -> None:
    assert value(x + y) == value(x) + value(y)
    assert value(x - y) == value(x) - value(y)
    assert value(x * y) == value(x) * value(y)
    assert value(total(x, y, -x)) == value(y)


@given(VALUES, st.fractions(min_value=Fraction(1, 9), max_value=9))
def test_scaling_makes_no_new_part(x: Signed, size: Fraction) -> None:
    for scaled in (x.times(size), x.over(size)):
        assert (scaled.plus is None, scaled.minus is None) == (x.plus is None, x.minus is None)
    assert value(x.times(size).over(size)) == value(x)


def test_what_a_value_says_of_itself() -> None:
    assert Signed(2, 3).cancels
    assert Signed(2, 3).scale == 5
    assert Signed(2).is_positive
    assert Signed(None, 2).value == -2
    assert Signed().is_zero
    assert Signed().value == 0
    with pytest.raises(TypeError):
        _ = Signed(2).scale
