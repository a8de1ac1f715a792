"""Common factors by FLINT against SymPy's own gcd, which shares no code with it."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples
from sympy.polys.rings import PolyRing

from gainproof.derive.algebra.common_factor import without_common_factor

RING = PolyRing(["x", "y", "z"], sp.QQ, sp.lex)
coefficients = st.fractions(-9, 9, max_denominator=4).map(
    lambda q: sp.QQ(q.numerator, q.denominator)
)
powers = st.tuples(*[st.integers(0, 3)] * 3)
polynomials = st.dictionaries(powers, coefficients.filter(bool), min_size=1, max_size=4).map(
    RING.from_dict
)


@settings(max_examples=samples(30))
@given(polynomials, polynomials, polynomials)
def test_fraction_is_as_short_as_sympy_writes_it(num: Any, den: Any, factor: Any) -> None:
    found = without_common_factor(num * factor, den * factor)
    expected = (num * factor).cancel(den * factor)
    scale = expected[1].LC / found[1].LC
    assert [part.mul_ground(scale) for part in found] == list(expected)


@pytest.mark.parametrize("constant", [1, -3])
def test_constant_has_no_common_factor(constant: int) -> None:
    x = RING.gens[0]
    whole = RING.ground_new(sp.QQ(constant, 2))
    assert without_common_factor(x, whole) == (x, whole)
    assert without_common_factor(whole, x) == (whole, x)
