"""Calls of a library in the kernels of polar coordinates: what stands for them, and is refused."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest
from catalogue_subjects import certificate

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.sensors.algebraic_graphs import algebraic
from gainproof.derive.sensors.polar_coordinates import graphs
from gainproof.verify.certificate import check_statement

Plain = dict[str, Any]


def status(kernel: str, graph: Graph) -> str:
    """What the certificate's claims come to when the kernel were printed from this graph."""
    data: Plain = json.loads(json.dumps(certificate("polar-coordinates")))
    left = algebraic(graph)
    data["programs"][kernel]["graph"] = {"nodes": left["nodes"], "outputs": left["outputs"]}
    return check_statement(data, f"kernel-{kernel.replace('_', '-')}").status


def call_of(graph: Graph, name: str) -> list[Any]:
    names = graph.get("names")
    assert names is not None
    return graph["nodes"][names[name]]


@pytest.mark.parametrize("kernel", ["to_polar", "to_polar_in_plane"])
def test_a_bearing_from_east_is_refused(kernel: str) -> None:
    """The arguments of atan2 the other way round: right for mathematicians, wrong for sailors."""
    graph = copy.deepcopy(graphs()[kernel])
    assert status(kernel, graph) == "proved"
    node = call_of(graph, "bearing")
    node[2:] = reversed(node[2:])
    assert status(kernel, graph) == "rejected"


def test_an_elevation_of_the_range_is_refused() -> None:
    """atan2(z, R) in place of atan2(z, h)."""
    b = GraphBuilder()
    x, y, z = (b.symbol(name) for name in "xyz")
    h = b.sqrt(x * x + y * y)
    r = b.sqrt((x * x + y * y) + z * z)

    def made(adjacent: Node) -> Graph:
        angles = {"elevation": b.call("atan2", z, adjacent), "bearing": b.call("atan2", x, y)}
        roots = {"horizontal_distance": h, "slant_range": r}
        return b.graph({"slant_range": r, **angles}, {**angles, **roots})

    assert status("to_polar", made(h)) == "proved"
    assert status("to_polar", made(r)) == "rejected"


@pytest.mark.parametrize("kernel", ["mean_of_converted", "mean_of_converted_in_plane"])
@pytest.mark.parametrize("name", ["kept_level", "change_level"])
def test_an_exponential_of_something_else_is_refused(kernel: str, name: str) -> None:
    """exp(-s^2) for exp(-s^2/2): whoever forgets the half."""
    graph = copy.deepcopy(graphs()[kernel])
    assert status(kernel, graph) == "proved"
    node = call_of(graph, name)
    whole = graph["nodes"][node[2]]
    assert whole[0] == "div"
    node[2] = whole[1]
    assert status(kernel, graph) == "rejected"


def test_calls_stand_as_symbols_and_their_arguments_are_claimed() -> None:
    claims = {
        entry["claim"]["program"]: set(entry["claim"]["outputs"])
        for entry in certificate("polar-coordinates")["statements"]
        if entry["kind"] == "program"
    }
    for name, graph in graphs().items():
        found = algebraic(graph)
        assert not any(node[0] == "call" for node in found["nodes"])
        assert claims[name] == set(found["outputs"])
    assert {"elevation_opposite", "bearing_adjacent"} <= claims["to_polar"]
    assert {"kept_level_of", "change_upwards_of"} <= claims["mean_of_converted"]


def with_call(function: str, argument: str, name: str | None, *, used: bool = True) -> Graph:
    b = GraphBuilder()
    x = b.symbol(argument)
    call = b.call(function, x, *([x] if function in ("atan2", "hypot") else []))
    return b.graph({"y": call * x if used else call}, {name: call} if name else {})


@pytest.mark.parametrize(
    ("graph", "words"),
    [
        (with_call("sin", "elevation", None), "the call of sin has no name"),
        (with_call("sin", "elevation", "cos_elevation"), "sin of .* is called cos_elevation"),
        (with_call("sin", "elevation", "sin_bearing"), "sin of .* is called sin_bearing"),
        (with_call("atan2", "x", "bearing"), "computes with the angle bearing"),
        (with_call("atan2", "x", "bearing", used=False), "output y is the angle bearing"),
        (with_call("hypot", "x", "h"), "hypot is no function of an angle"),
        (with_call("sin", "sin_elevation", "sin_elevation"), "has the name of the input"),
        (with_call("exp", "kept_level", "kept_level"), "has the name of the input kept_level"),
        (with_call("exp", "x", "cos_bearing"), "exp is called cos_bearing"),
        (with_call("expm1", "x", "kept_level"), "expm1 is called kept_level"),
    ],
)
def test_calls_of_which_nothing_would_be_proved_are_refused(graph: Graph, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        algebraic(graph)


def test_a_graph_without_calls_stays_what_it_is() -> None:
    graph = graphs()["polar_derivatives"]
    assert algebraic(graph) is graph
