"""Kernels: the graph that is printed as code has, in exact arithmetic, the claimed values."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case, Program
from gainproof.verify.certificate.expression import Evaluation, Value
from gainproof.verify.certificate.graph import Call, Graph, Skipped, read_expression
from gainproof.verify.certificate.matrix import Matrix
from gainproof.verify.certificate.nonzero_divisors import Nonzero
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.program_fixed_points import (
    effort,
    require_one_fixed_point,
    shown_positive,
)
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import MalformedError, RejectedError
from gainproof.verify.certificate.tower import Tower
from gainproof.verify.certificate.written_polynomials import WrittenFraction

CHOICES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {"select": ("then", "else"), "abs": ("positive", "negative")}
)
"""The branches of functions that have some."""


def program(case: Case) -> str:
    """Each claimed output of the program equals its expression at every point of the tower.

    Claim: program (name), outputs (for each output a graph), and possibly nodes (for some nodes on
    the way to these outputs a graph: what the kernel computes there, written so from there on).
    Evidence: roots (for each evaluated power with a fractional exponent its root, manifestly
    nonnegative; for each unknown its value, manifestly positive), branches and gaps (for each
    evaluated ``select`` and ``abs``) and nonzero.
    """
    more = ("nodes",) if "nodes" in schema.table(case.claim, case.place) else ()
    claim = case.claims("program", "outputs", *more)
    evidence = case.evidences("roots", "branches", "gaps", "nonzero")
    name = schema.name(claim["program"], f"{case.place}.claim.program")
    if name not in case.programs:
        raise RejectedError(f"the program {name!r} is not in the certificate")
    kernel = case.programs[name]
    nonzero = case.nonzero(evidence["nonzero"])
    claimed = schema.table(claim["outputs"], f"{case.place}.claim.outputs")
    if not claimed:
        raise RejectedError("no output is claimed")
    for output in claimed:
        if output not in kernel.graph.outputs:
            raise RejectedError(f"the program has no output {output!r}")
    roots = fractions(case, evidence["roots"], "roots")
    branches = branches_taken(case, evidence["branches"], kernel.graph)
    gaps = fractions(case, evidence["gaps"], "gaps")
    evaluation = case.evaluation(nonzero)
    nodes = nodes_claimed(case, evaluation, claim)
    run = _Run(case, nonzero, kernel, roots, branches, gaps, nodes)
    found = run.outputs(kernel.graph, tuple(claimed))
    run.finish()
    for output, value in found.items():
        wanted = evaluation.scalar(case.expression(claimed[output], f"outputs.{output}"))
        if isinstance(value, Matrix) or not value.equals(wanted):
            raise RejectedError(f"the output {output!r} does not equal the claimed expression")
    case.finish(nonzero)
    return "proved"


class _Run(Evaluation):
    """Evaluates a kernel: inputs stand for elements, roots and branches come with evidence."""

    def __init__(
        self,
        case: Case,
        nonzero: Nonzero,
        kernel: Program,
        roots: Mapping[int, WrittenFraction],
        branches: Mapping[int, str],
        gaps: Mapping[int, WrittenFraction],
        claimed: Mapping[int, Ratio],
    ) -> None:
        super().__init__(case.tower, nonzero)
        self._inputs = input_values(case.tower, case.evaluation(nonzero), kernel)
        self._graph = kernel.graph
        self._effort = effort(kernel.graph)
        self._roots = dict(roots)
        self._branches = dict(branches)
        self._gaps = dict(gaps)
        self._claimed = dict(claimed)
        self._met: set[int] = set()
        self._positive: dict[int, bool] = {}
        self._fixed: set[int] = set()
        self._rooted: set[int] = set()
        self._decided: set[int] = set()

    def skipped(self, graph: Graph) -> Mapping[int, Skipped]:
        branches = {
            index: (3,) if choice == "then" else (2,)
            for index, choice in self._branches.items()
            if choice in ("then", "else")
        }
        return branches | {
            index: (0, 1)
            for index, node in enumerate(graph.nodes)
            if isinstance(node, Call) and node.function == "unknown"
        }

    def symbol(self, name: str) -> Ratio:
        if name not in self._inputs:
            raise RejectedError(f"the symbol {name!r} is not an input of the program")
        return self._inputs[name]

    def root(self, index: int, base: Ratio, degree: int) -> Ratio:
        if index not in self._roots:
            raise RejectedError("no root is given")
        self._rooted.add(index)
        root = self._roots[index].nonnegative(self.tower.field)
        if not root.power(degree).equals(base):
            raise RejectedError("the root given is not a root of the base")
        return root

    def call(self, index: int, node: Call, values: Mapping[int, Value]) -> Ratio:
        if node.function == "unknown":
            return self._unknown(index)
        if node.function == "fixed_point":
            return self._fixed_point(node, values)
        if node.function not in CHOICES:
            raise RejectedError(f"{node.function!r} stands only where an unknown starts")
        if index not in self._branches or index not in self._gaps:
            raise RejectedError(f"no branch or no gap is given for {node.function!r}")
        self._decided.add(index)
        choice, gap = self._branches[index], self._gaps[index]
        first = self._scalar(values, node.arguments[0])
        if node.function == "abs":
            result = first if choice == "positive" else -first
            self._require(gap.nonnegative(self.tower.field), result)
            return result
        second = self._scalar(values, node.arguments[1])
        if choice == "then":
            self._require(gap.positive(self.tower.field), second - first)
            return self._scalar(values, node.arguments[2])
        self._require(gap.nonnegative(self.tower.field), first - second)
        return self._scalar(values, node.arguments[3])

    def _unknown(self, index: int) -> Ratio:
        """The value given, manifestly positive; its fixed point shows that it is the right one."""
        if index not in self._roots:
            raise RejectedError("no root is given")
        self._rooted.add(index)
        return self._roots[index].positive(self.tower.field)

    def _fixed_point(self, node: Call, values: Mapping[int, Value]) -> Ratio:
        unknown, image, wanted = node.arguments
        if unknown in self._fixed:  # it has one map, which was decided
            return self._scalar(values, wanted)
        self.tower.field.ring.meter.spend(self._effort)
        for index in sorted(values.keys() - self._positive.keys()):
            self._positive[index] = shown_positive(
                self._graph.nodes[index], values[index], self._positive
            )
        require_one_fixed_point(self._graph, unknown, image, self._positive)
        if not self._scalar(values, image).equals(self._scalar(values, unknown)):
            raise RejectedError("the root given is not a fixed point of the map")
        self._fixed.add(unknown)
        return self._scalar(values, wanted)

    def _node(self, graph: Graph, index: int, values: Mapping[int, Value]) -> Value:
        """The value; where one is claimed it equals that, and is written so from here on."""
        found = super()._node(graph, index, values)
        if index not in self._claimed:
            return found
        self._met.add(index)
        claimed = self._claimed[index]
        if isinstance(found, Matrix) or not found.equals(claimed):
            raise RejectedError("the value claimed is not the value of the node")
        return claimed

    def finish(self) -> None:
        """Reject claims and evidence for nodes that were not evaluated."""
        for listed, visited, what in (
            (self._claimed, self._met, "claimed nodes"),
            (self._roots, self._rooted, "roots"),
            (self._branches, self._decided, "branches"),
            (self._gaps, self._decided, "gaps"),
        ):
            schema.unused({str(i) for i in listed if i not in visited}, "nodes", what)

    def _scalar(self, values: Mapping[int, Value], index: int) -> Ratio:
        value = values[index]
        if isinstance(value, Matrix):
            raise RejectedError("a matrix stands where a number is wanted")
        return value

    def _require(self, gap: Ratio, difference: Ratio) -> None:
        if not gap.equals(difference):
            raise RejectedError("the gap given is not the difference that decides the branch")


def input_values(
    tower: Tower,
    evaluation: Evaluation,
    kernel: Program,
) -> dict[str, Ratio]:
    """The values of a program's symbols."""
    return {
        name: tower.value(meaning) if isinstance(meaning, str) else evaluation.scalar(meaning)
        for name, meaning in kernel.inputs.items()
    }


