"""Identities with radicals: true on a branch, false by a hair, undefined somewhere."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

x, y = symbol("x"), symbol("y")
REAL, STATED = Box(stated=False), Box()
POSITIVE = Box(lower=Fraction(0))


def judged(operator: str, left: Expr, right: Expr, box: Box = REAL, **others: Box) -> Outcome:
    return decide(Statement((Rel(operator, left, right),)), {"x": box, **others}, "x")


@pytest.mark.parametrize(
    ("left", "right", "box"),
    [
        (sqrt(power(x, 2)), x, POSITIVE),
        (sqrt(1 + x) * sqrt(1 - x), sqrt(1 - x * x), REAL),
        (sqrt(power(x, 2) + 2 * x + 1), x + 1, POSITIVE),
        (sqrt(5 + 2 * sqrt(number(6))), sqrt(number(2)) + sqrt(number(3)), REAL),
        (power(2 + sqrt(number(5)), Fraction(1, 3)), (1 + sqrt(number(5))) / 2, REAL),
        (power(power(x, 3), Fraction(1, 3)), x, REAL),
        (1 / (sqrt(x + 1) + sqrt(x)), sqrt(x + 1) - sqrt(x), POSITIVE),
        (sqrt(x + sqrt(power(x, 2) - 1)) * sqrt(x - sqrt(power(x, 2) - 1)), number(1), REAL),
    ],
)
def test_true_identities_are_proved(left: Expr, right: Expr, box: Box) -> None:
    assert judged("=", left, right, box).verdict == "proved"


def test_identity_of_one_branch_is_conditional_with_its_exact_set() -> None:
    outcome = judged("=", sqrt(power(x, 2) - 6 * x + 9), x - 3, POSITIVE)
    assert outcome.verdict == "conditional"
    assert outcome.domain == "for x >= 3"
    assert outcome.witness is not None
    assert outcome.witness.point == {"x": "1"}


@pytest.mark.parametrize("tiny", [Fraction(1, 10**12), Fraction(1, 10**60), Fraction(1, 10**300)])
def test_tiny_error_is_refuted(tiny: Fraction) -> None:
    left = sqrt(x + 1) * sqrt(x + 1)
    outcome = judged("=", left, x + 1 + number(tiny) * power(x, 2), POSITIVE)
    assert outcome.verdict == "refuted"
    assert outcome.witness is not None
    left_side, right_side = outcome.witness.left, outcome.witness.right
    gap = abs(Fraction(left_side.midpoint) - Fraction(right_side.midpoint))
    assert gap > Fraction(left_side.radius) + Fraction(right_side.radius)


def test_false_identity_true_at_every_small_integer_is_refuted() -> None:
    product = x
    for n in range(1, 8):
        product = product * (x - n)
    outcome = judged("=", product, number(0), POSITIVE)
    assert outcome.verdict == "refuted"
    assert outcome.domain == "for x = 1 or x = 2 or x = 3 or x = 4 or x = 5 or x = 6 or x = 7"


def test_division_by_zero_is_found_even_when_multiplied_by_zero() -> None:
    assert judged("=", x + 0 * (1 / (x - x)), x, STATED).verdict == "refuted"
    assert judged("=", x / x, number(1), STATED).domain == "for x < 0 or x > 0"
    assert judged("=", x / x, number(1), STATED).verdict == "conditional"
    assert judged("=", x / x, number(1), REAL).verdict == "proved"


def test_formula_without_value_is_never_proved() -> None:
    with pytest.raises(Undecided, match="no value"):
        judged("=", sqrt(-1 - power(x, 2)), sqrt(-1 - power(x, 2)))
    with pytest.raises(Undecided, match="isolated points"):
        judged("=", sqrt(-power(x, 2)), number(0))
    bad = sqrt(-1 - power(x, 2))
    assert judged("=", bad, bad, STATED).verdict == "refuted"


def test_root_of_exact_zero_is_zero() -> None:
    assert judged("=", sqrt(x - x), number(0)).verdict == "proved"
    hidden = sqrt(5 + 2 * sqrt(number(6))) - sqrt(number(2)) - sqrt(number(3))
    assert judged("=", sqrt(hidden) + x, x).verdict == "proved"
    assert judged("=", x / hidden, x / hidden, STATED).verdict == "refuted"


def test_strict_inequality_that_touches_is_conditional() -> None:
    outcome = judged("<", 2 * x, power(x, 2) + 1, POSITIVE)
    assert outcome.verdict == "conditional"
    assert outcome.witness is not None
    assert outcome.witness.exact
    assert outcome.witness.point == {"x": "1"}
    assert judged("<=", 2 * x, power(x, 2) + 1, POSITIVE).verdict == "proved"


def test_faces_of_the_box_belong_to_the_domain_as_stated() -> None:
    closed = Box(lower=Fraction(0), lower_open=False)
    assert judged(">", x, number(0), POSITIVE).verdict == "proved"
    assert judged(">", x, number(0), closed).verdict == "conditional"
    thin = Box(lower=Fraction(1), upper=Fraction(10**9 + 1, 10**9))
    assert (
        judged(">", (x - 1) * (number(Fraction(10**9 + 1, 10**9)) - x), number(0), thin).verdict
        == "proved"
    )


def test_violation_in_a_narrow_interval_is_found() -> None:
    centre, width = number(Fraction(123457, 1000)), number(Fraction(1, 10**15))
    outcome = judged(">", power(x - centre, 2), power(width, 2), POSITIVE)
    assert outcome.verdict == "conditional"
    assert outcome.witness is not None


def test_irrational_end_points_are_exact() -> None:
    outcome = judged("<", power(x, 2), number(2), POSITIVE)
    assert outcome.domain == "for 0 < x < sqrt(2)"
    assert judged("<=", power(x, 2), number(2), POSITIVE).domain == "for 0 < x <= sqrt(2)"


def test_integers_only_count_where_the_variable_is_one() -> None:
    whole = Box(lower=Fraction(0), lower_open=False, integer=True)
    between = (x - 1) * (x - 2)
    assert judged(">=", between, number(0), whole).verdict == "proved"
    assert judged(">=", between, number(0), POSITIVE).verdict == "conditional"
    wrong = judged(">", (2 * x - 7) * (2 * x - 9), number(0), whole)
    assert wrong.witness is not None
    assert wrong.witness.point == {"x": "4"}


def test_free_symbols_hold_for_all_values() -> None:
    assert judged("=", x * y, y * x, POSITIVE).verdict == "proved"
    assert judged("=", sqrt(x * y), sqrt(x) * sqrt(y), POSITIVE, y=POSITIVE).verdict == "proved"
    assert judged("=", x * y, y + x, POSITIVE).verdict == "refuted"
    assert judged(">", x * y, number(0), POSITIVE, y=POSITIVE).verdict == "proved"
    with pytest.raises(Undecided, match="depends on"):
        judged(">", x - y, number(0), POSITIVE, y=POSITIVE)


def test_divisor_of_free_symbols_is_named_in_the_domain() -> None:
    outcome = judged("=", (x - y) / (x - y), number(1))
    assert outcome.verdict == "proved"
    assert "is not zero" in outcome.domain
    with pytest.raises(Undecided, match="a divisor may vanish"):
        judged("=", (x - y) / (x - y), number(1), POSITIVE)
    with pytest.raises(Undecided, match="a divisor may vanish"):
        judged("=", (x - y) / (x - y), number(1), POSITIVE, y=POSITIVE)


def test_limits_stop_the_work_with_a_reason() -> None:
    many = x
    for n in range(1, 12):
        many = many + sqrt(x + n)
    with pytest.raises(Undecided, match="degree more than 512"):
        judged("=", many, many + 1, POSITIVE)
    with pytest.raises(Undecided, match="root of order 5"):
        judged("=", power(x, Fraction(1, 5)), x, POSITIVE)
    with pytest.raises(Undecided, match="terms"):
        decide(
            Statement((Rel("=", power(x + y + 1, 8), number(0)),)),
            {"x": REAL, "y": REAL},
            "x",
            limits=Limits(terms=10),
        )
    with pytest.raises(Undecided, match="empty"):
        judged("=", x, x, Box(lower=Fraction(2), upper=Fraction(1)))
