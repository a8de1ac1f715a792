"""Claims of several parts: that one of them holds on a part of the domain says nothing of the claim
before all others are known.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

from gainproof.verify.judge.exact.expression import number, symbol
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.kinds import equivalence
from gainproof.verify.judge.verdict import Finding, of_parts

SOME, OTHER = (Finding("conditional", "x", domain) for domain in ("x > 0", "x > 1"))
TRUE, FALSE, HELD = (Finding(verdict, "x") for verdict in ("proved", "refuted", "held"))


def test_what_stands_against_all_parts() -> None:
    assert of_parts([TRUE, TRUE]) is None
    assert of_parts([]) is None
    assert of_parts([SOME, FALSE]) == of_parts([HELD, FALSE]) == FALSE
    assert of_parts([TRUE, SOME, TRUE]) == of_parts([SOME, SOME]) == SOME
    assert of_parts([SOME, HELD]) == of_parts([HELD, SOME]) == HELD
    with pytest.raises(Undecided, match="different places"):
        of_parts([SOME, OTHER])


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\tan\theta + 2 x = \tan\theta + x + O(x^2)", r"-\pi < \theta \leq \pi"),
        (r"\ln(y) + 2 x = \ln(y) + x + O(x^2)", "y > -1"),
        (r"\sqrt{y} + \sin x = \sqrt{y} + 2 x + O(x^2)", r"y \geq -1"),
    ],
)
def test_a_later_term_refutes_where_an_earlier_one_lacks_a_value(latex: str, domain: str) -> None:
    claim = f"latex = '{latex} \\quad (x \\to 0)'\ndomain = '{domain}'"
    check(judged("asymptotics", claim), "refuted")


@pytest.mark.parametrize(
    "latex",
    [
        r"e^x > 2 y \Leftrightarrow x > \ln y",
        r"x > y \Leftrightarrow \ln x \geq \ln y",
        r"x > y + 1 \Leftrightarrow \ln x > \ln y",
    ],
)
def test_the_other_direction_refutes(latex: str) -> None:
    check(judged("equivalence", latex), "refuted")
    left, right = latex.split(r"\Leftrightarrow")
    check(judged("equivalence", rf"{right} \Leftrightarrow {left}"), "refuted")


def test_a_direction_that_is_not_known_is_not_passed_over() -> None:
    equal, values = "x = y", r"e^x + \arctan x = e^y + \arctan y"
    check(judged("implication", rf"{equal} \Rightarrow {values}"), "proved")
    for latex in (rf"{equal} \Leftrightarrow {values}", rf"{values} \Leftrightarrow {equal}"):
        assert judged("equivalence", latex).verdict in ("held", "undecided")


def test_two_logarithms_are_compared_where_both_have_a_value() -> None:
    found = judged("equivalence", r"x > 2 \Leftrightarrow \ln(x - y) > \ln(2 - y)")
    check(found, "conditional")
    assert found.domain == "for y < 2, x > 2, where every part has a value"


@pytest.mark.parametrize(
    ("latex", "told"),
    [
        (
            r"\frac{1}{e^x - 2} > 0 \Leftrightarrow e^x > 2",
            "the left side of the equivalence has no value",
        ),
        (
            r"e^x > 2 \Leftrightarrow \frac{1}{e^x - 2} > 0",
            "the right side of the equivalence has no value",
        ),
        (
            r"\frac{e^x - 2}{e^x - 2} = 1 \Leftrightarrow e^x > 1",
            "the left side of the equivalence has no value, the right holds",
        ),
        (
            r"e^x > 1 \Leftrightarrow \frac{e^x - 2}{e^x - 2} = 1",
            "the left side of the equivalence holds, the right has no value",
        ),
        (r"\frac{1}{e^x - 2} > 5 \Rightarrow e^x > 2", "what is supposed has no value"),
    ],
)
def test_which_side_has_no_value_is_told(latex: str, told: str) -> None:
    """At x = ln 2, by hand; what is said of the sides is said once."""
    kind = "equivalence" if "Leftrightarrow" in latex else "implication"
    stated = "{ unit = '1', domain = '0 < x < 3', meaning = 'a number' }"
    found = judged(kind, latex, {"x": stated})
    check(found, "conditional")
    assert found.witness is not None
    assert found.witness["note"] == told
    assert found.reason.count(told) == 1
    assert "compared" not in found.reason


@pytest.mark.parametrize(
    ("subject", "trend", "domain"),
    [
        (r"x \ln x", "increasing", r"x \geq 0"),
        (r"x \ln x", "decreasing", "x > -1"),
        (r"\frac{\ln x}{x}", "decreasing", "x > -1"),
        (r"\ln(1 + x)", "decreasing", "x > -2"),
        (r"\frac{1}{e^x - 1}", "increasing", r"x \geq 0"),
    ],
)
def test_a_trend_that_is_wrong_where_there_are_values(
    subject: str, trend: str, domain: str
) -> None:
    fields = f"about = ['{subject}', 'x']\ntrend = '{trend}'\ntext = 'x'\ndomain = '{domain}'"
    check(judged("monotone", fields), "refuted")


def test_a_trend_of_what_holds_somewhere_is_not_told() -> None:
    fields = "about = ['-x', 'x']\ntrend = 'increasing'\nlatex = 'e^{\\ln x} = x'"
    found = judged("monotone", fields + "\ndomain = 'x \\geq 0'")
    assert found.verdict in ("refuted", "undecided")


class Frame:
    """Says of both directions what it is told to say."""

    conditions = ()

    def __init__(self, *told: str) -> None:
        self.told = list(told)

    def decide_alone(self, _: Statement) -> Outcome:
        raise Undecided("both at once")

    def decide(self, _: Statement) -> Outcome:
        verdict = self.told.pop(0)
        if verdict == "undecided":
            raise Undecided("an open direction")
        return Outcome(verdict, "x > 0", "", "")


@pytest.mark.parametrize("known", ["proved", "conditional", "held"])
@pytest.mark.parametrize("order", [1, -1])
def test_an_undecided_direction(known: str, order: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(equivalence, "strictly", lambda frame: frame)
    rels = [(Rel(">", symbol(name), number(0)),) for name in ("x", "y")]
    both = Statement(rels[0], rels[1], "iff")
    with pytest.raises(Undecided, match="an open direction"):
        equivalence.decide_equivalence(both, Frame(*[known, "undecided"][::order]))  # type: ignore[arg-type]
    refuted = Frame(*["refuted", "undecided"][::order])
    assert equivalence.decide_equivalence(both, refuted).verdict == "refuted"  # type: ignore[arg-type]
