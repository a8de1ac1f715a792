"""Relations written by derivations, judged by the judge's own solutions, kernels included.

Of most families every one; of those whose index holds roots a sample, the whole is a campaign.
"""

from __future__ import annotations

import copy
import json
from typing import Any

import judged_statements
import pytest
from catalogue_subjects import certificate, derived
from judged_derivations.relation import judge_relation, judge_statement
from judged_statements import DEGREES, OF_ONE_INDEX, SAMPLED, judged, sample
from one_of_each import cases

from gainproof.derive.catalogue import CATALOGUE
from gainproof.files import places


def symbol_graph(*names: str, kind: str = "add") -> dict[str, Any]:
    nodes: list[list[Any]] = [["symbol", name] for name in names]
    if len(names) > 1:
        nodes.append([kind, *range(len(names))])
    return {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}


TWO_STATES, THREE_STATES = "random-acceleration", "acceleration-increments"
WHOLE = cases(
    [entry.name for entry in OF_ONE_INDEX if entry.name not in SAMPLED],
    lambda name: name in {TWO_STATES, *DEGREES},
)


def test_families_of_one_index_are_those_whose_towers_have_one_parameter() -> None:
    """By the committed certificates, which are as derived."""
    found = []
    for entry in CATALOGUE:
        path = places.generated_folder() / f"{entry.name.replace('-', '_')}.json"
        towers = json.loads(path.read_text(encoding="utf-8"))["towers"].values()
        if all(len(tower.get("parameters", ())) == 1 for tower in towers):
            found.append(entry.name)
    assert found == [entry.name for entry in OF_ONE_INDEX]


@pytest.mark.parametrize("name", WHOLE)
def test_every_statement_is_proved(name: str) -> None:
    """All statements of these families; kernels over roots of roots have the checker alone."""
    assert [entry for entry in judged(name) if entry[1]] == []


@pytest.mark.parametrize("name", cases([THREE_STATES, *SAMPLED], lambda name: name == THREE_STATES))
def test_sampled_statements_are_proved(name: str) -> None:
    """Two statements of each kind, by seed; of kinds with two or less all.

    Left out are statements of which one takes seconds, the curvatures of the gains, and what the
    judge leaves undecided: the kernels, and of continuous white jerk the sign of the discriminant.
    The checker of certificates decides these. tests/campaigns/statements.py has all.
    """
    assert [entry for entry in judged(name, sample(name, seed=1)) if entry[1]] == []


def test_a_wrong_verdict_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """A statement with its left side on the right side as well, twice."""
    written = copy.deepcopy(certificate("acceleration-increments"))
    ids = [statement["id"] for statement in written["statements"]]
    number = ids.index("equation-eta")
    claim = written["statements"][number]["claim"]
    nodes, end = claim["left"]["nodes"], claim["left"]["outputs"]["value"]
    claim["right"] = {"nodes": [*nodes, ["add", end, end]], "outputs": {"value": len(nodes)}}
    monkeypatch.setattr(judged_statements, "certificate", lambda _name: written)
    ((name, wrong),) = judged("acceleration-increments", [number])
    assert name == "equation-eta"
    assert wrong.startswith("refuted")


def test_relation_of_another_family_is_refuted() -> None:
    other = derived("random-acceleration").model
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


@pytest.mark.parametrize(
    ("node", "meant", "verdict"),
    [("2", 7, "proved"), ("2", 8, "refuted"), ("9", 7, "undecided"), ("two", 7, "undecided")],
)
def test_claimed_nodes_of_a_kernel_are_judged(node: str, meant: int, verdict: str) -> None:
    """The kernel adds 3 and 4 on the way to a square."""
    nodes = [["number", "3"], ["number", "4"], ["add", 0, 1], ["mul", 2, 2]]

    def number(value: int) -> dict[str, Any]:
        return {"nodes": [["number", str(value)]], "outputs": {"value": 0}}

    claim = {
        "program": "kernel",
        "outputs": {"square": number(49)},
        "nodes": {node: number(meant)},
    }
    program = {"inputs": {}, "graph": {"nodes": nodes, "outputs": {"square": 3}}}
    found = judge_statement("program", claim, degree=0, programs={"kernel": program})
    assert found.verdict == verdict, found.reason
