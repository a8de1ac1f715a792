"""The oracles of locations against what needs no oracle."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gainproof.verify.oracles.location_exact import Dual, fit, rational_root, values
from gainproof.verify.oracles.location_minimum import minimum
from gainproof.verify.oracles.matrices import identity


def test_roots_are_exact_or_refused() -> None:
    assert rational_root(Fraction(25, 144)) == Fraction(5, 12)
    with pytest.raises(ValueError, match="no square"):
        rational_root(Fraction(2))
    assert Dual(Fraction(9), Fraction(1)).root() == Dual(Fraction(3), Fraction(1, 6))


def test_a_target_between_two_stations_on_a_line() -> None:
    """Ranges 3 and 4 along the axes of a plane: the step is the residual, sign by sign."""
    stations = [tuple(map(Fraction, each)) for each in ((0, 4, 0, 0), (-3, 0, 0, 0))]
    state = tuple(map(Fraction, (0, 0, 1, 2)))
    rows = [(0, False), (1, False)]
    assert values(stations, state, [*rows, (0, True), (1, True)]) == (4, 3, -2, 1)
    found = fit(
        stations, state, rows, 2, [], identity(2, Fraction(1)), (Fraction(1, 7), Fraction(2))
    )
    assert found.step == (Fraction(2), Fraction(-1, 7))
    assert found.covariance == identity(2, Fraction(1))


def test_the_minimum_of_exact_observations_is_the_target() -> None:
    places = np.array([[0.0, 0.0], [9.0, 1.0], [2.0, 8.0]])
    target = np.array([4.0, 3.0])
    ranges = np.linalg.norm(target - places, axis=1) + 0.5
    found, cost = minimum(
        places,
        np.zeros((3, 2)),
        [(i, False) for i in range(3)],
        ranges,
        np.eye(3),
        np.ones((3, 1)),
        np.array([5.0, 2.0, 0.0]),
        moving=False,
    )
    assert np.allclose(found, [4, 3, 0.5], atol=1e-9)
    assert cost < 1e-18
