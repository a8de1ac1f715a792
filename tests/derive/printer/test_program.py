"""Graphs become straight lines of operations without changing what is computed."""

import pytest

from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.program import program


def operations(graph: Graph) -> list[str]:
    return [step.operation for step in program(graph).steps]


def test_chains_run_from_left_to_right_and_subtractions_are_seen() -> None:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    graph = b.graph({"value": b.operation("add", -x, y, -b.sqrt(x))})
    assert operations(graph) == ["input", "input", "sqrt", "sub", "sub"]
    steps = program(graph).steps
    assert (steps[3].operands, steps[4].operands) == ((1, 0), (3, 2))
    assert operations(b.graph({"value": -x - y})) == ["input", "input", "add", "neg"]


def test_powers_of_two_scale_without_rounding() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    steps = program(b.graph({"value": b.operation("mul", 2, x, 8) / 4})).steps
    scales = [step.scale for step in steps if step.operation == "mul"]
    assert scales == [2.0, 8.0, 0.25]
    assert [step.scale for step in program(b.graph({"value": x * 3})).steps][-1] is None


def test_constants_are_folded_and_never_confused_with_one_another() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    root = b.sqrt(3)  # its node gets the number that is also another constant's value
    for number in range(1, 9):
        graph = b.graph({"root": root + x * 3, "sum": x + number, "exact": b.sqrt(4) + x})
        steps = program(graph)
        constants = {step.constant for step in steps.steps if step.constant is not None}
        rational = {each.rational for each in constants}
        assert rational == {None, 2, 3, number}, number
        assert len(constants) == len(rational)


def test_labels_belong_to_the_whole_expression() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    total = x + b.sqrt(x) + 1
    steps = program(b.graph({"value": total}, {"total": total})).steps
    assert [step.label for step in steps] == ["x", "", "", "", "total"]


def test_unknown_nodes_are_refused() -> None:
    graph: Graph = {"nodes": [["symbol", "x"], ["call", "tan", 0]], "outputs": {"y": 1}}
    with pytest.raises(ValueError, match=r"node 1 .* no operation of a kernel"):
        program(graph)
    graph = {"nodes": [["symbol", "x"], ["pow", 0, "1/3"]], "outputs": {"y": 1}}
    with pytest.raises(ValueError, match=r"node 1 .* no operation of a kernel"):
        program(graph)
