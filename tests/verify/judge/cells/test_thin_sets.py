"""False statements that hold in every open cell: they fail on a curve, a line or a point."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement

x, y, z, w = (symbol(name) for name in "xyzw")
ZERO, ONE = number(0), number(1)
REAL, POSITIVE = Box(stated=False), Box(lower=Fraction(0))
CLOSED = Box(lower=Fraction(0), upper=Fraction(1), lower_open=False, upper_open=False)
CUBIC = power(y, 2) - power(x, 2) * (x - 1)


def square(expr: Expr) -> Expr:
    return power(expr, 2)


@pytest.mark.parametrize(
    ("rel", "given", "box", "point"),
    [
        # a corner and an edge of a closed box
        (Rel("<", ZERO, square(x - 1) + square(y - 1)), (), CLOSED, {"x": "1", "y": "1"}),
        (Rel("<", ZERO, x + square(2 * y - 1)), (), CLOSED, {"x": "0", "y": "1/2"}),
        # a point of a line on which the border's own leading coefficient vanishes
        (Rel("<", ZERO, square(x * z - y) + square(x)), (), REAL, {"x": "0", "y": "0", "z": "0"}),
        # the handle of the umbrella, which no cell touches
        (Rel("<", ZERO, square(square(x) - z * square(y)) + square(z + 1)), (), REAL,
         {"x": "0", "y": "0", "z": "-1"}),
        # an isolated point of a cubic curve, as an equation and below a root
        (Rel("<=", ONE, x), (Rel("=", CUBIC, ZERO),), REAL, {"x": "0", "y": "0"}),
        (Rel("<=", ONE, x), (Rel("<=", ZERO, sqrt(-CUBIC)),), REAL, {"x": "0", "y": "0"}),
        # conditions that leave one point
        (Rel("<", y, ONE), (Rel("<=", square(x * (x - 1)) + square(y - 1), ZERO),), REAL,
         {"x": "0", "y": "1"}),
        (Rel("<", x, ONE), (Rel("<=", square(x - 1) + square(y) + square(z), ZERO),), REAL,
         {"x": "1", "y": "0", "z": "0"}),
        # both coordinates of the point are irrational
        (Rel("<", ZERO, square(power(x, 3) - 2) + square(power(y, 3) - 3)), (), REAL, None),
        # a product with zero hides where there is no value
        (Rel("=", 0 * (1 / (x * y - 1)) + x, x), (), POSITIVE, {"x": "1", "y": "1"}),
    ],
)  # fmt: skip
def test_the_failing_point_is_found(
    rel: Rel, given: tuple[Rel, ...], box: Box, point: dict[str, str] | None
) -> None:
    statement = Statement((rel,), given)
    outcome = decide_in_cells(statement, dict.fromkeys(statement.symbols(), box))
    assert outcome.verdict in ("conditional", "refuted")
    assert outcome.witness is not None
    if point is not None:
        assert outcome.witness.point == point
    else:
        assert all("the root of" in value for value in outcome.witness.point.values())


@pytest.mark.parametrize(
    ("rel", "given"),
    [
        (Rel("<=", ZERO, square(x * z - y) + square(x)), ()),
        (Rel("<=", ZERO, square(square(x) - z * square(y)) + square(z + 1)), ()),
        (Rel("<=", ZERO, x), (Rel("=", CUBIC, ZERO),)),
        (Rel("<=", x * x, x * x * x), (Rel("=", CUBIC, ZERO),)),
        (Rel("=", y, ONE), (Rel("<=", square(x * (x - 1)) + square(y - 1), ZERO),)),
    ],
)
def test_the_true_neighbour_is_proved(rel: Rel, given: tuple[Rel, ...]) -> None:
    statement = Statement((rel,), given)
    assert decide_in_cells(statement, {}).verdict == "proved"
