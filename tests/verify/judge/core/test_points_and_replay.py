"""Beyond the methods points refute or hold, never prove. Certificates are replayed."""

from __future__ import annotations

import copy
import json
from fractions import Fraction
from typing import Any

import pytest
from lecture_judged import lecture_claims

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import power, sqrt, symbol
from gainproof.verify.judge.exact.rational_points import failure_where
from gainproof.verify.judge.exact.statement import Enclosure, Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.replay import replay, replay_json

x, y = symbol("x"), symbol("y")
POSITIVE = Box(lower=Fraction(0))
BOTH = {"x": POSITIVE, "y": POSITIVE}


def test_roots_it_does_not_cover_are_held_or_refuted() -> None:
    fifth = power(x, Fraction(1, 5))
    true = settle(Statement((Rel("=", fifth**5, x),)), {"x": POSITIVE}, "x", {})
    assert true.verdict == "held"
    assert "no proof" in true.reason
    assert "order 5" in true.reason
    false = settle(Statement((Rel("=", fifth**4, x),)), {"x": POSITIVE}, "x", {})
    assert false.verdict == "refuted"
    assert false.witness is not None
    assert false.witness.point == {"x": "2"}


def test_several_parameters_under_a_root() -> None:
    true = Rel("=", sqrt(power(x, 2) + 2 * x * y + power(y, 2)), x + y)
    assert settle(Statement((true,)), BOTH, None, {}).verdict == "proved"
    false = Rel("=", sqrt(power(x, 2) + power(y, 2)), x + y)
    assert settle(Statement((false,)), BOTH, None, {}).verdict == "refuted"
    mean = Rel(">=", (x + y) / 2, sqrt(x * y))
    assert settle(Statement((mean,)), BOTH, None, {}).verdict == "proved"
    assert settle(Statement((Rel(">", x, y),)), BOTH, None, {}).verdict == "conditional"


def test_a_proof_over_cells_is_replayed_and_an_altered_one_is_not() -> None:
    strict = Statement((Rel(">", (x + y) / 2, sqrt(x * y)),))
    outcome = settle(strict, BOTH, None, {})
    certificate: dict[str, Any] = json.loads(json.dumps(outcome.certificate))
    assert certificate["engine"] == "cells"
    assert replay(certificate, "conditional") is None
    assert replay(certificate, "proved") is not None
    for field in ("tower", "candidates", "projection", "places", "borders"):
        altered = copy.deepcopy(certificate)
        altered[field] = altered[field][:-1]
        assert replay(altered, "conditional") is not None
    altered = copy.deepcopy(certificate)
    altered["statement"]["domain"]["x"]["lower"] = "3"
    assert replay(altered, "conditional") is not None


def test_conditions_are_respected_at_points() -> None:
    statement = Statement((Rel(">", 3 * x, y),), (Rel(">", 2 * x, y),))
    assert settle(statement, BOTH, None, {}).verdict in ("held", "proved")
    nowhere = Statement((Rel(">", x, y),), (Rel(">", x, 1000 * y), Rel("<", x, y)))
    with pytest.raises(Undecided):
        settle(nowhere, BOTH, None, {})


def test_another_statement_fails_at_a_point_of_the_own_domain_only() -> None:
    statement = Statement((Rel("<", x, y),))
    side = Enclosure("0", "0")
    outcomes = [
        failure_where(Witness(point, "<", side, side), statement, BOTH, {"x": "X"})
        for point in (
            {"X": "3", "y": "2"},
            {"X": "2", "y": "3"},
            {"X": "3", "y": "-2"},
            {"X": "sqrt(2)", "y": "1"},
            {"X": "3"},
        )
    ]
    assert [found and found.verdict for found in outcomes] == ["refuted", None, None, None, None]


def test_a_certificate_is_replayed_and_an_altered_one_is_not() -> None:
    left, right = sqrt(power(x, 2) - 6 * x + 9), x - 3
    outcome = decide(Statement((Rel("=", left, right),)), {"x": POSITIVE}, "x")
    certificate: dict[str, Any] = json.loads(json.dumps(outcome.certificate))
    assert replay(certificate, "conditional") is None
    assert replay(certificate, "proved") is not None
    for field in ("tower", "candidates", "places"):
        altered = copy.deepcopy(certificate)
        altered[field] = altered[field][:-1]
        assert replay(altered, "conditional") is not None
    altered = copy.deepcopy(certificate)
    altered["statement"]["domain"]["x"]["lower"] = "3"
    assert replay(altered, "conditional") is not None
    del altered["statement"]["relations"]
    assert "cannot be replayed" in str(replay(altered, "conditional"))


POSITIVE_SUM = Statement((Rel(">", x + y, x),))
SOMETIMES = Statement((Rel(">", x, y),))
NEVER = Statement((Rel("<", x + y, x),))


@pytest.mark.parametrize("names", [("there", "back"), ("elsewhere", "at x = 0", "at y = 0")])
@pytest.mark.parametrize(
    ("statement", "comes_to"),
    [(POSITIVE_SUM, "proved"), (SOMETIMES, "conditional"), (NEVER, "refuted")],
)
def test_parts_come_to_one_verdict_and_to_no_other(
    names: tuple[str, ...], statement: Statement, comes_to: str
) -> None:
    """x + y > x for y > 0, x > y for some, x + y < x for none, by hand."""
    proof = dict(settle(POSITIVE_SUM, BOTH, None, {}).certificate)
    last = {**settle(statement, BOTH, None, {}).certificate, "decides": comes_to}
    parts = {**dict.fromkeys(names, proof), names[-1]: last}
    for verdict in ("proved", "conditional", "refuted"):
        assert (replay(parts, verdict) is None) == (verdict == comes_to)
        # told as another verdict, which a proof never is
        told = replay({**parts, "decides": comes_to}, verdict)
        assert (told is None) == (verdict == comes_to or verdict != "proved")


@pytest.mark.thorough
def test_verdicts_of_the_lecture_are_replayed() -> None:
    """By default `test_every_verdict_replayed` does this as `explain` does it."""
    claims = lecture_claims()
    replayed = [c for c in claims if (c["evidence"]["certificate"] or {}).get("statement")]
    assert len(replayed) > 20
    assert all(replay_json(c) is None for c in claims)
