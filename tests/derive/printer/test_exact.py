"""The end of a domain is found whatever is guessed of it."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import flint
import pytest

from gainproof.derive.printer.exact import crossing, enclosures, is_normal, last_that_holds
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.program import program

GUESSES = (math.nan, math.inf, 0.0, 1e-30, 0.999, 1.0, 1.75, 2.0, 2.25, 3.0, 4.0, 5.0, 1e30)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("guess", GUESSES)
def test_a_guess_changes_nothing(form: Format, guess: float) -> None:
    for limit in (1.0, form.after(1.0), 2.0, 2.25, form.before(4.0)):
        up = last_that_holds(limit.__ge__, 1.0, 4.0, form, guess)
        assert up == limit
        down = last_that_holds(limit.__lt__, 4.0, 1.0, form, guess)
        assert down == form.after(limit)


def test_a_good_guess_asks_little() -> None:
    asked: list[float] = []
    limit = 2.25

    def holds(x: float) -> bool:
        asked.append(x)
        return x <= limit

    guess = limit * (1.0 + 4.0 * FLOAT64.epsilon)
    assert last_that_holds(holds, 1.0, 4.0, FLOAT64, guess) == limit
    assert len(asked) < 12
    assert all(x != y for x, y in pairwise(asked))


def test_the_guess_for_a_power_is_the_place() -> None:
    builder = GraphBuilder()
    x = builder.symbol("x")
    steps = program(builder.graph({"cube": 3 * x * x * x}))
    number, top = steps.outputs["cube"], FLOAT32.largest
    place = crossing(steps, number, 2.0**-30, 2.0**-50, FLOAT32, top)
    assert place == pytest.approx((FLOAT32.least_normal / 3) ** (1 / 3), rel=1e-15)
    end = last_that_holds(
        lambda x: is_normal(steps, number, x, FLOAT32, top), 2.0**-30, 2.0**-50, FLOAT32, place
    )
    assert 3 * end**3 >= FLOAT32.least_normal > 3 * FLOAT32.before(end) ** 3


@pytest.mark.parametrize("first", [True, False])
def test_a_condition_is_decided_exactly_and_in_the_format(first: bool) -> None:
    """Of x < 1/10 and 1/10 < x; the format's number beside 1/10 stands for it."""
    builder = GraphBuilder()
    x, limit = builder.symbol("x"), Fraction(1, 10)
    less, than = (x, limit) if first else (limit, x)
    steps = program(builder.graph({"y": builder.select(less, than, x, 2 * x)}))
    for form in FORMATS:
        place = form.at_least(limit) if first else form.at_most(limit)
        inside = form.before(place) if first else form.after(place)
        for given, factor in ((place, 2), (inside, 1)):
            found = enclosures(steps, given, form, 64)[steps.outputs["y"]]
            assert found == factor * flint.arb(given)
    between = 0.1 + 1e-10 if first else 0.1 - 1e-10
    for form, factor in ((FLOAT64, 2), (FLOAT32, 1), (FLOAT64, 2)):
        found = enclosures(steps, between, form, 64)[steps.outputs["y"]]
        assert found == factor * flint.arb(between)


def test_balls_have_the_precision_that_is_asked_for() -> None:
    builder = GraphBuilder()
    x = builder.symbol("x")
    steps = program(builder.graph({"y": builder.sqrt(x) * builder.sqrt(3)}))
    for precision in (64, 256, 64, 1024):
        *_, found = enclosures(steps, 2.0, FLOAT64, precision)
        with flint.ctx.workprec(2048):
            assert found.contains(flint.arb(6).sqrt())
            assert 2.0 ** (-precision - 4) < float(found.rad()) < 2.0 ** (8 - precision)


def test_a_part_of_the_steps_is_the_same_part_later() -> None:
    builder = GraphBuilder()
    x = builder.symbol("x")
    steps = program(builder.graph({"y": (x + 1) * (x + 2)}))
    for last in (1, 4, 2, None):
        wanted = len(steps.steps) if last is None else last + 1
        assert len(enclosures(steps, 2.0, FLOAT64, 64, last)) == wanted
    assert enclosures(steps, 2.0, FLOAT64, 64)[-1] == 12
