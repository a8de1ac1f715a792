"""Every step of every derivation, altered in turn: it fails, and only it."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import Any

import pytest

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.certificate import check, check_statement

UNDECIDABLE = {"definition", "cited"}


@cache
def _certificate(name: str) -> dict[str, Any]:
    (entry,) = (entry for entry in CATALOGUE if entry.name == name)
    plain: dict[str, Any] = json.loads(json.dumps(entry.build().certificate()))
    return plain


def _graphs(claim: Any) -> Iterator[dict[str, Any]]:
    if isinstance(claim, dict):
        if "nodes" in claim:
            yield claim
        for value in claim.values():
            yield from _graphs(value)


def _altered(statement: dict[str, Any]) -> dict[str, Any]:
    """The statement with its claim made false: what is claimed is changed on one side."""
    changed = copy.deepcopy(statement)
    claim = changed["claim"]
    match changed["kind"]:
        case "equal":
            _shift(claim["right"])
        case "positive":
            _negate(claim["expression"])
        case "same_sign":
            _negate(claim["left"])
        case "limit":
            _shift_value(claim, "value")
        case "increasing_onto":
            _shift_value(claim, "from")
        case "monotone":
            trends = {"increasing": "decreasing", "decreasing": "increasing"}
            claim["trend"] = trends[claim["trend"]]
        case "riccati" | "stable":
            transition = claim["model"]["transition"]
            transition[0][1] = str(Fraction(transition[0][1]) + 3)
        case "positive_definite":
            claim["matrix"][0][0] = claim["matrix"][0][-1]
            if len(claim["matrix"]) == 1:
                claim["matrix"][0].append(claim["matrix"][0][0])
        case "program":
            _shift(next(iter(claim["outputs"].values())))
        case "sum":
            _shift(claim["closed"])
        case other:
            raise AssertionError(other)
    return changed


def _shift(graph: dict[str, Any]) -> None:
    """Add 1 to the value, or to the first entry of a matrix."""
    nodes, end = graph["nodes"], graph["outputs"]["value"]
    nodes.append(["number", "1"])
    one = len(nodes) - 1
    rows, columns = _shape(nodes, end)
    if rows:
        nodes.append(["matrix", rows, columns, *([one] * (rows * columns))])
        one += 1
    nodes.append(["add", end, one])
    graph["outputs"]["value"] = len(nodes) - 1


def _shape(nodes: list[Any], end: int) -> tuple[int, int]:
    operation, *operands = nodes[end]
    if operation == "matrix":
        return operands[0], operands[1]
    if operation == "add":
        return _shape(nodes, operands[0])
    if operation == "mul":
        rows, columns = _shape(nodes, operands[0])[0], _shape(nodes, operands[-1])[1]
        return rows, columns
    return 0, 0


def _negate(graph: dict[str, Any]) -> None:
    graph["nodes"].append(["neg", graph["outputs"]["value"]])
    graph["outputs"]["value"] = len(graph["nodes"]) - 1


def _shift_value(claim: dict[str, Any], field: str) -> None:
    if claim[field] == "infinity":
        claim[field] = {"nodes": [["number", "7"]], "outputs": {"value": 0}}
    else:
        _shift(claim[field])


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_every_step_is_proved(name: str) -> None:
    report = check(_certificate(name))
    assert report.accepted, report.reason
    assert {result.status for result in report.statements} <= {"proved", "cited", "definition"}
    assert sum(result.status == "proved" for result in report.statements) >= 12


@pytest.mark.slow
@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_an_altered_step_fails_and_only_it(name: str) -> None:
    """Every altered step fails; of a long derivation only some are checked with all the others."""
    certificate = _certificate(name)
    count = len(certificate["statements"])
    # a certificate of two parameters takes seconds to check whole
    stride = 1 + count // (15 if count < 100 else 3)
    original = {result.id: result.status for result in check(certificate).statements}
    for number, statement in enumerate(certificate["statements"]):
        if statement["kind"] in UNDECIDABLE:
            continue
        statements = list(certificate["statements"])
        statements[number] = _altered(statement)
        altered = {**certificate, "statements": statements}
        if number % stride:
            alone = check_statement(altered, statement["id"])
            assert alone.status == "rejected", statement["id"]
            continue
        after = {result.id: result.status for result in check(altered).statements}
        assert after == {**original, statement["id"]: "rejected"}, statement["id"]


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_altered_words_and_citations_are_noticed(name: str) -> None:
    (entry,) = (entry for entry in CATALOGUE if entry.name == name)
    claims = json.loads(json.dumps(entry.build().claims()))
    certificate = copy.deepcopy(_certificate(name))
    (model,) = (s for s in certificate["statements"] if s["id"] == "model")
    model["claim"]["text"] += " "
    assert not check(certificate, claims=claims).accepted
