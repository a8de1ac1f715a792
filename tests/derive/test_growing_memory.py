"""Least-squares gains: symbolic forms against exact fits computed sample by sample."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy as sp

from gainproof.derive.growing_memory.fit import K, fit


def _fitted(degree: int, samples: list[Fraction]) -> list[Fraction]:
    """Value and derivatives at the newest sample of the least-squares polynomial, exactly."""
    newest = len(samples) - 1
    rows = [
        [Fraction(i - newest) ** m / math.factorial(m) for m in range(degree + 1)]
        for i in range(newest + 1)
    ]
    normal = sp.Matrix(degree + 1, degree + 1, lambda a, b: sum(r[a] * r[b] for r in rows))
    right = sp.Matrix(
        degree + 1, 1, lambda a, _: sum(r[a] * y for r, y in zip(rows, samples, strict=True))
    )
    return [Fraction(int(v.p), int(v.q)) for v in normal.LUsolve(right)]


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_gain_is_the_weight_of_the_newest_sample(degree: int) -> None:
    gain = fit(degree).gain
    for number in range(degree, degree + 6):
        impulse = [Fraction(0)] * number + [Fraction(1)]
        exact = _fitted(degree, impulse)
        assert [Fraction(str(value.subs(K, number))) for value in gain] == exact
