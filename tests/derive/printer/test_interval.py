"""Interval operations hold what they must, checked with exact fractions."""

from __future__ import annotations

from fractions import Fraction

import flint
import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gainproof.derive.printer import interval
from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.interval import Interval
from gainproof.derive.printer.program import program

POSITIVE = st.floats(5e-324, 1.7e308)
ANY = st.floats(allow_nan=False, allow_infinity=False)


def thin(x: float) -> Interval:
    return np.array([x]), np.array([x])


def holds(found: Interval, value: Fraction) -> bool:
    low, high = float(found[0][0]), float(found[1][0])
    return low <= value and (high == np.inf or value <= high)


@given(POSITIVE, POSITIVE)
def test_positive_operations(x: float, y: float) -> None:
    a, b = Fraction(x), Fraction(y)
    with np.errstate(all="ignore"):
        assert holds(interval.add(thin(x), thin(y)), a + b)
        assert holds(interval.multiply(thin(x), thin(y)), a * b)
        assert holds(interval.divide(thin(x), thin(y)), a / b)
        assert holds(interval.reciprocal(thin(x)), 1 / a)
        assert holds(interval.share(interval.divide(thin(y), thin(x))), a / (a + b))
        for power in (2.0**-60, 0.5, 4.0, 2.0**60):
            assert holds(interval.scale(thin(x), power), a * Fraction(power))
        low, high = interval.square_root(thin(x))
        assert Fraction(float(low[0])) ** 2 <= a <= Fraction(float(high[0])) ** 2


def test_zero_and_infinity_stand_for_all_they_may() -> None:
    nought, endless = thin(0.0), thin(np.inf)
    with np.errstate(all="ignore"):
        for found in (
            interval.multiply(nought, endless),
            interval.divide(nought, nought),
            interval.divide(endless, endless),
        ):
            assert (found[0][0], found[1][0]) == (0, np.inf)
        low, high = interval.signed_add(thin(-np.inf), endless)
        assert (low[0], high[0]) == (-np.inf, np.inf)
    # a zero with a sign would turn an upper bound 1/0 into -infinity
    for size in (interval.magnitude(thin(0.0)), interval.mignitude(thin(-0.0))):
        assert not np.signbit(size[0])


@given(ANY, ANY, st.floats(0, 1e300), st.floats(0, 1e300))
def test_signed_operations(x: float, y: float, w: float, v: float) -> None:
    low, high = min(w, v), max(w, v)
    a, b = sorted((x, y))
    weight = np.array([low]), np.array([high])
    with np.errstate(all="ignore"):
        found = interval.signed_multiply((np.array([a]), np.array([b])), weight)
        for factor in (low, high):
            for end in (a, b):
                value = Fraction(end) * Fraction(factor)
                if np.isfinite(found[0][0]) and np.isfinite(found[1][0]):
                    assert holds(found, value)
        assert holds(interval.signed_add(thin(x), thin(y)), Fraction(x) + Fraction(y)) or np.isinf(
            x + y
        )


@given(st.floats(0, 20), st.floats(0, 3000))
def test_spread_bounds_the_power(slope: float, width: float) -> None:
    with np.errstate(all="ignore"):
        found = float(interval.spread(np.array([slope]), np.array([width]))[0])
    with flint.ctx.workprec(200):
        assert found == np.inf or flint.arb(found) >= (1 + flint.arb(width)) ** flint.arb(slope)


@given(st.sampled_from(["2", "1/3", "5", "7/2"]), st.integers(-60, 60), st.booleans())
def test_differences_next_to_their_zero(square: str, steps: int, root: bool) -> None:
    """sqrt(2) - x for floats next to sqrt(2): all digits, the sign too."""
    b = GraphBuilder()
    constant = b.sqrt(square) if root else b.number(square)
    steps_of = program(b.graph({"y": constant - b.symbol("x")}))
    affine = affine_sum(steps_of, steps_of.outputs["y"], FLOAT64)
    assert affine is not None
    at = FLOAT64.ordinal(float(Fraction(square)) ** 0.5 if root else float(Fraction(square)))
    x = FLOAT64.from_ordinal(at + steps)
    low, high = (float(end[0]) for end in affine.at(np.array([x])))
    with flint.ctx.workprec(400):
        value = flint.arb(flint.fmpq(*Fraction(square).as_integer_ratio()))
        exact = (value.sqrt() if root else value) - flint.arb(x)
    assert not exact < flint.arb(low)
    assert not exact > flint.arb(high)
    assert high - low <= 2.0**-48 * max(abs(low), abs(high))
    for form in (FLOAT64, FLOAT32):
        narrow = affine_sum(steps_of, steps_of.outputs["y"], form)
        assert narrow is not None
        below, above = narrow.zero(form)
        assert above in (below, form.after(below))
