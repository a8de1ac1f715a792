"""The oracle of fixed gains: against known filters, and its refusals."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest

from gainproof.verify.oracles.fixed_gain import (
    ball,
    closed_loop,
    errors_at,
    predicted,
    root_moduli,
    steady,
    steady_errors,
    updated,
    variance_slope,
)
from gainproof.verify.oracles.zero_crossing import between


def test_a_filter_that_follows_every_measurement() -> None:
    """alpha = beta = 1: velocity is the last difference, so the prediction is 2 z1 - z0."""
    p = predicted((ball(1), ball(1)))
    assert all(p[i, j].contains(n) for i, j, n in ((0, 0, 5), (0, 1, 3), (1, 1, 2)))
    x = updated((ball(1), ball(1)))
    assert x[0, 0].contains(1)
    ahead, after = steady_errors([Fraction(1), Fraction(1)], 2)
    assert [float(e) for e in ahead] == [1.0, 1.5]
    assert [float(e) for e in after] == [0.0, 0.5]


def test_process_noise_adds_its_own_part() -> None:
    noise = flint.arb_mat([[0, 0], [0, 1]])
    gains = (ball(Fraction(1, 2)), ball(Fraction(1, 4)))
    whole, alone = predicted(gains, noise), predicted(gains)
    part = steady(closed_loop(gains), noise)
    assert all((whole[i, j] - alone[i, j] - part[i, j]).contains(0) for i in (0, 1) for j in (0, 1))


def test_the_slope_is_a_difference_quotient() -> None:
    with flint.ctx.workprec(400):
        step = ball(Fraction(1, 2**60))
        gains = [ball(Fraction(n, 10)) for n in (5, 2, 1)]
        for place in range(3):
            moved = [g + step * int(n == place) for n, g in enumerate(gains)]
            slope = (predicted(moved)[0, 0] - predicted(gains)[0, 0]) / step
            assert abs(slope - variance_slope(gains, place)) < 1e-14


def test_moduli_of_poles() -> None:
    assert root_moduli([0.75, 0.5]) == pytest.approx([0.5, 0.5])
    assert root_moduli([1.0, 1.0, 1.0])[0] == pytest.approx(2**-0.5)


def test_what_is_refused() -> None:
    with pytest.raises(ZeroDivisionError):
        steady(flint.arb_mat([[1]]), flint.arb_mat([[1]]))
    with pytest.raises(ValueError, match="no crossing upwards"):
        between(Fraction(1), Fraction(2), lambda x: x, 20)
    with pytest.raises(ArithmeticError, match="still move after 50 samples"):
        steady_errors([Fraction(1, 100), Fraction(1, 10000)], 2, most_samples=50)
    with pytest.raises(ArithmeticError, match="does not decide"):
        between(Fraction(1), Fraction(2), lambda x: flint.arb(x - 1.5, 0.25), 20)


def test_errors_without_a_limit() -> None:
    """Behind a jerk the error of position and velocity grows; behind an acceleration it stays."""
    gains = [Fraction(1, 2), Fraction(1, 4)]
    assert errors_at(gains, 3, 800)[0] > errors_at(gains, 3, 400)[0] + 1599
    assert abs(errors_at(gains, 2, 400)[0] - 4) < 1e-30
