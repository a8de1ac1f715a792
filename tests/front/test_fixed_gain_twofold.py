"""Numbers of twice the precision against exact fractions."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.fixed_gain.kernel_reach import gap
from gainproof.fixed_gain.stability import CONDITIONS
from gainproof.fixed_gain.twofold import Twofold

SIZE = st.floats(-60, 60).map(lambda e: 2.0**e)
NUMBER = st.tuples(SIZE, st.sampled_from([-1.0, 1.0])).map(lambda pair: pair[0] * pair[1])


@pytest.mark.parametrize(
    "operation",
    [lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: (a + b) * (a - b)],
)
@settings(max_examples=samples(30), deadline=None)
@given(NUMBER, NUMBER, NUMBER, NUMBER)
def test_operations(
    operation: Callable[[Any, Any], Any], a: float, b: float, c: float, d: float
) -> None:
    """Of sums of two floats each; a sum errs by 2^-100 of its terms, which may cancel."""
    first, second = (Twofold.of(np.array([x])) for x in (a, c))
    found = operation(first + b * 2.0**-60, second + d * 2.0**-60)
    p, q = (Fraction(x) + Fraction(y) / 2**60 for x, y in ((a, b), (c, d)))
    true = operation(p, q)
    size = max(abs(p), abs(q)) + abs(p * q) + (abs(p) + abs(q)) ** 2
    error = Fraction(float(found.high[0])) + Fraction(float(found.low[0])) - true
    assert abs(error) <= size / 2**99


def test_sides_with_numbers() -> None:
    """4 - 2 a, c (1 - a/2), as the inequalities are written."""
    a = np.array([1.9999999999999998, 0.1])
    pair = Twofold.of(a)
    for found, true in (
        (4 - 2 * pair, [4 - 2 * Fraction(x) for x in a]),
        (pair * (1 - pair / 2), [Fraction(x) * (1 - Fraction(x) / 2) for x in a]),
    ):
        for high, low, wanted in zip(found.high, found.low, true, strict=True):
            assert abs(Fraction(float(high)) + Fraction(float(low)) - wanted) <= wanted / 2**100


@settings(max_examples=samples(30), deadline=None)
@given(st.floats(1e-6, 1.999), st.floats(1e-6, 0.999), st.floats(-60.0, -1.0))
def test_gaps_of_all_sizes(alpha: float, share: float, near: float) -> None:
    """Within 4 * 2^-52 of themselves, among numbers that are computed in other ways."""
    beta = (4 - 2 * alpha) * share
    gamma = alpha * beta / (1 - alpha / 2) * (1 - 2.0**near)
    others = [np.array([x, x, 0.5]) for x in (alpha, beta, gamma)]
    for condition in (CONDITIONS[3][2], CONDITIONS[3][4]):
        exact = [Fraction(x) for x in (alpha, beta, gamma)]
        true = condition.greater(*exact) - condition.less(*exact)
        found = gap(condition, others)
        assert found[0] == found[1]
        assert abs(Fraction(float(found[0])) - true) <= abs(true) * 4 / 2**52
