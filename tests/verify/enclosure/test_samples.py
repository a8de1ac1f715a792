"""Gains sample by sample: by hand, and against the recursion in exact fractions."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from riccati_recursion import boxed, covariance, drawn, model

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.samples import NoGain, gains_by_sample
from gainproof.verify.enclosure.steady import steady

HALF = Fraction(1, 2**54)


def inverse(a: list[list[Fraction]]) -> Box:
    """Of one or two rows, by hand."""
    if len(a) == 1:
        return Box([[1 / a[0][0]]])
    (p, q), (r, s) = a
    return Box([[x / (p * s - q * r) for x in row] for row in ((s, -q), (-r, p))])


def test_a_constant_that_nothing_moves_is_a_mean() -> None:
    """From the variance v the gain at sample k is v/(k v + 1), by hand, without a steady state."""
    found = gains_by_sample(model([[1]], [[1]], [[0]], [[1]]), boxed([[1000]]), 40)
    for k, each in enumerate(found, start=1):
        for name in ("filter", "predictor", "updated"):
            c, e = each[name].c[0][0], each[name].radius[0][0]
            assert abs(c - Fraction(1000, 1000 * k + 1)) <= e < Fraction(1, 2**60)


@pytest.mark.sampled
@pytest.mark.parametrize("kind", ["plain", "correlated", "unstable", "units"])
def test_drawn_models_against_fractions(kind: str) -> None:
    draw = random.Random(kind)
    of = drawn(draw, 3, 2, kind)
    p = Box(covariance(draw, 3, 3))
    for each in gains_by_sample(of, p, 5):
        seen = p @ of.h.turned()
        sigma = of.h @ seen + of.r
        cross = of.f @ seen + of.s
        gain = seen @ inverse(sigma.c)
        predictor = cross @ inverse(sigma.c)
        updated = p - gain @ seen.turned()
        true = {"predicted": p, "updated": updated, "filter": gain, "predictor": predictor}
        for name, box in true.items():
            for rows in zip(each[name].c, each[name].radius, box.c, strict=True):
                for c, e, x in zip(*rows, strict=True):
                    assert abs(c - x) <= e
        for i in range(3):
            assert each["predicted"].radius[i][i] <= HALF * p.c[i][i]
        p = of.f @ p @ of.f.turned() + of.q - predictor @ cross.turned()


def test_they_come_to_the_steady_state() -> None:
    of = model([[1, 1], [0, 1]], [[1, 0]], [[1, 3], [3, 9]], [[0]])
    last = gains_by_sample(of, boxed([[1, 0], [0, 1]]), 200)[-1]
    end = steady(of).enclosures
    for name, box in end.items():
        for rows in zip(box.c, box.radius, last[name].c, last[name].radius, strict=True):
            for c, e, x, d in zip(*rows, strict=True):
                assert abs(c - x) <= e + d + Fraction(1, 2**100)


def test_what_is_known_already_has_no_gain() -> None:
    """Measured without noise and never moved: after one sample nothing is left to measure."""
    with pytest.raises(NoGain, match="sample 2: "):
        gains_by_sample(model([[1]], [[1]], [[0]], [[0]]), boxed([[1]]), 3)
