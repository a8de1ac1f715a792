"""Numbers near cube roots: their error to the last digit, and enclosures of the roots."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

import flint
import numpy as np
import pytest
from graph_kernels import KINDS
from numpy.typing import NDArray

from gainproof.derive.printer import cube_root_start
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.shipped import _bits


def near(form: Format, x: float) -> Fraction:
    """The number itself, from its description."""
    place = form.ordinal(x) // 3 + cube_root_start.added_bits(form)
    return Fraction(form.from_ordinal(place))


def extremes(form: Format) -> Iterator[tuple[Fraction, Fraction]]:
    """y^3/x at the ends of the pieces of one period and between them, and the error's share.

    y is linear in x on a piece, but for the rounding of the third of the bits: a unit in y's last
    place. On a line through (x1, y1) and (x2, y2) the extreme of y^3/x is where y = 3 x dy/dx.
    """
    period = form.ordinal(1.0), form.ordinal(8.0)
    cuts = {*period, form.ordinal(2.0), form.ordinal(4.0)}
    for power in (0.25, 0.5, 1.0, 2.0, 4.0):
        place = 3 * (form.ordinal(power) - cube_root_start.added_bits(form))
        cuts |= {place + k for k in (-1, 0) if period[0] <= place + k <= period[1]}
    ordered = sorted(cuts)
    for first, last in pairwise(ordered):
        x1, x2 = (Fraction(form.from_ordinal(place)) for place in (first, last))
        y1, y2 = (near(form, float(x)) for x in (x1, x2))
        unit = 2 * Fraction(form.epsilon) * max(y1, y2)
        yield from ((x1, y1), (x2, y2))
        steep = (y2 - y1) / (x2 - x1)
        if last - first > 3 and steep:
            middle = (y1 - steep * x1) / (2 * steep)
            if x1 < middle < x2:
                y = y1 + steep * (middle - x1)
                yield from ((middle, y + unit), (middle, y - unit))


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_the_error_over_a_period(form: Format) -> None:
    ratios = [y**3 / x for x, y in extremes(form)]
    most = (1 + Fraction(cube_root_start.ERROR)) ** 3
    assert 1 / most < min(ratios)
    assert max(ratios) < most
    # and the constant is no more than it has to be
    assert max(*ratios, *(1 / ratio for ratio in ratios)) > (1 + Fraction(32, 1000)) ** 3


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_one_period_says_all(form: Format) -> None:
    """Eight times the number is twice the number near its cube root, to the bit."""
    for x in (1.0, 1.3, 2.75, 7.9):
        first = near(form, form.nearest(Fraction(x)))
        for k in (-40, -1, 1, 30):
            moved = form.nearest(Fraction(x) * Fraction(8) ** k)
            assert near(form, moved) == first * Fraction(2) ** k


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_the_run_time_computes_it(form: Format) -> None:
    """The constants there are typed; every number of a sample is as described."""
    kind = KINDS[form.name]
    exponents = np.random.default_rng(1).uniform(form.least_exponent, form.greatest_exponent, 2000)
    x = np.array(2.0**exponents, kind)
    out = np.empty_like(x)
    found = _bits.near_cbrt(x, out, form is FLOAT32)
    assert found is out
    for number, value in zip(x.tolist(), out.tolist(), strict=True):
        assert Fraction(value) == near(form, number)
    assert np.array_equal(_bits.near_cbrt(x, x, form is FLOAT32), out)  # in place


def ends(x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The enclosure of the cube roots of exact numbers."""
    with np.errstate(all="ignore"):
        return cube_root_start.cube_root((x, x))


def test_cube_roots_are_enclosed() -> None:
    random = np.random.default_rng(4)
    x = np.concatenate([2.0 ** random.uniform(-1074, 1023, 500), [FLOAT64.least, 8.0, 1.0]])
    for number, low, high in zip(x.tolist(), *(end.tolist() for end in ends(x)), strict=True):
        with flint.ctx.workprec(200):
            root = flint.arb(number).root(3)
            assert flint.arb(low) < root < flint.arb(high)
            assert flint.arb(high) / flint.arb(low) - 1 < 2.0**-38


def test_cube_roots_at_the_ends() -> None:
    low, high = ends(np.array([0.0, np.inf]))
    assert low[0] == 0
    assert high[0] < 1e-300
    assert high[1] == np.inf
