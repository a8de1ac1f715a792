"""Every step of every derivation, altered: it fails, and only it."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from catalogue_subjects import certificate, derived, report
from one_of_each import cases

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.certificate import check
from gainproof.verify.certificate.checker import decide
from gainproof.verify.certificate.document import read_document, read_statement
from gainproof.verify.certificate.expected_claims import Expectation
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import Meter

UNDECIDABLE = {"definition", "cited"}
ONE_OF_A_KIND = {
    "random-acceleration",
    "acceleration-increments",
    "least-squares-parabola",
    "position-velocity-random-acceleration",
    "recursion-two-states",
    "alpha-beta",
    "filter-step",
    "interacting-gains",
    "multipath-location",
}
"""A subject of each method. That every step of the others is proved too, `gainproof run` says."""
NAMES = cases([entry.name for entry in CATALOGUE], lambda name: name in ONE_OF_A_KIND)
PROVED_TOO = {"random-jerk"}
"""Whose tower has no like among these: a coupled pair of roots."""
ELSEWHERE = {"interacting-gains", "multipath-location"}
"""Whose own tests have all steps proved."""
PROVED = cases(
    [entry.name for entry in CATALOGUE], lambda n: n in (ONE_OF_A_KIND | PROVED_TOO) - ELSEWHERE
)


@cache
def _certificate(name: str) -> dict[str, Any]:
    plain_certificate: dict[str, Any] = _plain(certificate(name))
    return plain_certificate


def _plain(data: Any) -> Any:
    """As it comes out of a file."""
    return json.loads(json.dumps(data))


def _wanted(certificate: dict[str, Any]) -> dict[str, str]:
    """What becomes of each statement as it is; the first test below shows it."""
    return {
        entry["id"]: entry["kind"] if entry["kind"] in UNDECIDABLE else "proved"
        for entry in certificate["statements"]
    }


def _decidable(certificate: dict[str, Any]) -> list[int]:
    """The numbers of the statements in which there is something to prove."""
    statements = enumerate(certificate["statements"])
    return [number for number, entry in statements if entry["kind"] not in UNDECIDABLE]


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
        case "matrix_equal" | "matrix_trace":
            _double(claim["left"])
        case "matrix_order":
            claim["larger"], claim["smaller"] = claim["smaller"], claim["larger"]
        case "matrix_invertible":
            claim["given"] = []
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


def _double(graph: dict[str, Any]) -> None:
    end = graph["outputs"]["value"]
    graph["nodes"].append(["add", end, end])
    graph["outputs"]["value"] = len(graph["nodes"]) - 1


def _negate(graph: dict[str, Any]) -> None:
    graph["nodes"].append(["neg", graph["outputs"]["value"]])
    graph["outputs"]["value"] = len(graph["nodes"]) - 1


def _shift_value(claim: dict[str, Any], field: str) -> None:
    if claim[field] == "infinity":
        claim[field] = {"nodes": [["number", "7"]], "outputs": {"value": 0}}
    else:
        _shift(claim[field])


@pytest.mark.alike
@pytest.mark.parametrize("name", PROVED)
def test_every_step_is_proved(name: str) -> None:
    found = report(name)
    assert found["accepted"], found["reason"]
    statuses = {result["id"]: result["status"] for result in found["statements"]}
    assert statuses == _wanted(_certificate(name))
    assert list(statuses.values()).count("proved") >= 11


@pytest.mark.alike
@pytest.mark.parametrize("name", NAMES)
def test_every_altered_step_fails_alone(name: str) -> None:
    """Each on its own in the derivation as it was, whose towers and programs are read once."""
    certificate = _certificate(name)
    meter = Meter()
    document = read_document(plain(certificate), meter)
    for number in _decidable(certificate):
        altered = plain(_altered(certificate["statements"][number]))
        statement = read_statement(altered, document.towers, "statement")
        meter.reset()
        result = decide(document, number, statement, Expectation(None, None, None, None))
        assert result.status == "rejected", statement.id
        assert "given up" not in result.reason, statement.id
        if statement.kind == "matrix_order":  # not for its form: the squares do not make it up
            assert "terms are left over" in result.reason, statement.id


@pytest.mark.alike
@pytest.mark.parametrize("name", NAMES)
def test_altered_steps_fail_and_only_they(name: str) -> None:
    """Every second step altered: these fail, and of the others each is what it was."""
    certificate = _certificate(name)
    chosen = _decidable(certificate)[::2]
    statements = [
        _altered(statement) if number in chosen else statement
        for number, statement in enumerate(certificate["statements"])
    ]
    found = check({**certificate, "statements": statements})
    assert not found.accepted
    wanted = _wanted(certificate)
    wanted |= {certificate["statements"][number]["id"]: "rejected" for number in chosen}
    for entry in certificate["statements"]:  # a premise comes before what rests on it
        if any(wanted[premise] == "rejected" for premise in _premises(entry["evidence"])):
            wanted[entry["id"]] = "rejected"
    assert {result.id: result.status for result in found.statements} == wanted


def test_a_premise_is_a_reference_and_no_other_word() -> None:
    """What the test above expects to fall is told by this alone."""
    evidence = {
        "cofactors": [[["statement", "first"], ["inverse", "second", "left"], ["inverse", 3]]],
        "third": {"id": "fourth", "because": ["given", 0]},
    }
    assert sorted(_premises(evidence)) == ["first", "second"]


def _premises(evidence: Any) -> Iterator[str]:
    """The ids of the statements that the evidence refers to."""
    match evidence:
        case ["statement", str(name)] | ["inverse", str(name), "left" | "right"]:
            yield name
        case dict():
            for part in evidence.values():
                yield from _premises(part)
        case list():
            for part in evidence:
                yield from _premises(part)


@pytest.mark.parametrize("name", NAMES)
def test_altered_words_and_citations_are_noticed(name: str) -> None:
    """Nothing about them is decided: what tells is the comparison with what is expected. Every
    second one is altered, then the others: these are told and nothing else.
    """
    certificate = _certificate(name)
    words = [entry for entry in certificate["statements"] if entry["kind"] in UNDECIDABLE]
    kept = {entry["id"] for entry in words}
    claims = [claim for claim in _plain(derived(name).claims) if claim["id"] in kept]
    assert _told({**certificate, "statements": words}, claims) == []
    for chosen in (words[::2], words[1::2]):
        altered = copy.deepcopy(words)
        wanted = [entry["id"] for entry in chosen]
        for claim in (other["claim"] for other in altered if other["id"] in wanted):
            if "right" in claim:
                _shift(claim["right"])
            else:
                claim["text" if "text" in claim else "theorem"] += " "
        assert _told({**certificate, "statements": altered}, claims) == wanted


def _told(certificate: dict[str, Any], claims: list[Any]) -> list[str]:
    """Ids of the statements that are not as expected."""
    found = check(certificate, claims=claims)
    return [result.id for result in found.statements if "not as expected" in result.reason]
