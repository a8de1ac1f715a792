"""Statements with sizes |a|, decided with these written out by signs; false ones beside them."""

from __future__ import annotations

from fractions import Fraction

import pytest
from one_of_each import further
from small_claims import check, judged

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, absolute, neg, number, power, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental.absolute_values import by_sizes, without_sizes
from gainproof.verify.judge.transcendental.free_values import VALUED

TRUE = [
    (r"\lvert \sin x \rvert \leq \lvert x \rvert", None),
    (r"\lvert x \rvert \geq \lvert \sin x \rvert", None),
    (r"\lvert \sin x - x \rvert \leq \frac{\lvert x \rvert^3}{6}", None),
    (r"\lvert \cos x - 1 \rvert \leq \frac{x^2}{2}", None),
    (r"\lvert \arctan x \rvert \leq \lvert x \rvert", "-1 < x < 2"),
    (r"\lvert \sin x \rvert < 2 x", "x > 0"),
    further(r"e^{-\lvert x \rvert} \leq \frac{1}{1 + \lvert x \rvert}", None),
    (r"\lvert x \rvert e^{-\lvert y \rvert} \leq \lvert x \rvert", None),
    (r"\lvert \tanh x \rvert \leq \lvert x \rvert", "x < 0"),
    further(r"\lvert \tan x \rvert \geq \lvert x \rvert", "-1 < x < 1"),
    (r"\lvert \tan x \rvert \geq x", "0 < x < 1"),
    (r"x \leq \lvert \ln(1 - x) \rvert", "0 < x < 1"),
]
FALSE = [
    (r"\lvert \sin x \rvert \leq \lvert x \rvert - x^4", None),
    (r"\lvert \sin x - x \rvert \leq \frac{\lvert x \rvert^3}{7}", None),
    (r"\lvert \cos x - 1 \rvert \leq \frac{x^2}{3}", None),
    # true of one sign alone
    (r"\lvert \sin x \rvert \leq x", "-1 < x < 1"),
    (r"e^{\lvert x \rvert} \leq e^{x}", None),
    (r"e^x - 1 \leq 2 \lvert x \rvert", "-1 < x < 2"),
    (r"\lvert e^x - 1 \rvert \leq \lvert x \rvert", "x > -1"),
    (r"\lvert \sin x \rvert \geq \lvert x \rvert", "-1 < x < 1"),
    (r"\lvert \ln x \rvert \geq x - 1", "x > 0"),
    # equal at 0 alone
    (r"\lvert \sin x \rvert < \lvert x \rvert", None),
]


def line(latex: str, domain: str | None) -> str:
    return f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "domain"), TRUE)
def test_true(latex: str, domain: str | None) -> None:
    found = judged("inequality", line(latex, domain))
    check(found, "proved")
    assert found.certificate is not None
    assert replay(found.certificate, "proved") is None


@pytest.mark.parametrize(("latex", "domain"), FALSE)
def test_false(latex: str, domain: str | None) -> None:
    check(judged("inequality", line(latex, domain)), "refuted")


@pytest.mark.parametrize(
    ("latex", "domain", "told"),
    [
        (r"\lvert \sin x \rvert \leq \lvert x \rvert", None, "everywhere"),
        (
            r"\lvert \sin x \rvert \leq \lvert x \rvert",
            r"-\pi \leq x \leq \pi",
            "-pi <= x, x <= pi",
        ),
        (r"\lvert \tan x \rvert \geq x", r"0 \leq x < \pi/2", "0 <= x/pi < 1/2"),
        (r"\lvert \tan x \rvert \geq x", "0 < x < 1", "0 < x < 1"),
        (r"\ln x \leq \ln \pi", r"0 < x \leq \pi", "x > 0, x <= pi"),
    ],
)
def test_where_is_told(latex: str, domain: str | None, told: str) -> None:
    found = judged("inequality", line(latex, domain))
    check(found, "proved")
    assert found.domain == told


def test_it_says_how() -> None:
    found = judged("inequality", TRUE[0][0])
    assert found.method is not None
    assert found.method.startswith("sizes by signs; ")


X, Y = symbol("x"), symbol("y")


def written(*rels: Rel, **boxes: Box) -> list[tuple[tuple[Rel, ...], Box | None]]:
    """The parts' relations, and where x lives in each."""
    parts = without_sizes(Statement(rels), boxes)
    return [(part.relations, where.get("x")) for part, where in parts]


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\lvert \sin x - 2 \rvert = \sin x - 2", "x > 0"),
        (r"\lvert \tan x \rvert = \tan x", "-1 < x < 1"),
    ],
)
def test_what_has_a_sign_need_not_be_its_size(latex: str, domain: str) -> None:
    assert judged("identity", line(latex, domain)).verdict == "refuted"


