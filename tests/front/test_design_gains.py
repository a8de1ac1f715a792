"""Gains of named filters for arrays: the relations of the lecture, errors with bound and place."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from gainproof.design.gains import gains_of


def test_gains_of_arrays_lie_on_the_relations() -> None:
    """The lecture's, for each way to ask."""
    alpha, beta = gains_of("MV", lag=[2, 100])
    assert alpha == pytest.approx(np.sqrt(beta) - beta / 2, rel=1e-15)
    assert beta == pytest.approx([0.5, 0.01])
    alpha, beta = gains_of("MV", alpha=[0.1, 0.5, 0.4])
    assert beta == pytest.approx((1 - np.sqrt(1 - 2 * alpha)) ** 2)
    assert gains_of("MV", alpha=[0.1, 0.5], fast=True)[1] == pytest.approx([3.5888543820, 1])
    alpha, beta, gamma = gains_of("RA", 3, tracking_index=[0.01, 1.0])
    assert beta**2 == pytest.approx(2 * alpha * gamma)
    assert gains_of("RJ", 3, lag=[[3.0], [50.0]])[2] == pytest.approx(np.array([[1 / 3], [0.02]]))


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"name": "MV", "alpha": [0.4, 0.6]}, "does not exist at index 1: alpha must be above 0 "),
        ({"name": "RV", "lag": 0.5}, r"lag must be above (1 + sqrt(2))/4 = 0.6036: faster ones"),
        ({"name": "MV", "tracking_index": 1}, "has no tracking index: give a lag or an alpha"),
        ({"name": "XY", "lag": 1}, "no filter of 2 states is called 'XY'; known: RV, RA, MV, NP-S"),
        (
            {"name": "RV", "states": 4, "lag": 1},
            "no filter of 4 states is called 'RV'; known: none",
        ),
        ({"name": "RV"}, "one of lag, alpha, tracking_index is wanted, got 0"),
        ({"name": "RV", "lag": 1, "alpha": 0.5}, "is wanted, got 2"),
        ({"name": "RV", "lag": float("nan")}, "lag must be finite, got nan"),
        ({"name": "RJ", "states": 3, "lag": [10, 1e99]}, "at most 1e9, got 1e+99 at index 1"),
        ({"name": "MV", "states": 3, "alpha": [0.5, 1e-99]}, "no lag in reach gives 1e-99"),
    ],
)
def test_gains_that_there_are_not_are_named(arguments: dict[str, Any], told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        gains_of(**arguments)
