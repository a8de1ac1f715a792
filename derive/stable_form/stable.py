"""From derived expressions to a graph without cancellation, where one is found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, cast

import sympy as sp

from gainproof.derive.expression import graph_of
from gainproof.derive.printer.bound import OutputBound
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, operands
from gainproof.derive.printer.kernel import Input
from gainproof.derive.stable_form.candidates import SCALE, VALUE, Candidate, best
from gainproof.derive.stable_form.certificate import GIVEN, STABLE, claims, document, proof

REASON = "no form without this subtraction was found"


@dataclass(frozen=True)
class StableForm:
    """What was found for some outputs of the same inputs.

    `graph`: all outputs, as the printer takes them, and for each whose subtractions remain an
    output of the name in `scales`, the same with both sides of every such subtraction added: what
    the error is to be measured by. `cancellations`: names of those differences in the graph's
    "names", with the reason a kernel needs. `rules`: what was done, by output. `bounds`: the proved
    error in float64 of each output by itself, None where none was proved: `refusals` says why.
    `tried`: how many ways of writing were compared. `given`: the graph of the expressions as they
    came.
    """

    inputs: tuple[Input, ...]
    given: Graph
    graph: Graph
    scales: Mapping[str, str]
    cancellations: Mapping[str, str]
    rules: Mapping[str, tuple[str, ...]]
    bounds: Mapping[str, OutputBound | None]
    refusals: Mapping[str, str]
    tried: int
    certificate: Mapping[str, Any]

    @cached_property
    def claims(self) -> list[dict[str, Any]]:
        """What the certificate has to prove, for the checker to compare."""
        return claims(list(self.bounds))


def stable(outputs: Mapping[str, sp.Expr], inputs: Sequence[Input]) -> StableForm:
    """A form of every output that loses no digits to subtraction, where one is found.

    `outputs`: expressions of the inputs' names, made of numbers, sums, products, quotients and
    square roots. `inputs`: with domains of positive numbers. The form equals what was given at
    every point inside the domain, and so by continuity at its ends wherever both are defined: the
    certificate is to be put before the checker of certificates, which alone decides that.

    NoReading if an expression is none of these, or a root or divisor in it is not shown to be
    positive or negative on the domain.
    """
    found = {name: best(expression, inputs) for name, expression in outputs.items()}
    given = cast("Graph", graph_of(outputs))
    graph, cancellations = _joined({name: each.candidate for name, each in found.items()})
    graphs = {GIVEN: given, STABLE: graph}
    proofs = {
        name: proof(name, each.candidate.reading, each.candidate.value, graphs)
        for name, each in found.items()
    }
    return StableForm(
        tuple(inputs),
        given,
        graph,
        {name: f"{name}_{SCALE}" for name in found if f"{name}_{SCALE}" in graph["outputs"]},
        cancellations,
        {name: each.candidate.rules for name, each in found.items()},
        {name: each.bound for name, each in found.items()},
        {name: each.refusal for name, each in found.items() if each.refusal},
        sum(each.tried for each in found.values()),
        document("stable form", graphs, proofs),
    )


def _joined(candidates: Mapping[str, Candidate]) -> tuple[Graph, dict[str, str]]:
    """One graph of all outputs: what several compute is computed once."""
    builder = GraphBuilder()
    ends: dict[str, Node] = {}
    names: dict[str, Node] = {}
    for output, candidate in candidates.items():
        made: list[Node] = []
        for node in candidate.graph["nodes"]:
            made.append(builder.operation_of(node, [made[part] for part in operands(node)]))
        for name, number in candidate.graph["outputs"].items():
            ends[output if name == VALUE else f"{output}_{name}"] = made[number]
        for name, number in candidate.graph.get("names", {}).items():
            names[f"{output}_{name}"] = made[number]
    return builder.graph(ends, names), dict.fromkeys(names, REASON)