def nodes_claimed(
    case: Case, evaluation: Evaluation, claim: Mapping[str, Plain]
) -> dict[int, Ratio]:
    """What nodes are claimed to equal, as values; none if there is no such field."""
    if "nodes" not in claim:
        return {}
    place = f"{case.place}.claim.nodes"
    found = {
        schema.index(key, place): evaluation.scalar(read_expression(entry, f"{place}.{key}"))
        for key, entry in schema.table(claim["nodes"], place).items()
    }
    if not found:
        raise MalformedError(f"{place}: some are claimed or the field is left out")
    return found


def fractions(case: Case, value: Plain, field: str) -> dict[int, WrittenFraction]:
    """The fractions given for nodes."""
    place = f"{case.place}.evidence.{field}"
    return {
        schema.index(key, place): case.fraction(entry, f"{field}.{key}")
        for key, entry in schema.table(value, place).items()
    }


def branches_taken(case: Case, value: Plain, graph: Graph) -> dict[int, str]:
    """The branches taken at nodes that have some."""
    place = f"{case.place}.evidence.branches"
    chosen: dict[int, str] = {}
    for key, choice in schema.table(value, place).items():
        index = schema.index(key, place)
        node = graph.nodes[index] if index < len(graph.nodes) else None
        if not isinstance(node, Call) or node.function not in CHOICES:
            raise RejectedError(f"{place}: node {key} has no branches")
        if not isinstance(choice, str) or choice not in CHOICES[node.function]:
            raise RejectedError(f"{place}.{key}: one of {CHOICES[node.function]} is wanted")
        chosen[index] = choice
    return chosen