def test_an_equivalence_does_not_follow_from_what_says_more() -> None:
    sine = Expr("call", "sin", (X,))
    size = Rel(">=", absolute(sine), number(Fraction(1, 2)))
    both_ways = Statement((size,), (Rel(">=", sine, number(Fraction(1, 2))),), "iff")
    assert by_sizes(both_ways, {}, None, {}, lambda *_: Outcome("proved", "", "", "")) is None


def test_a_bound_of_a_size_is_two_bounds() -> None:
    sine = Expr("call", "sin", (X,))
    assert written(Rel("<=", absolute(sine), Y)) == [
        ((Rel("<=", sine, Y), Rel("<=", neg(sine), Y)), None)
    ]
    assert written(Rel(">", Y, absolute(sine))) == [
        ((Rel(">", Y, sine), Rel(">", Y, neg(sine))), None)
    ]


@pytest.mark.parametrize("operator", ["=", "!=", ">=", ">"])
def test_what_else_is_said_of_a_size_is_left(operator: str) -> None:
    sine = Expr("call", "sin", (X,))
    assert written(Rel(operator, absolute(sine), Y)) == []
    assert written(Rel("<=", power(power(sine, 2), Fraction(3, 2)), Y)) == []


def test_what_holds_of_one_part_where_it_has_a_value_holds_there_of_the_whole() -> None:
    statement = Statement((Rel("=", absolute(X), Y),))
    words = iter([VALUED, "x <= 0"])
    found = by_sizes(statement, {}, None, {}, lambda *_: Outcome("proved", next(words), "", "seen"))
    assert found is not None
    assert (found.domain, found.method) == (VALUED, "sizes by signs; seen")


@pytest.mark.parametrize("verdicts", [("proved", "held"), ("refuted", "proved"), ("conditional",)])
def test_every_part_has_to_be_proved(verdicts: tuple[str, ...]) -> None:
    statement = Statement((Rel("=", absolute(X), Y),))
    each = iter(verdicts)
    found = by_sizes(
        statement, {}, None, {}, lambda *_: Outcome(next(each, "proved"), "", "", "seen")
    )
    assert found is None


def test_a_size_that_is_larger_follows_from_either_sign() -> None:
    sine = Expr("call", "sin", (X,))
    asked: list[Rel] = []

    def decides(statement: Statement, *_: object) -> Outcome:
        asked.extend(statement.relations)
        raise Undecided("not now")

    for operator in (">=", "=", "<", "!="):
        by_sizes(Statement((Rel(operator, absolute(sine), Y),)), {}, None, {}, decides)
    two_bounds = [Rel("<", sine, Y), Rel("<", neg(sine), Y)]
    assert asked == [Rel(">=", sine, Y), Rel(">=", neg(sine), Y), *two_bounds]


def test_a_symbol_has_both_signs_where_its_domain_has() -> None:
    rel = Rel("=", absolute(X), Y)
    up, down = Box(Fraction(0), lower_open=False), Box(None, Fraction(0), upper_open=False)
    as_it_is, turned = (Rel("=", X, Y),), (Rel("=", neg(X), Y),)
    unsaid = Box(None, Fraction(0), upper_open=False, stated=False)
    assert written(rel)[1] == (turned, unsaid)
    assert written(rel, x=Box()) == [(as_it_is, up), (turned, down)]
    positive, negative = Box(Fraction(0)), Box(Fraction(-3), Fraction(0))
    assert written(rel, x=positive) == [(as_it_is, positive)]
    assert written(rel, x=negative) == [(turned, negative)]
    beyond = Box(Fraction(-3), Fraction(2))
    assert [where for _, where in written(rel, x=beyond)] == [
        Box(Fraction(0), Fraction(2), lower_open=False),
        Box(Fraction(-3), Fraction(0), upper_open=False),
    ]


def test_powers_of_sizes_are_written_out_too() -> None:
    cube, below = power(power(X, 2), Fraction(3, 2)), power(power(X, 4), Fraction(-1, 2))
    ((plain,), _), ((turned,), _) = written(Rel("=", cube, below))
    assert plain == Rel("=", power(X, 3), power(X, -2))
    assert turned == Rel("=", power(neg(X), 3), power(neg(X), -2))


def test_other_roots_are_no_sizes() -> None:
    for root in (power(power(X, 2), Fraction(1, 3)), power(power(X, 3), Fraction(1, 2))):
        assert written(Rel("=", root, number(1))) == []
    over_one = power(power(X, -2), Fraction(1, 2))
    assert written(Rel("=", over_one, number(1))) == []


def test_an_index_of_a_sum_has_no_part_of_its_own() -> None:
    total = Expr("call", "sum", (absolute(X), X, number(-2), number(2)))
    assert written(Rel("=", total, Y)) == []


def test_more_symbols_than_that_are_left() -> None:
    names = [symbol(name) for name in "abcd"]
    product = absolute(names[0]) * absolute(names[1]) * absolute(names[2])
    assert len(without_sizes(Statement((Rel("<", product, Y),)), {})) == 8
    assert without_sizes(Statement((Rel("<", product * absolute(names[3]), Y),)), {}) == []
