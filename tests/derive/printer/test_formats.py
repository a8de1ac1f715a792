"""Neighbours and rounding agree with NumPy."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format

FLOATS: dict[str, Any] = {"float64": np.float64, "float32": np.float32}


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_limits(form: Format) -> None:
    info = np.finfo(FLOATS[form.name])
    assert (form.least_normal, form.least) == (info.tiny, info.smallest_subnormal)
    assert (form.largest, form.epsilon) == (info.max, info.eps)


@given(st.floats(allow_nan=False, allow_infinity=False, width=32))
def test_neighbours(x: float) -> None:
    for form in FORMATS:
        kind = FLOATS[form.name]
        assert form.from_ordinal(form.ordinal(x)) == x
        if x != form.largest:
            assert form.after(x) == float(np.nextafter(kind(x), kind(np.inf)))
        if x != -form.largest:
            assert form.before(x) == float(np.nextafter(kind(x), kind(-np.inf)))


@given(st.floats(-1e30, 1e30), st.integers(1, 10**30))
def test_rounding(x: float, divisor: int) -> None:
    assert FLOAT32.nearest(Fraction(x)) == float(np.float32(x))
    value = Fraction(x) / divisor
    assert FLOAT64.nearest(value) == float(value)
    assert FLOAT64.at_most(value) <= value <= FLOAT64.at_least(value)


def test_overflow() -> None:
    with pytest.raises(OverflowError, match="beyond the largest float32"):
        FLOAT32.nearest(Fraction(10) ** 39)
