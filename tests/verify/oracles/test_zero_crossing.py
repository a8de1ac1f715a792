"""Crossings of functions whose places are known in closed form, and how few signs are asked for."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import flint
import pytest

from gainproof.verify.oracles.zero_crossing import between

BITS = 150
Rising = Callable[[flint.arb], flint.arb]
PLACES: dict[str, tuple[Rising, Fraction, Fraction, Callable[[], flint.arb]]] = {
    "a root": (lambda x: x * x - 2, Fraction(1), Fraction(2), lambda: flint.arb(2).sqrt()),
    "far below its end": (
        lambda x: x**3 - flint.arb(10) ** -90,
        Fraction(1, 10**60),
        Fraction(10**9),
        lambda: flint.arb(10) ** -30,
    ),
    "close to its end": (
        lambda x: 1 / (2 - x) - flint.arb(2) ** 80,
        Fraction(1),
        2 - Fraction(1, 2**90),
        lambda: 2 - flint.arb(2) ** -80,
    ),
    "flat before and steep behind": (
        lambda x: (40 * x).exp() - flint.arb(10) ** 9,
        Fraction(1, 100),
        Fraction(1),
        lambda: flint.arb(10).log() * 9 / 40,
    ),
}


@pytest.mark.parametrize("name", PLACES)
def test_the_place_is_between(name: str) -> None:
    rising, low, high, true = PLACES[name]
    asked: list[flint.arb] = []

    def counted(x: flint.arb) -> flint.arb:
        asked.append(x)
        return rising(x)

    with flint.ctx.workprec(700):
        below, above = between(low, high, counted, BITS)
        assert above - below <= below / 2**BITS
        assert true() > _ball(below) * (1 - flint.arb(2) ** -600)
        assert true() < _ball(above) * (1 + flint.arb(2) ** -600)
        assert rising(_ball(below)) < 0 < rising(_ball(above))
    # by halving there would be 150 and more
    assert len(asked) < 140


def test_a_line_takes_few() -> None:
    asked: list[flint.arb] = []

    def line(x: flint.arb) -> flint.arb:
        asked.append(x)
        return x - flint.arb(2).sqrt()

    with flint.ctx.workprec(700):
        between(Fraction(1), Fraction(2), line, BITS)
    assert len(asked) < 40


def _ball(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))
