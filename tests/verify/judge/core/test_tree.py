"""A graph that was read before is read no differently."""

from __future__ import annotations

from typing import Any

import pytest

from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.work_limits import Limits, Malformed

HALF: dict[str, Any] = {"nodes": [["number", "1/2"]], "outputs": {"value": 0}}


def test_a_tree_is_read_as_by_the_reader_that_keeps_nothing() -> None:
    graph = {"nodes": [["symbol", "x"], ["number", "2"], ["mul", 1, 0]], "outputs": {"value": 2}}
    assert read_tree(graph) == read_graph(graph) == read_tree(dict(graph))


@pytest.mark.parametrize("place", [False, 0.0, "0", None])
def test_what_only_looks_equal_is_still_refused(place: object) -> None:
    read_tree(HALF)
    with pytest.raises(Malformed):
        read_tree({"nodes": HALF["nodes"], "outputs": {"value": place}})


def test_a_graph_changed_afterwards_is_read_anew() -> None:
    nodes = [["number", "1/2"]]
    graph = {"nodes": nodes, "outputs": {"value": 0}}
    before = read_tree(graph)
    nodes[0][1] = "1/3"
    assert read_tree(graph) != before


def test_limits_count_for_what_is_known_too() -> None:
    read_tree(HALF)
    with pytest.raises(Malformed):
        read_tree(HALF, Limits(nodes=0))


def test_what_is_no_plain_data_is_refused() -> None:
    with pytest.raises(Malformed):
        read_tree({"nodes": object(), "outputs": {"value": 0}})
