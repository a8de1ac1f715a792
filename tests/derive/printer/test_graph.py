"""The graph builder keeps the author's order and shares equal nodes."""

from fractions import Fraction

import pytest

from gainproof.derive.printer.graph import GraphBuilder


def test_order_is_the_authors_and_equal_nodes_are_shared() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    y = 2 * x + x / 3 + 2 * x
    graph = b.graph({"y": y}, names={"third": x / 3, "unused": x * 7})
    assert graph["nodes"] == [
        ["symbol", "x"],
        ["number", "2"],
        ["mul", 1, 0],
        ["number", "3"],
        ["div", 0, 3],
        ["add", 2, 4],
        ["add", 5, 2],
    ]
    assert graph["outputs"] == {"y": 6}
    assert graph.get("names") == {"third": 4}


def test_subtraction_select_and_roots() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.absolute(Fraction(1, 2) - x)
    graph = b.graph({"y": b.select(x, "1/2", b.sqrt(gap), -x)})
    assert graph["nodes"] == [
        ["symbol", "x"],
        ["neg", 0],
        ["number", "1/2"],
        ["add", 2, 1],
        ["call", "abs", 3],
        ["pow", 4, "1/2"],
        ["call", "select", 0, 2, 5, 1],
    ]


def test_what_is_refused() -> None:
    b, other = GraphBuilder(), GraphBuilder()
    with pytest.raises(TypeError, match=r"wanted an integer, a fraction or its text, got 0\.1"):
        b.number(0.1)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="another GraphBuilder"):
        b.operation("add", b.symbol("x"), other.symbol("x"))
    with pytest.raises(ValueError, match="at least one output"):
        b.graph({})
