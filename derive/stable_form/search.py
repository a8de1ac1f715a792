"""From derived expressions to a graph without cancellation, where one is found.

How much a subtraction that is left may lose is looked at on a grid of points: scale/|value|, the
scale being the same with both sides of each difference added, times the error bound over the scale
is what the value's own relative error may be. What is found is a least, not a bound: a peak or a
pair of zeros between two points is not seen. (The condition number in a kernel's docstring is
another thing: a bound, by which factor errors of a difference's operands enter an output.)
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, cast

import sympy as sp
from mpmath import mp

from gainproof.derive.expression import graph_of
from gainproof.derive.printer.bound import OutputBound
from gainproof.derive.printer.domain import input_range
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, operands
from gainproof.derive.printer.kernel import Input
from gainproof.derive.stable_form.candidates import best
from gainproof.derive.stable_form.certificate import GIVEN, STABLE, Proof, claims, document
from gainproof.derive.stable_form.ranking import Candidate
from gainproof.derive.stable_form.written_value import SCALE, VALUE

ARGUMENT = "a function is taken of it"
BUDGET = 400
"""Ways of writing an output that are compared: more than formulas of a few roots have."""
REASON = "no form without this subtraction was found"
POINTS = 400  # in all
WIDEST = 1e30  # inputs beyond, and below its inverse, are not looked at
DIGITS = 60


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
    symbols in their places, by the rules of `function_atoms`, and the arguments of each have such
    proofs too, and are shown to be positive, with whatever else has to be: what logarithms and
    roots are taken of, and what bounds angles.
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
    roots, exponentials, logarithms, sines, cosines and arctangents (see `function_atoms`).
    `inputs`: with domains of positive numbers. The form equals what was given at every point inside
    the domain, and so by continuity at its ends wherever both are defined: the certificate is to be
    put before the checker of certificates, which alone decides that.

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


@dataclass(frozen=True)
class Enlargement:
    """scale/|value| reaches `least`, which it has at `place`, the largest of the points looked at;
    infinite: the value is 0 at `place`, or has another sign there than at a point before.
    """

    least: float
    place: Mapping[str, float]


def enlargement(graph: Graph, value: str, scale: str, inputs: Sequence[Input]) -> Enlargement:
    """The largest of a grid of points of the domain, a logarithmic one."""
    count = max(3, int(POINTS ** (1 / len(inputs))))
    axes = [_axis(given, count) for given in inputs]
    names = [given.name for given in inputs]
    worst = Enlargement(1.0, {})
    signs: set[bool] = set()
    with mp.workdps(DIGITS):
        for point in itertools.product(*axes):
            place = dict(zip(names, point, strict=True))
            found = _values(graph, place)
            number, size = found[graph["outputs"][value]], found[graph["outputs"][scale]]
            signs.add(number > 0)
            if number == 0 or len(signs) == 2:
                return Enlargement(math.inf, place)
            least = float(abs(size / number))
            if least > worst.least:
                worst = Enlargement(least, place)
    return worst


def _axis(given: Input, count: int) -> list[float]:
    low, high = input_range(given, FLOAT64)
    low, high = max(low, 1 / WIDEST), min(high, WIDEST)
    step = math.log(high / low) / (count - 1)
    inner = [low * math.exp(step * number) for number in range(1, count - 1)]
    return [low, *(min(max(x, low), high) for x in inner), high]


def _values(graph: Graph, point: Mapping[str, float]) -> list[Any]:
    """The value of every node."""
    values: list[Any] = []
    for node in graph["nodes"]:
        parts = [values[part] for part in operands(node)]
        match node[0]:
            case "number":
                number = Fraction(str(node[1]))
                values.append(mp.mpf(number.numerator) / number.denominator)
            case "symbol":
                values.append(mp.mpf(point[str(node[1])]))
            case "add":
                values.append(mp.fsum(parts))
            case "mul":
                values.append(mp.fprod(parts))
            case "div":
                values.append(parts[0] / parts[1])
            case "neg":
                values.append(-parts[0])
            case "pow":
                values.append(mp.sqrt(parts[0]))
            case _:
                name = str(node[1])
                values.append(abs(parts[0]) if name == "abs" else getattr(mp, name)(*parts))
    return values
