"""Every relation written by derivations, judged by the judge's own solutions, kernels included."""

from __future__ import annotations

from typing import Any

import pytest
from catalogue_subjects import subject

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.derivations.fixed_point import ROOTED
from gainproof.verify.judge.derivations.relation import judge_relation, judge_statement
from gainproof.verify.judge.derivations.surroundings import surroundings

DEGREES = {"least-squares-mean": 0, "least-squares-line": 1, "least-squares-parabola": 2}


def symbol_graph(*names: str, kind: str = "add") -> dict[str, Any]:
    nodes: list[list[Any]] = [["symbol", name] for name in names]
    if len(names) > 1:
        nodes.append([kind, *range(len(names))])
    return {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}


# the judge reads relations over one index; those over several parameters have the checker alone
SEVERAL = ("position-velocity", "recursion")
OF_ONE_INDEX = [entry for entry in CATALOGUE if not entry.name.startswith(SEVERAL)]


@pytest.mark.slow
@pytest.mark.parametrize("entry", OF_ONE_INDEX, ids=lambda entry: str(entry.name))
def test_every_statement_is_proved(entry: Any) -> None:
    certificate = subject(entry.name).certificate()
    degree = DEGREES.get(entry.name)
    model = subject(entry.name).model_data if degree is None else None
    around = {n: surroundings(model, degree, t) for n, t in certificate["towers"].items()}
    for statement in certificate["statements"]:
        kind = statement["kind"]
        finding = judge_statement(
            kind,
            statement["claim"],
            programs=certificate["programs"],
            around=around[statement["tower"]],
        )
        expected = {"definition": "definition", "cited": "remark"}.get(kind, "proved")
        if kind == "program" and finding.reason == ROOTED:
            assert entry.name in ("random-jerk", "continuous-white-jerk")
            continue  # the checker alone
        assert finding.verdict == expected, f"{statement['id']}: {finding.reason}"


def test_relation_of_another_family_is_refuted() -> None:
    other = subject("random-acceleration").model_data
    assert other is not None
    left = {
        "nodes": [["symbol", "alpha"], ["symbol", "beta"], ["add", 0, 1], ["mul", 0, 2]],
        "outputs": {"value": 3},
    }
    right = {"nodes": [["number", "2"], ["symbol", "beta"], ["mul", 0, 1]], "outputs": {"value": 2}}
    finding = judge_relation(left, right, other)
    assert finding.verdict == "refuted"
    assert finding.witness is not None
    assert finding.witness.point == {"tracking_index": "1"}


def test_unknown_symbols_and_malformed_data_are_undecided() -> None:
    finding = judge_relation(symbol_graph("alpha"), symbol_graph("omega"), degree=0)
    assert finding.verdict == "undecided"
    assert "omega" in finding.reason
    bad: dict[str, Any] = {"nodes": [["number", "0.5"]], "outputs": {"value": 0}}
    assert judge_relation(symbol_graph("alpha"), bad, degree=0).verdict == "undecided"
    assert judge_statement("no such kind", {}, degree=0).verdict == "undecided"


def test_free_symbols_of_a_relation() -> None:
    left, right = symbol_graph("z", "alpha"), symbol_graph("alpha", "z")
    assert judge_relation(left, right, degree=1, free=["z"]).verdict == "proved"
    product = symbol_graph("alpha", "z", kind="mul")
    assert judge_relation(left, product, degree=1, free=["z"]).verdict == "refuted"
