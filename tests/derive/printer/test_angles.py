"""How near sine and cosine come to 0 at numbers of a format."""

from __future__ import annotations

import math

import flint
import numpy as np
import pytest
from one_of_each import cases

from gainproof.derive.printer.angles import least_cosine, least_sine
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format


@pytest.mark.parametrize(("form", "kind"), [(FLOAT64, np.float64), (FLOAT32, np.float32)])
@pytest.mark.parametrize(
    "high", cases([1.0, 1.5707962, 3.0, 6.2832, 40.0], lambda high: high in {1.5707962, 40.0})
)
def test_no_number_comes_nearer(form: Format, kind: type[np.floating], high: float) -> None:
    """At random numbers, and at the nearest ones to every multiple of a quarter turn."""
    high = float(kind(high))
    quarter = np.arange(1, int(high / (math.pi / 2)) + 1) * (math.pi / 2)
    near = quarter.astype(kind)
    for _ in range(3):
        near = np.concatenate([near, np.nextafter(near, kind(0)), np.nextafter(near, kind(99))])
    places = np.concatenate([near, np.random.default_rng(1).uniform(0.01, high, 500).astype(kind)])
    places = places[places <= high]
    with flint.ctx.workprec(200):
        cosines = [abs(flint.arb(float(x)).cos()) for x in places]
        sines = [abs(flint.arb(float(x)).sin()) for x in places]
    assert all(x >= least_cosine(high, form) for x in cosines)
    assert all(x >= least_sine(0.01, high, form) for x in sines)


def test_the_worst_is_met() -> None:
    half_turn = float(flint.arb.pi().mid())
    with flint.ctx.workprec(200):
        exact = float(abs(flint.arb(half_turn).sin()))
        assert least_sine(1e-3, 3.2, FLOAT64) == pytest.approx(exact, rel=1e-5)
        exact = float(flint.arb(math.pi / 2).cos())
        assert least_cosine(math.pi / 2, FLOAT64) == pytest.approx(exact, rel=1e-5)
    assert least_sine(1e-30, 3.0, FLOAT64) == pytest.approx(1e-30, rel=1e-5)
    assert least_sine(1e-30, 3.0, FLOAT64) < 1e-30


def test_large_angles_are_refused() -> None:
    with pytest.raises(ValueError, match=r"angles of at most 100\.0 are wanted, got 1000\.0"):
        least_cosine(1000.0, FLOAT64)
