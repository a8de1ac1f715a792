"""program: seen failing."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, refused, statement
from tests.verify.certificate.toy_writer import fraction, graph

from gainproof.verify.certificate.alteration_campaign import Campaign
from gainproof.verify.certificate.alterations import Alteration

Data = dict[str, Any]

p, s, g = sp.symbols("p s g")
P = [p, s]


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.roots.1", fraction(-p, 1, P), "nonnegative"),
        ("evidence.roots.1", fraction(2 * p, 1, P), "not a root"),
        ("evidence.roots.8", fraction(s, 1, P), "not a root"),
        ("evidence.roots.8", fraction(0, 1, P), "not a root"),
        ("evidence.roots", {}, "no root"),
        ("evidence.branches", {"1": "then"}, "no branches"),
        ("evidence.branches", {"99": "then"}, "no branches"),
        ("evidence.gaps", {"1": fraction(p, 1, P)}, "not used"),
        ("claim.program", "nothing", "not in the certificate"),
        ("claim.outputs.alpha", graph(sp.Symbol("beta")), "does not equal"),
        ("claim.outputs", {}, "no output"),
        ("claim.outputs", {"gamma": graph(1)}, "no output 'gamma'"),
        ("claim.outputs.alpha", graph(sp.Matrix([[p, p]])), "matrix"),
    ],
)
def test_kernel(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "kernel", path, new)


def test_roots_of_nodes_that_are_none(acceleration: Data) -> None:
    roots = statement(acceleration, "kernel")["evidence"]["roots"]
    for key, why in (
        ("7", "not used"),
        ("01", "not a node number"),
        ("-1", "not a node number"),
        ("1 ", "not a node number"),
        ("9" * 5, "not used"),
    ):
        assert why in changed(
            acceleration, "kernel", "evidence.roots", {**roots, key: fraction(p, 1, P)}
        )


@pytest.mark.parametrize("node", range(17))
def test_every_node_of_a_kernel_counts(acceleration: Data, node: int) -> None:
    nodes = acceleration["programs"]["gains"]["graph"]["nodes"]
    kind = nodes[node][0]
    other: Any = {
        "symbol": ["symbol", "beta"],
        "number": ["number", "3"],
        "pow": ["pow", 0, "1/3"],
        "div": ["mul", *nodes[node][1:]],
        "mul": ["add", *nodes[node][1:]],
        "add": ["mul", *nodes[node][1:]],
    }[kind]
    nodes[node] = other
    assert refused(acceleration)


def test_inputs(acceleration: Data) -> None:
    inputs = acceleration["programs"]["gains"]["inputs"]
    inputs["tracking_index"] = "sigma"
    assert "not a root" in reason(acceleration, "kernel")
    inputs["tracking_index"] = graph(p**2)
    assert reason(acceleration, "kernel") == ""
    inputs["tracking_index"] = graph(p**2 + 1)
    assert "not a root" in reason(acceleration, "kernel")
    inputs["tracking_index"] = "nothing"
    assert "neither" in reason(acceleration, "kernel")
    inputs["alpha"] = "alpha"
    assert "not used" in reason(acceleration, "kernel")
    del inputs["tracking_index"]
    assert reason(acceleration, "kernel")


def test_kernel_cannot_see_the_tower(acceleration: Data) -> None:
    """A symbol of the graph is an input, even when the tower has that name too."""
    program = acceleration["programs"]["gains"]
    program["graph"] = {
        "nodes": [["symbol", "alpha"], ["symbol", "beta"]],
        "outputs": {"alpha": 0, "beta": 1},
    }
    program["inputs"] = {"alpha": "beta", "beta": "alpha"}
    statement(acceleration, "kernel")["evidence"]["roots"] = {}
    assert "does not equal" in reason(acceleration, "kernel")


def test_kernel_does_not_differentiate(acceleration: Data) -> None:
    nodes = acceleration["programs"]["gains"]["graph"]["nodes"]
    nodes[16] = ["derivative", 15, "p"]
    assert "differentiate" in refused(acceleration)


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.branches.5", "then", "positive"),
        ("evidence.branches.5", "positive", "one of"),
        ("evidence.branches.6", "negative", "gap"),
        ("evidence.branches.6", "else", "one of"),
        ("evidence.branches.6", 1, "one of"),
        ("evidence.branches", {"6": "positive"}, "no branch"),
        ("evidence.gaps.5", fraction(g, 1, [g]), "gap"),
        ("evidence.gaps.5", fraction(-(g**2), 1, [g]), "nonnegative"),
        ("evidence.gaps.6", fraction(2 * g**2, 1, [g]), "gap"),
        ("evidence.gaps", {}, "no branch or no gap"),
        ("evidence.roots.3", fraction(-g, 1, [g]), "nonnegative"),
        ("claim.outputs.low", graph(-1), "does not equal"),
        ("claim.outputs.high", graph(-(g**2)), "does not equal"),
    ],
)
def test_branches(memory: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(memory, "root", path, new)


def test_strict_branch_wants_a_strict_gap(memory: Data) -> None:
    """select(1, u, ...): 1 < u fails at g = 0, so the gap g^2 does not do."""
    memory["programs"]["root"]["graph"]["nodes"][5] = ["call", "select", 4, 0, 3, 1]
    statement(memory, "root")["evidence"]["branches"]["5"] = "then"
    assert "not manifestly positive" in reason(memory, "root")


def test_branch_not_taken_is_not_evaluated(memory: Data) -> None:
    """The other branch may hold a root of something negative; no evidence is wanted for it."""
    nodes = memory["programs"]["root"]["graph"]["nodes"]
    nodes[1:1] = [["number", "-2"], ["pow", 1, "1/2"]]
    for node in nodes[3:]:
        for place in range(1, len(node)):
            if isinstance(node[place], int) and node[place]:
                node[place] += 2
    nodes[7][4] = 2
    memory["programs"]["root"]["graph"]["outputs"] = {"low": 7, "high": 8}
    evidence = statement(memory, "root")["evidence"]
    for field in ("roots", "branches", "gaps"):
        evidence[field] = {str(int(key) + 2): value for key, value in evidence[field].items()}
    assert reason(memory, "root") == ""
    evidence["roots"]["2"] = fraction(g, 1, [g])
    assert "not used" in reason(memory, "root")


def test_calls_belong_in_programs(memory: Data) -> None:
    claim = {"nodes": [["symbol", "g"], ["call", "abs", 0]], "outputs": {"value": 1}}
    assert "only in programs" in changed(memory, "root", "claim.outputs.low", claim)


def with_nodes(data: Data, nodes: Any) -> Data:
    statement(data, "kernel")["claim"]["nodes"] = nodes
    return data


def test_claimed_values_take_the_place_of_nodes_that_equal_them(acceleration: Data) -> None:
    """Node 3 is 4/p, node 9 is s, the outputs are alpha and beta."""
    alpha, beta = sp.symbols("alpha beta")
    nodes = {"3": graph(4 / p), "9": graph(s), "14": graph(alpha), "16": graph(beta)}
    assert reason(with_nodes(acceleration, nodes), "kernel") == ""
    assert not refused(acceleration)


@pytest.mark.parametrize(
    ("nodes", "why"),
    [
        ({"3": graph(4 / p + 1)}, "node 3: the value claimed is not the value of the node"),
        ({"9": graph(2 * s)}, "node 9: the value claimed is not the value of the node"),
        ({"9": graph(sp.Symbol("alpha"))}, "node 9: the value claimed is not the value"),
        ({"14": graph(sp.Symbol("beta"))}, "node 14: the value claimed is not the value"),
        ({"9": graph(sp.Matrix([[s, s]]))}, "matrix"),
        ({"9": graph(1 / (s - p))}, "not shown to be nonzero"),
        ({"9": graph(sp.Symbol("nothing"))}, "neither a variable nor an element"),
        ({"17": graph(s)}, "not used"),
        ({"09": graph(s)}, "not a node number"),
        ({"9": "s"}, "record"),
        ({}, "left out"),
        ([], ""),
        (None, ""),
    ],
)
def test_false_nodes(acceleration: Data, nodes: Any, why: str) -> None:
    found = reason(with_nodes(acceleration, nodes), "kernel")
    assert found
    assert why in found


def test_a_claimed_node_that_no_claimed_output_needs(acceleration: Data) -> None:
    """Node 16 leads to beta alone."""
    claim = statement(acceleration, "kernel")["claim"]
    del claim["outputs"]["beta"]
    nodes = {"16": graph(sp.Symbol("beta"))}
    assert "not used" in reason(with_nodes(acceleration, nodes), "kernel")


def test_a_false_node_does_not_hide_a_false_graph(acceleration: Data) -> None:
    """The kernel computes something else, and the nodes claimed say that it does not."""
    acceleration["programs"]["gains"]["graph"]["nodes"][15] = ["mul", 4, 3]
    nodes = {"15": graph(2 * p), "16": graph(sp.Symbol("beta"))}
    for given in ({"15": nodes["15"]}, {"16": nodes["16"]}, nodes):
        assert "not the value of the node" in reason(with_nodes(acceleration, given), "kernel")


def test_a_claimed_node_left_out_is_another_claim(acceleration: Data) -> None:
    """What a kernel computes on its way is part of what is expected of its certificate."""
    campaign = Campaign(with_nodes(acceleration, {"9": graph(s), "3": graph(4 / p)}))
    number = [entry["id"] for entry in acceleration["statements"]].index("kernel")
    at = ("statements", number, "claim", "nodes")
    assert campaign.outcome(Alteration((*at, "9"), "deleted", None)) == "unexpected"
    assert campaign.outcome(Alteration(at, "deleted", None)) == "unexpected"
    changed_ = Alteration((*at, "3", "nodes", 1), "altered", ["number", "3"])
    assert campaign.outcome(changed_) in ("refuted", "malformed")
