"""Kernels made from a graph alone: run as printed, and evaluated in balls by other code."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any, TypeVar

import flint
import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import Input, Kernel, Limit, Module, Output, closed
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.numpy_source import printed
from gainproof.derive.printer.package import HERE, PLACE

Point = float | Mapping[str, float]
Place = TypeVar("Place", float, Mapping[str, float])
KINDS: dict[str, type[Any]] = {"float64": np.float64, "float32": np.float32}


def kernel_of(
    graph: Graph,
    scales: dict[str, str] | None = None,
    cancellations: dict[str, str] | None = None,
    lower: Limit = "0",
    upper: Limit | None = None,
    **options: Any,
) -> Kernel:
    """A kernel of one input x; `scales` names an output's scale, outputs of "_" are scales only."""
    shown = [name for name in graph["outputs"] if not name.startswith("_")]
    return Kernel(
        "kernel",
        "Result",
        "A kernel under test.",
        ("y = f(x)",),
        (Input("x", "the argument", lower, upper, **options),),
        tuple(Output(name, "a value", relative_to=(scales or {}).get(name)) for name in shown),
        graph,
        "this test",
        cancellations or {},
    )


def simple(write: Callable[[GraphBuilder, Node], Node], **options: Any) -> Kernel:
    """A kernel whose one output y is written by a function of builder and input."""
    b = GraphBuilder()
    return kernel_of(b.graph({"y": write(b, b.symbol("x"))}), **options)


def text_of(kernel: Kernel) -> str:
    """The printed module of one kernel."""
    module = Module("made", "Made for a test", "a command", "a derivation", (kernel,))
    return printed(module, prove_all(module.kernels))


def several_of(
    graph: Graph,
    lower: Limit,
    upper: Limit,
    scales: dict[str, str] | None = None,
    cancellations: dict[str, str] | None = None,
    single: tuple[Limit, Limit] | None = None,
) -> Kernel:
    """A kernel of the inputs x and z, both closed; the rest as in `kernel_of`."""
    inputs = tuple(closed(name, "an argument", lower, upper, single) for name in ("x", "z"))
    return replace(kernel_of(graph, scales, cancellations), inputs=inputs)


def two_inputs(write: Callable[[GraphBuilder, Node, Node], Node], **options: Any) -> Kernel:
    """A kernel whose one output y is written by a function of builder and both inputs."""
    b = GraphBuilder()
    graph = b.graph({"y": write(b, b.symbol("x"), b.symbol("z"))})
    return several_of(graph, **{"lower": "1e-6", "upper": "1e6", **options})


def function_of(kernel: Kernel) -> Callable[..., tuple[NDArray[np.floating[Any]], ...]]:
    """The printed function, run with the printer's own copy of the run time."""
    function: Callable[..., tuple[NDArray[np.floating[Any]], ...]] = module_of(kernel)[kernel.name]
    return function


def module_of(kernel: Kernel) -> dict[str, Any]:
    """The names of the printed module."""
    text = text_of(kernel).replace(f"{PLACE}._", f"{HERE}._")
    space: dict[str, Any] = {"__name__": "made"}
    exec(compile(text, "made.py", "exec"), space)  # noqa: S102  # our own printer's text
    return space


def balls(graph: Graph, point: Point, bits: int = 400) -> dict[str, flint.arb]:
    """Enclosures of all outputs, straight from the graph's nodes."""
    values = node_balls(graph, point, bits)
    return {name: values[number] for name, number in graph["outputs"].items()}


def node_balls(graph: Graph, point: Point, bits: int = 400) -> list[flint.arb]:
    """Enclosures of all nodes; a plain number is the value of every symbol."""
    with flint.ctx.workprec(bits):
        values: list[flint.arb] = []
        for number, node in enumerate(graph["nodes"]):
            if node[:2] == ["call", "unknown"]:
                values.append(_fixed_point(graph["nodes"], number, values, bits))
                continue
            if node[0] == "symbol":
                values.append(
                    flint.arb(point[str(node[1])] if isinstance(point, Mapping) else point)
                )
            else:
                values.append(_ball(node, values))
        return values


def _fixed_point(
    nodes: Sequence[Sequence[str | int]], unknown: int, values: list[flint.arb], bits: int
) -> flint.arb:
    """By bisection of a logarithm: a map of slope below 1 makes greater what lies below its value.

    What the map needs beside the unknown stands before it.
    """
    (image,) = {node[3] for node in nodes if node[:3] == ["call", "fixed_point", unknown]}
    assert isinstance(image, int)

    def greater(x: flint.arb) -> bool:
        known = [*values, x]
        for node in nodes[unknown + 1 : image + 1]:
            known.append(_ball(node, known))
        assert known[image] > x or known[image] < x, "too close for this precision"
        return bool(known[image] > x)

    low, high = flint.arb(2) ** -2000, flint.arb(2) ** 2000
    while not high < 2 * low:
        middle = (low * high).sqrt().mid()
        low, high = (flint.arb(middle), high) if greater(middle) else (low, flint.arb(middle))
    while high - low > low * flint.arb(2) ** (24 - bits):
        middle = flint.arb(((low + high) / 2).mid())
        low, high = (middle, high) if greater(middle) else (low, middle)
    return low.union(high)


@cache
def _rational(text: str) -> flint.fmpq:
    """Not its ball, which depends on the precision."""
    value = Fraction(text)
    return flint.fmpq(value.numerator, value.denominator)


def _ball(node: Sequence[str | int], values: list[flint.arb]) -> flint.arb:
    """Of a node that is no symbol."""
    parts = [values[part] for part in node[1:] if isinstance(part, int)]
    match node[0]:
        case "number":
            return flint.arb(_rational(str(node[1])))
        case "add":
            return sum(parts[1:], parts[0])
        case "mul":
            product = parts[0]
            for part in parts[1:]:
                product = product * part
            return product
        case "div":
            return parts[0] / parts[1]
        case "neg":
            return -parts[0]
        case "pow":
            return parts[0].sqrt()
    if node[1] == "abs":
        return abs(parts[0])
    if node[1] == "fixed_point":
        return parts[2]
    if node[1] == "near_cbrt":
        return parts[0].root(3)
    first, second = parts[:2]
    if first < second:
        return parts[2]
    assert first >= second, "a comparison too close for this precision"
    return parts[3]


def worst_error(
    kernel: Kernel, computed: Sequence[NDArray[np.floating[Any]]], row: int, points: Sequence[Place]
) -> tuple[float, Place | None]:
    """The greatest error of an output over its scale, as a plain number, and where it is."""
    output = kernel.outputs[row]
    worst: float = 0.0
    place: Place | None = None
    for x, value in zip(points, computed[row].tolist(), strict=True):
        exact = balls(kernel.graph, x)
        error = abs(
            (flint.arb(value) - exact[output.name]) / exact[output.relative_to or output.name]
        )
        size = float(error.upper())
        if not size <= worst:
            worst, place = size, x
    return worst, place
