"""Identities and inequalities in two parameters and more, true and false, with their exact sets."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
from one_of_each import cases, further

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

x, y, z, w = (symbol(name) for name in "xyzw")
REAL, STATED, POSITIVE = Box(stated=False), Box(), Box(lower=Fraction(0))
UNIT = Box(lower=Fraction(0), upper=Fraction(1))
CLOSED = Box(lower=Fraction(0), upper=Fraction(1), lower_open=False, upper_open=False)


def judged(operator: str, left: Expr, right: Expr | int, box: Box, *given: Rel) -> Outcome:
    wanted = right if isinstance(right, Expr) else number(right)
    statement = Statement((Rel(operator, left, wanted),), given)
    return decide_in_cells(statement, dict.fromkeys(statement.symbols(), box))


def square(expr: Expr) -> Expr:
    return power(expr, 2)


@pytest.mark.parametrize(
    ("operator", "left", "right", "box"),
    [
        ("<=", 2 * x * y, square(x) + square(y), REAL),
        ("<=", sqrt(square(x) + square(y)), x + y, POSITIVE),
        ("<", sqrt(square(x) + square(y)), x + y, POSITIVE),
        ("<=", sqrt(x * y), (x + y) / 2, POSITIVE),
        ("<=", 27 * x * y * z, power(x + y + z, 3), POSITIVE),
        ("=", sqrt(square(x) + 2 * x * y + square(y)), x + y, POSITIVE),
        ("=", sqrt(square(x - y)) + x + y, 2 * sqrt((square(x + y) + square(x - y)
              + 2 * sqrt(square(x + y) * square(x - y))) / 4), POSITIVE),
        ("<=", square(x * z + y * w), (square(x) + square(y)) * (square(z) + square(w)), REAL),
        ("<=", sqrt(square(x + z) + square(y + w)),
         sqrt(square(x) + square(y)) + sqrt(square(z) + square(w)), POSITIVE),
        ("<=", 3 * square(x * y), power(x, 4) * square(y) + square(x) * power(y, 4) + 1, REAL),
        (">", power(x, 4) + power(y, 4) - x * y + 1, number(0), CLOSED),
        (">", power(x, 4) + power(y, 4) - x * y + 1, number(0), REAL),
        ("<=", x * y, x, CLOSED),
    ],
)  # fmt: skip
def test_true_statements_are_proved(operator: str, left: Expr, right: Expr, box: Box) -> None:
    assert judged(operator, left, right, box).verdict == "proved"


@pytest.mark.parametrize(
    ("operator", "left", "right", "box", "domain"),
    [
        ("=", sqrt(square(x - y)), x - y, POSITIVE, "for x > 0, y > 0, x - y >= 0"),
        ("<", 2 * x * y, square(x) + square(y), REAL, "for x - y != 0"),
        ("<=", sqrt(square(x) + square(y)), x + y, STATED, "for x >= 0, y >= 0"),
        ("<", number(0), square(x) * square(y), REAL, "for x != 0, y != 0"),
        ("<", number(0), square(x) + square(y), REAL, "for x^2 + y^2 != 0"),
        ("!=", square(x) + square(y), number(0), REAL, "for x^2 + y^2 != 0"),
        ("=", (x - y) / (x - y), number(1), STATED, "for x - y != 0"),
        ("<", x * y, x + 1 - y, CLOSED, "for 0 <= x <= 1, 0 <= y <= 1, y - 1 != 0"),
    ],
)
def test_sets_of_truth_are_exact(
    operator: str, left: Expr, right: Expr, box: Box, domain: str
) -> None:
    outcome = judged(operator, left, right, box)
    assert outcome.verdict == "conditional"
    assert outcome.domain == domain
    assert "holds exactly" in outcome.reason
    assert outcome.witness is not None


def test_divisors_that_vanish_are_named() -> None:
    ratio = (x - y) / (x - y)
    free = judged("=", ratio, 1, REAL)
    assert (free.verdict, free.domain) == ("proved", "for x - y != 0")
    half = decide_in_cells(Statement((Rel("=", ratio, number(1)),)), {"x": STATED, "y": REAL})
    assert (half.verdict, half.domain) == ("conditional", "for x - y != 0")


def test_thin_truth_beside_the_region_is_not_called_exact() -> None:
    outcome = judged("=", sqrt(square(x)) * y, x * y, STATED)
    assert outcome.verdict == "conditional"
    assert "holds at least for x >= 0" in outcome.reason


def test_a_domain_without_few_signs_is_where_there_are_values() -> None:
    k = x * square(y) + square(x) / 4
    c = x * k * (1 + square(y) / 6)
    p = 2 * square(y) * x * c - square(y) * square(k) * (square(y) - 4)
    q = square(c) - 4 * square(y) * power(k, 3)
    first = square(square(y) * x)
    root = sqrt((-p + sqrt(square(p) - 4 * first * q)) / (2 * first))
    outcome = judged("=", first * power(root, 4) + p * square(root) + q, 0, POSITIVE)
    assert outcome.verdict == "conditional"
    assert outcome.domain == "for x > 0, y > 0, wherever it has a value"
    assert "holds exactly" in outcome.reason


def test_a_tiny_or_hidden_error_is_found() -> None:
    tiny = number(Fraction(1, 10**12))
    outcome = judged("<=", 2 * x * y, square(x) + square(y) - tiny * x, POSITIVE)
    assert outcome.verdict == "conditional"
    disc = square(x - number(Fraction(123457, 1000))) + square(y - 17)
    hidden = judged(">", disc, number(Fraction(1, 10**12)), POSITIVE)
    assert hidden.verdict == "conditional"
    assert hidden.witness is not None
    assert hidden.witness.point == {"x": "123457/1000", "y": "17"}


def test_witnesses_are_small_integers_where_there_are_some() -> None:
    outcome = judged("=", sqrt(square(x) + square(y)), x + y, POSITIVE)
    assert outcome.verdict == "refuted"
    assert outcome.witness is not None
    assert outcome.witness.point == {"x": "1", "y": "1"}


def test_what_has_no_value_is_never_proved() -> None:
    nothing = sqrt(-1 - square(x) - square(y))
    with pytest.raises(Undecided, match="no value"):
        judged("=", nothing, nothing, REAL)
    assert judged("=", nothing, nothing, STATED).verdict == "refuted"
    with pytest.raises(Undecided, match="thin set"):
        judged("=", sqrt(-square(x) - square(y)), 0, REAL)
    with pytest.raises(Undecided, match="conditions hold nowhere"):
        judged("=", x, y, REAL, Rel("<", square(x) + square(y), number(0)))


def test_conditions_on_a_thin_set_are_followed() -> None:
    at_origin = Rel("<=", square(x) + square(y), number(0))
    assert judged("=", x, 0, REAL, at_origin).verdict == "proved"
    assert judged("=", x, 1, REAL, at_origin).verdict == "refuted"
    circle = Rel("=", square(x) + square(y), number(1))
    assert judged("<=", x + y, sqrt(number(2)), REAL, circle).verdict == "proved"
    assert judged("<", x + y, sqrt(number(2)), REAL, circle).verdict == "conditional"
    assert judged("<=", x + y, number(Fraction(141, 100)), REAL, circle).verdict == "conditional"
    cancelled = judged("=", x, y, REAL, Rel("=", x * square(z), y * square(z)))
    assert cancelled.domain == "for x = y"


def test_zeros_that_no_cell_touches_are_found() -> None:
    motzkin = power(x, 4) * square(y) + square(x) * power(y, 4) - 3 * square(x * y) + 1
    outcome = judged(">", motzkin, 0, REAL)
    assert outcome.verdict == "conditional"
    assert "holds exactly" in outcome.reason
    assert outcome.witness is not None
    assert {value.strip("-") for value in outcome.witness.point.values()} == {"1"}


def test_curves_of_degree_three_are_followed() -> None:
    folium = power(x, 3) + power(y, 3) - x * y + number(Fraction(1, 100))
    assert judged(">", square(folium), 0, REAL).verdict == "conditional"
    assert judged(">=", square(folium), 0, REAL).verdict == "proved"
    on_it = Rel("=", folium, number(0))
    positive = {"x": POSITIVE, "y": POSITIVE}
    near = Statement((Rel("<", x + y, number(1)),), (on_it,))
    assert decide_in_cells(near, positive).verdict == "proved"
    nearer = Statement((Rel("<", x + y, number(Fraction(9, 10))),), (on_it,))
    assert decide_in_cells(nearer, positive).verdict == "conditional"


def test_limits_are_named() -> None:
    many = Statement((Rel("<=", 2 * x * y, square(x) + square(y) + z + w),))
    with pytest.raises(Undecided, match="more than 3 parameters"):
        decide_in_cells(many, {}, limits=Limits(parameters=3))
    with pytest.raises(Undecided, match="more than 1 cells"):
        decide_in_cells(many, {}, limits=Limits(cells=1))
    with pytest.raises(Undecided, match="seconds over cells"):
        decide_in_cells(many, {}, limits=Limits(seconds=-1))
    with pytest.raises(Undecided, match="empty"):
        judged("=", x, y, Box(lower=Fraction(2), upper=Fraction(1)))


UNSOLVED = list(product([">", "!="], ["xyz", "wxyz"], [REAL, POSITIVE, CLOSED]))


@pytest.mark.alike
@pytest.mark.parametrize(
    ("operator", "names", "box"),
    cases(UNSOLVED, lambda case: case[1] == "xyz" or case == ("!=", "wxyz", POSITIVE)),
)
def test_what_fails_on_a_border_that_is_not_solved_is_not_proved(
    operator: str, names: str, box: Box
) -> None:
    """It fails where all symbols are one number, whose cube is 1/21 or 1/28; nowhere at small
    whole numbers or halves, whose cubes have no divisor of 7.
    """
    cubes = number(Fraction(-1, 7))
    for name in names:
        cubes = cubes + power(symbol(name), 3)
    with pytest.raises(Undecided, match="it holds wherever else"):
        judged(operator, square(cubes), 0, box)


@pytest.mark.parametrize(("cells", "extent"), [(3, "at least"), (4, "at least"), (5, "exactly")])
def test_cells_of_borders_count_too(cells: int, extent: str) -> None:
    """Two rays cut the quadrant in three: five pieces."""
    apart = Rel(">", square(x - y) * square(x - 2 * y), number(0))
    boxes = {"x": POSITIVE, "y": POSITIVE}
    found = decide_in_cells(Statement((apart,)), boxes, limits=Limits(cells=cells))
    assert found.verdict == "conditional"
    assert f"holds {extent} for" in found.reason


@pytest.mark.parametrize(
    "others", ["", further("a"), further("z"), further("ab"), "az", further("uvz"), "abyz"]
)
@pytest.mark.parametrize("vanishes", ["one", "difference", "product"])
def test_a_part_is_told_however_many_symbols_cancel(others: str, vanishes: str) -> None:
    """What both sides vanish on is no border of the part: a sample may lie there by chance."""
    p, q = symbol("p"), symbol("q")
    top = {"one": q, "difference": q - p - 1, "product": q * (q - 1) * (q - 2) * (q - 3)}[vanishes]
    left, right = top / sqrt(square(p) + square(q)), top / (p * sqrt(1 + square(q) / square(p)))
    for name in others:
        left = left + symbol(name) - symbol(name)
    found = judged("=", left, right, REAL)
    assert found.verdict == "conditional", found.reason
    assert found.domain == "for p > 0"
    assert found.witness is not None
    assert Fraction(found.witness.point["p"]) < 0
