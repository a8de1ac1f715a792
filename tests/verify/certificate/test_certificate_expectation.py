"""A certificate that is right about something else is rejected."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import statement
from tests.verify.certificate.toy_families import MODEL
from tests.verify.certificate.toy_writer import expectations, graph

from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign

Data = dict[str, Any]


def test_everything_expected(acceleration: Data) -> None:
    assert check(acceleration, model=MODEL, **expectations(acceleration)).accepted


def test_tuples_and_lists_are_the_same(acceleration: Data) -> None:
    claims = expectations(acceleration)["claims"]
    claims[-1] = {**claims[-1], "id": "unique"}
    assert check(acceleration, claims=tuple(claims)).accepted


def test_tower_is_main_unless_given(acceleration: Data, memory: Data) -> None:
    for certificate, accepted in ((acceleration, True), (memory, False)):
        claims = [
            {k: v for k, v in claim.items() if k != "tower"}
            for claim in expectations(certificate)["claims"]
        ]
        assert check(certificate, claims=claims).accepted == accepted


def test_another_familys_certificate(acceleration: Data, memory: Data) -> None:
    report = check(memory, **expectations(acceleration))
    assert "not as expected" in report.reason
    assert not check(acceleration, claims=expectations(memory)["claims"]).accepted
    other = {**MODEL, "process_noise": [["0", "0"], ["0", "1"]]}
    assert "model" in check(acceleration, model=other).reason
    assert "no statement speaks" in check(memory, model=MODEL).reason


def test_true_but_weaker(memory: Data) -> None:
    """k from 2 on leaves everything true, and is not what was expected."""
    expected = expectations(deepcopy(memory))
    memory["towers"]["samples"]["parameters"][0]["from"] = "2"
    assert check(memory).accepted
    assert "domain.samples[0].from" in check(memory, **expected).reason


def test_fewer_more_or_other_statements(acceleration: Data) -> None:
    expected = expectations(deepcopy(acceleration))
    fewer = {**acceleration, "statements": acceleration["statements"][1:]}
    assert "statements are expected" in check(fewer, **expected).reason
    turned = {**acceleration, "statements": acceleration["statements"][::-1]}
    assert "not as expected" in check(turned, **expected).reason
    statement(acceleration, "relation")["claim"]["right"] = graph(-8 * sp.Symbol("beta"))
    statement(acceleration, "relation")["claim"]["left"] = graph(-8 * sp.Symbol("beta"))
    assert check(acceleration).accepted
    report = check(acceleration, **expected)
    assert [r.id for r in report.statements if r.status == "rejected"] == ["relation"]


def test_another_program(acceleration: Data) -> None:
    expected = expectations(deepcopy(acceleration))
    nodes = acceleration["programs"]["gains"]["graph"]["nodes"]
    nodes[15] = ["mul", 1, 4]
    assert check(acceleration).accepted
    assert "programs.gains.graph" in check(acceleration, **expected).reason


def test_another_tower(memory: Data) -> None:
    expected = expectations(deepcopy(memory))
    memory["towers"]["again"] = deepcopy(memory["towers"]["branch"])
    statement(memory, "onto")["tower"] = "again"
    del expected["domain"]
    assert "statement.tower" in check(memory, **expected).reason


@pytest.mark.parametrize(
    "claims",
    [
        [{}],
        [3],
        3,
        [{"id": "a", "kind": "b", "claim": {}, "evidence": {}}],
        [{"id": 1.0}],
    ],
)
def test_malformed_expectations(acceleration: Data, claims: Any) -> None:
    report = check(acceleration, claims=claims)
    assert not report.accepted
    assert report.reason


def test_same_number_of_another_type(acceleration: Data) -> None:
    """1 and True compare equal in Python; not here."""
    expected = expectations(deepcopy(acceleration))
    expected["claims"][0]["claim"]["left"]["outputs"]["value"] = False
    assert not check(acceleration, **expected).accepted


def test_other_quantities_under_the_same_names() -> None:
    """A limit of p/(1 + p) is one of p/(2 + p) too: only the tower says of what it is told."""
    side: Data = {
        "parameters": [{"symbol": "p", "above": "0"}],
        "generators": [],
        "elements": {"share": {"num": [["1", [1]]], "den": [["1", [1]], ["1", [0]]]}},
    }
    claim = {
        "expression": graph(sp.Symbol("share")),
        "variable": "p",
        "point": "0",
        "value": graph(sp.Integer(0)),
    }
    evidence: Data = {"weights": {}, "constants": [], "boundary": {}, "nonzero": []}
    certificate: Data = {
        "format": "gainproof certificate 1",
        "subject": "a limit",
        "towers": {"side": side},
        "programs": {},
        "statements": [
            {"id": "end", "kind": "limit", "tower": "side", "claim": claim, "evidence": evidence}
        ],
    }
    expected = {**expectations(certificate), "towers": deepcopy(certificate["towers"])}
    assert check(certificate, **expected).accepted
    side["elements"]["share"]["den"][1][0] = "2"
    assert check(certificate).accepted
    assert "towers.side.elements.share" in check(certificate, **expected).reason
    assert not Campaign(certificate).run().accepted
