"""A graph as a straight line of elementary operations, the form that is bounded and printed.

Sums and products of several terms become chains from left to right, a sum with a negated term a
difference, and each largest part without symbols one constant. Nothing else changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.constant import Constant, constant_of_node, exact_values
from gainproof.derive.printer.graph import Graph, GraphNode, operands
from gainproof.derive.printer.unrolled_fixed_point import Cycle, unrolled

ITERATES = ("start", "iterate", "root")
FUNCTIONS = ("sin", "cos", "atan2", "hypot", "exp", "expm1", "log1p")  # see `library_functions`
CALLS = ("abs", "select", "near_cbrt", "less", *ITERATES, *FUNCTIONS)


@dataclass(frozen=True)
class Step:
    """One operation: input, constant, add, sub, mul, div, sqrt, neg, or one of `CALLS`.

    `operands` are numbers of earlier steps, `node` is the graph's node that it computes (or belongs
    to), `label` its name in the graph, or the input's name. `scale` is 2^k where the operation only
    multiplies its one remaining operand by 2^k: no rounding.
    """

    operation: str
    operands: tuple[int, ...]
    node: int
    label: str
    constant: Constant | None = None
    scale: float | None = None


@dataclass(frozen=True)
class Program:
    """Steps in order; outputs by name are numbers of steps, and so are those of its fixed points.

    Steps of operation start, iterate and root compute nothing: they say what their operand is.
    """

    steps: tuple[Step, ...]
    outputs: dict[str, int]
    inputs: tuple[str, ...]
    cycles: tuple[Cycle, ...] = ()
    kept: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)
    """What others have made of it, by what that is: the same few things are wanted everywhere."""

    def axis(self, number: int) -> int:
        """Which of the inputs a step of operation input is."""
        return self.inputs.index(self.steps[number].label)

    def affine(self, number: int) -> tuple[Constant | None, int, float] | None:
        """What a step is if it needs no rounding: (constant, 0, sign) or (None, input, +-2^k).

        None for any other step. Exactness of a constant in a format is not looked at.
        """
        step = self.steps[number]
        if step.operation == "constant":
            return step.constant, 0, 1.0
        if step.operation == "input":
            return None, number, 1.0
        if step.operation == "neg" or step.scale is not None:
            inner = self.affine(step.operands[0])
            factor = -1.0 if step.scale is None else step.scale
            if inner is None or (inner[0] is not None and step.scale is not None):
                return None
            return inner[0], inner[1], inner[2] * factor
        return None


def program(graph: Graph) -> Program:
    """The steps of a graph; ValueError names a node that the printer does not know."""
    return _Lowering(*unrolled(graph)).run()


class _Lowering:
    def __init__(self, graph: Graph, cycles: tuple[Cycle, ...]) -> None:
        self.cycles = cycles
        self.nodes: Sequence[GraphNode] = graph["nodes"]
        self.ends = graph["outputs"]
        self.labels = {number: name for name, number in graph.get("names", {}).items()}
        self.exact = exact_values(self.nodes)
        self.free = self._without_symbols()
        self.steps: list[Step] = []
        self.known: dict[tuple[object, ...], int] = {}
        self.place: dict[int, int] = {}

    def _without_symbols(self) -> list[bool]:
        free: list[bool] = []
        for node in self.nodes:
            bound = node[0] == "symbol" or node[1] in ("near_cbrt", *ITERATES)
            free.append(not bound and all(free[part] for part in operands(node)))
        return free

    def run(self) -> Program:
        used = {*self.ends.values(), *(cycle.map_value for cycle in self.cycles)}
        for number in range(len(self.nodes) - 1, -1, -1):
            if number in used and not self.free[number]:
                used.update(self._inner_operands(number))
        for number in sorted(used):
            self.place[number] = place = self._lower(number)
            if number in self.labels and not self.steps[place].label:
                self.steps[place] = replace(self.steps[place], label=self.labels[number])
        outputs = {name: self.place[number] for name, number in self.ends.items()}
        inputs = tuple(step.label for step in self.steps if step.operation == "input")
        cycles = tuple(cycle.at(self.place) for cycle in self.cycles)
        return Program(tuple(self.steps), outputs, inputs, cycles)

    def _inner_operands(self, number: int) -> tuple[int, ...]:
        """Operands, with a negated term of a sum replaced by the term."""
        node = self.nodes[number]
        if node[0] != "add":
            return operands(node)
        return tuple(self._signed(part)[0] for part in operands(node))

    def _signed(self, number: int) -> tuple[int, bool]:
        node = self.nodes[number]
        if node[0] == "neg" and not self.free[number]:
            return operands(node)[0], True
        return number, False

    def _put(self, node: int, operation: str, *parts: int, scale: float | None = None) -> int:
        key = (operation, parts, scale)
        if key not in self.known:
            self.known[key] = len(self.steps)
            self.steps.append(Step(operation, parts, node, "", scale=scale))
        return self.known[key]

    def _lower(self, number: int) -> int:
        node = self.nodes[number]
        if self.free[number]:
            value = constant_of_node(self.nodes, number, self.exact)
            # a rational equals the integer that numbers a node: the two need different words
            irrational = value.rational is None
            key = ("irrational", number) if irrational else ("rational", value.rational)
            if key not in self.known:
                self.known[key] = len(self.steps)
                self.steps.append(Step("constant", (), number, "", value))
            return self.known[key]
        match node[0]:
            case "symbol":
                self.steps.append(Step("input", (), number, str(node[1])))
                return len(self.steps) - 1
            case "add":
                return self._sum(number)
            case "mul":
                return self._product(number)
            case "div":
                over, under = operands(node)
                power = self._power_of_two(under)
                if power is not None:
                    return self._put(number, "mul", self.place[over], scale=1 / power)
                return self._put(number, "div", self.place[over], self.place[under])
            case "neg":
                return self._put(number, "neg", self.place[operands(node)[0]])
            case "pow" if node[2] == "1/2":
                return self._put(number, "sqrt", self.place[operands(node)[0]])
            case "call" if node[1] in CALLS:
                return self._put(number, str(node[1]), *(self.place[i] for i in operands(node)))
        raise ValueError(f"node {number} {node} is no operation of a kernel")

    def _sum(self, number: int) -> int:
        terms = [self._signed(part) for part in operands(self.nodes[number])]
        first, negative = terms[0]
        total = self.place[first]
        for part, minus in terms[1:]:
            term = self.place[part]
            if negative and minus:
                total = self._put(number, "add", total, term)
            elif negative:
                total, negative = self._put(number, "sub", term, total), False
            else:
                total = self._put(number, "sub" if minus else "add", total, term)
        return self._put(number, "neg", total) if negative else total

    def _product(self, number: int) -> int:
        first, *rest = operands(self.nodes[number])
        total, power = self.place[first], self._power_of_two(first)
        for part in rest:
            other = self._power_of_two(part)
            if other is not None:
                total = self._put(number, "mul", total, scale=other)
            elif power is not None:
                total = self._put(number, "mul", self.place[part], scale=power)
            else:
                total = self._put(number, "mul", total, self.place[part])
            power = None
        return total

    def _power_of_two(self, number: int) -> float | None:
        """The value of a constant node that is a power of two, which scales without rounding."""
        value = self.exact[number]
        if value is None or value <= 0 or not self.free[number]:
            return None
        top, bottom = value.as_integer_ratio()
        if top & (top - 1) or bottom & (bottom - 1) or not 2.0**-126 <= value <= 2.0**127:
            return None
        return float(Fraction(value))
