"""The end of a domain is found whatever is guessed of it."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from gainproof.derive.printer.exact import crossing, is_normal, last_that_holds
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
