"""From derived expressions to a graph without cancellation, where one is found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import sympy as sp

from gainproof.derive.expression import graph_of
from gainproof.derive.printer.bound import OutputBound
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, operands
from gainproof.derive.printer.kernel import Input
from gainproof.derive.stable_form.candidates import best
from gainproof.derive.stable_form.certificate import GIVEN, STABLE, Proof, claims, document
from gainproof.derive.stable_form.enlargement import Enlargement, enlargement
from gainproof.derive.stable_form.ranking import Candidate
from gainproof.derive.stable_form.writing import SCALE, VALUE

ARGUMENT = "a function is taken of it"
BUDGET = 400
"""Ways of writing an output that are compared: more than formulas of a few roots have."""
REASON = "no form without this subtraction was found"


@dataclass(frozen=True)
class StableForm:
    """What was found for some outputs of the same inputs.

    `graph`: all outputs, as the printer takes them, and for each whose subtractions remain an
    output of the name in `scales`, the same with both sides of every such subtraction added: what
    the error is to be measured by. `cancellations`: names of those differences in the graph's
    "names", with the reason a kernel needs; `enlargements`: scales over values, by output.
    `rules`: what was done, by output. `bounds`: the proved error in float64 of each output by
    itself, with the inputs for which it holds; None where none was proved. `refusals` says why
    none was for all inputs. `positive` says what each value is needed for that is shown to be
    positive; `functions` the kind of each atom. `tried`: how many ways of writing were compared.

    `certificate` shows of each output y that its programs given_y and stable_y have the same
    values, and `claims` is what it has to prove, for the checker to compare. Without functions of a
    library the first is what came and the second what `graph` holds of y; with them both hold
    symbols in their places, by the rules of `atoms`, and the arguments of each have such proofs
    too, and are shown to be positive, with whatever else has to be: what logarithms and roots are
    taken of, and what bounds angles.
    """

    inputs: tuple[Input, ...]
    graph: Graph
    scales: Mapping[str, str]
    cancellations: Mapping[str, str]
    enlargements: Mapping[str, Enlargement]
    rules: Mapping[str, tuple[str, ...]]
    bounds: Mapping[str, OutputBound | None]
    refusals: Mapping[str, str]
    positive: Mapping[str, str]
    functions: Mapping[str, str]
    tried: int
    certificate: Mapping[str, Any]
    claims: list[dict[str, Any]]


def stable(
    outputs: Mapping[str, sp.Expr], inputs: Sequence[Input], budget: int = BUDGET
) -> StableForm:
    """A form of every output that loses no digits to subtraction, where one is found.

    `outputs`: expressions of the inputs' names, made of numbers, sums, products, quotients, square
    roots, exponentials, logarithms, sines, cosines and arctangents (see `atoms`). `inputs`: with
    domains of positive numbers. The form equals what was given at every point inside the domain,
    and so by continuity at its ends wherever both are defined: the certificate is to be put before
    the checker of certificates, which alone decides that.

    `budget`: how many ways of writing each output are compared at most (1 or more), the best of
    those being taken; a number of ways, no time, so that the same form comes on every machine.

    NoReading if an expression is none of these, or a root, a divisor or an argument in it is not
    shown to be positive or negative on the domain.
    """
    if budget < 1:
        raise ValueError(f"a budget of 1 or more is wanted, {budget} came")
    found = {name: best(expression, inputs, name, budget) for name, expression in outputs.items()}
    candidates = {name: each.candidate for name, each in found.items()}
    graph, cancellations = _joined({name: each.graph for name, each in candidates.items()})
    scales = {name: f"{name}_{SCALE}" for name in found if f"{name}_{SCALE}" in graph["outputs"]}
    proofs = [proof for name, each in candidates.items() for proof in _proofs(name, each)]
    return StableForm(
        tuple(inputs),
        graph,
        scales,
        cancellations,
        {name: enlargement(graph, name, scale, inputs) for name, scale in scales.items()},
        {name: each.rules for name, each in candidates.items()},
        {name: each.bound for name, each in found.items()},
        {name: each.refusal for name, each in found.items() if each.refusal},
        {proof.name: proof.positive for proof in proofs if proof.positive},
        {name: a.kind for each in candidates.values() for name, a in each.text.atoms.items()},
        sum(each.tried for each in found.values()),
        document(proofs),
        claims(proofs),
    )


def _proofs(output: str, candidate: Candidate) -> Iterator[Proof]:
    """Of the output, of the arguments of its functions, and of what is required besides."""
    text, (written, _) = candidate.text, candidate.writing.graph(abstract=True)

    def both(name: str, expression: sp.Expr, end: str) -> dict[str, Graph]:
        return {GIVEN: _given(name, expression), STABLE: _renamed(written, end, name)}

    graphs = both(output, text.expression, VALUE)
    yield Proof(output, graphs, text.reading, text.value)
    for name, atom in text.atoms.items():
        value = atom.reading.read(atom.value)
        yield Proof(name, both(name, atom.value, name), atom.reading, value, ARGUMENT)
    for each in text.required:
        graphs = {GIVEN: _given(each.name, each.value)}
        value = each.reading.read(each.value)
        yield Proof(each.name, graphs, each.reading, value, each.reason)


def _given(name: str, expression: sp.Expr) -> Graph:
    return cast("Graph", graph_of({name: expression}))


def _renamed(graph: Graph, output: str, name: str) -> Graph:
    """What one output needs, under another name."""
    builder = GraphBuilder()
    return builder.graph({name: _copied(builder, graph)[graph["outputs"][output]]})


def _copied(builder: GraphBuilder, graph: Graph) -> list[Node]:
    made: list[Node] = []
    for node in graph["nodes"]:
        made.append(builder.operation_of(node, [made[part] for part in operands(node)]))
    return made


def _joined(graphs: Mapping[str, Graph]) -> tuple[Graph, dict[str, str]]:
    """One graph of all outputs, computing once what several need, and names of differences."""
    builder = GraphBuilder()
    ends: dict[str, Node] = {}
    names: dict[str, Node] = {}
    for output, graph in graphs.items():
        made = _copied(builder, graph)
        for name, number in graph["outputs"].items():
            ends[output if name == VALUE else f"{output}_{name}"] = made[number]
        for name, number in graph.get("names", {}).items():
            names[f"{output}_{name}"] = made[number]
    return builder.graph(ends, names), dict.fromkeys(names, REASON)
