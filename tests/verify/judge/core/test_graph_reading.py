"""Graphs are untrusted: whatever is no graph is refused by name, and nothing else comes out."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.work_limits import Limits, Malformed

VALUE = {"value": 0}


@pytest.mark.parametrize(
    "graph",
    [
        {},
        {"nodes": [], "outputs": {}},
        {"nodes": [["number", "1"]], "outputs": {"value": 1}},
        {"nodes": [["number", "1"]], "outputs": {"value": True}},
        {"nodes": [["number", 1]], "outputs": VALUE},
        {"nodes": [["number", "1.5"]], "outputs": VALUE},
        {"nodes": [["number", "1e9"]], "outputs": VALUE},
        {"nodes": [["number", "1/0"]], "outputs": VALUE},
        {"nodes": [["number", "--1"]], "outputs": VALUE},
        {"nodes": [["number", "1_0"]], "outputs": VALUE},
        {"nodes": [["number", "٣"]], "outputs": VALUE},
        {"nodes": [["number", "9" * 500]], "outputs": VALUE},
        {"nodes": [["symbol", ""]], "outputs": VALUE},
        {"nodes": [["neg", 0]], "outputs": VALUE},
        {"nodes": [["symbol", "x"], ["neg", 1]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["neg", -1]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["pow", 0, "1000"]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["pow", 0, "1/1000"]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["add", 0]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["eval", 0]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["matrix", 1, 2, 0]], "outputs": {"value": 1}},
        {"nodes": [["symbol", "x"], ["matrix", 1, 1, 0]], "outputs": {"value": 1}},
        {
            "nodes": [["symbol", "x"], ["matrix", 1, 2, 0, 0], ["mul", 1, 1]],
            "outputs": {"value": 2},
        },
        {"nodes": "abc", "outputs": VALUE},
        {"nodes": [[]], "outputs": VALUE},
    ],
)
def test_malformed(graph: Any) -> None:
    with pytest.raises(Malformed):
        read_graph(graph)


def test_limits() -> None:
    deep: list[list[Any]] = [["symbol", "x"]]
    deep += [["neg", n] for n in range(400)]
    with pytest.raises(Malformed, match="nesting"):
        read_graph({"nodes": deep, "outputs": {"value": 400}})
    with pytest.raises(Malformed, match="at most 3 nodes"):
        read_graph({"nodes": deep[:5], "outputs": {"value": 4}}, Limits(nodes=3))


def test_sharing_keeps_huge_trees_small() -> None:
    nodes: list[list[Any]] = [["symbol", "x"]]
    nodes += [["add", n, n] for n in range(100)]
    graph = {"nodes": nodes, "outputs": {"value": 100}}
    assert read_graph(graph) == read_graph(graph)
    assert len(graph_of(read_graph(graph))["nodes"]) == 101


JUNK = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(max_size=5) | st.floats(),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=5), inner, max_size=3)
    ),
    max_leaves=8,
)
KINDS = st.sampled_from(
    ["number", "symbol", "add", "mul", "div", "neg", "pow", "call", "matrix", "at"]
)
NODE = st.tuples(
    KINDS, st.lists(st.integers(-2, 6) | st.sampled_from(["1", "1/2", "x"]), max_size=4)
)


@settings(max_examples=samples(60), deadline=None)
@given(st.lists(NODE.map(lambda n: [n[0], *n[1]]) | JUNK, max_size=7), st.integers(-1, 7))
def test_only_its_own_error_comes_out(nodes: list[Any], value: int) -> None:
    try:
        read = read_graph({"nodes": nodes, "outputs": {"value": value}})
    except Malformed:
        return
    assert isinstance(read, Expr)
    assert read_graph(graph_of(read)) == read
