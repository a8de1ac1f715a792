"""Poles with their errors, against NumPy's eigenvalues and by hand."""

from __future__ import annotations

import random
from fractions import Fraction

import flint
import numpy as np
import pytest
from riccati_recursion import drawn, model
from samples import samples

from gainproof.verify.enclosure.poles import Pole, _pole, poles
from gainproof.verify.enclosure.steady import steady
from gainproof.verify.enclosure.structure import Model


def found(of: Model) -> tuple[Pole, ...]:
    state = steady(of)
    return poles(of, state.enclosures, state.certificate["parts"][0])


def test_poles_by_hand() -> None:
    (only,) = found(model([[2]], [[1]], [[0]], [[1]]))
    assert abs(only.centre - 0.5) <= only.radius < 1e-15
    first, second = found(model([[1, 1], [0, 1]], [[1, 0]], [[1, 3], [3, 9]], [[0]]))
    assert abs(first.centre + 0.5) <= first.radius < 1e-14
    assert abs(second.centre) <= second.radius < 1e-14
    assert first.centre.imag == second.centre.imag == 0


def test_a_pole_below_all_doubles_is_not_taken_for_0() -> None:
    """F R/(P + R) with P next to 1."""
    for r in (100, 120, 124, 150):
        of = model([[Fraction(1, 10**200)]], [[1]], [[1]], [[Fraction(1, 10**r)]])
        (only,) = found(of)
        true = Fraction(1, 10 ** (200 + r))
        assert abs(Fraction(only.centre.real) - true) <= Fraction(only.radius) * (1 + true)
    (zero,) = found(model([[0]], [[1]], [[1]], [[1]]))
    assert (zero.centre, zero.radius) == (0, 0)


def test_poles_that_cannot_be_told_apart_are_counted() -> None:
    """A shift register has the pole 0 thrice; two axes that are alike have each pole twice."""
    shift = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    (register,) = found(model(shift, [[0, 0, 1]], np.diag([1, 0, 0]).tolist(), [[1]]))
    assert register.count == 3
    assert abs(register.centre) <= register.radius < 1e-4
    axis, seen, driven = [[1, 1], [0, 1]], [[1, 0]], [[0, 0], [0, 1]]
    twice = (np.kron(np.eye(2, dtype=int), x).tolist() for x in (axis, seen, driven, [[1]]))
    both, one = model(*twice), model(axis, seen, driven, [[1]])
    assert [pole.count for pole in found(both)] == [2, 2]
    for double, single in zip(found(both), found(one), strict=True):
        assert abs(double.centre - single.centre) <= double.radius + single.radius < 1e-14


def test_a_pair_next_to_the_real_line_is_not_taken_for_real() -> None:
    """Discs that reach the line, and do not meet: the conjugate lies in the other one."""
    above, below = ((flint.acb(0.5, y), flint.arb(1.5e-10), 1) for y in (1e-10, -2.25e-10))
    assert _pole(above, (above, below)).centre.imag == 1e-10
    assert _pole(above, (above,)).centre.imag == 0


@pytest.mark.sampled
def test_drawn_models_against_numpy() -> None:
    draw = random.Random(8)
    for _ in range(samples(5)):
        of = drawn(draw, draw.randint(2, 6), 2, draw.choice(["plain", "unstable", "correlated"]))
        state = steady(of)
        loop = (of.f - state.enclosures["predictor"] @ of.h).c
        theirs = np.linalg.eigvals([[float(x) for x in row] for row in loop])
        ours = poles(of, state.enclosures, state.certificate["parts"][0])
        assert sum(pole.count for pole in ours) == len(loop)
        for z in theirs:
            assert min(abs(z - pole.centre) - pole.radius for pole in ours) < 1e-8
        assert all(abs(pole.centre) < 1 for pole in ours)
        assert Fraction(max(pole.radius for pole in ours)) < Fraction(1, 10**8)
