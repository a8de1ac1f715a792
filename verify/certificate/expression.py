"""Evaluating an expression graph over a tower, exactly."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TypeAlias

from gainproof.verify.certificate.derivative import derivative
from gainproof.verify.certificate.graph import (
    AtNode,
    Call,
    DerivativeNode,
    Graph,
    MatrixNode,
    Number,
    Operation,
    Power,
    Skipped,
    Symbol,
)
from gainproof.verify.certificate.matrix import Matrix
from gainproof.verify.certificate.nonzero_divisors import Nonzero
from gainproof.verify.certificate.perfect_roots import known_root
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio, number, polynomial
from gainproof.verify.certificate.rejection import MAXIMUM_ORDER, GivenUpError, RejectedError
from gainproof.verify.certificate.tower import Tower

Value: TypeAlias = Ratio | Matrix


class Evaluation:
    """Evaluates graphs over one tower, every divisor shown nonzero before use.

    Claims know the names of the tower, and roots of perfect powers and of the generators'
    radicands. Kernels evaluate with a subclass that takes names, roots and branches from elsewhere.
    """

    def __init__(
        self,
        tower: Tower,
        nonzero: Nonzero,
        replaced: Mapping[int, Ratio] | None = None,
        depth: int = 0,
    ) -> None:
        """``replaced`` gives the variables that have another value here, ``depth`` the nesting."""
        self.tower = tower
        self.nonzero = nonzero
        self._replaced = replaced or {}
        self._depth = depth

    def outputs(self, graph: Graph, wanted: tuple[str, ...]) -> dict[str, Value]:
        """The values of the named outputs. Only the nodes they need are evaluated."""
        ends = {name: graph.outputs[name] for name in wanted}
        values = self._values(graph, ends.values())
        return {name: values[end] for name, end in ends.items()}

    def value(self, graph: Graph) -> Value:
        """The value of the output "value"."""
        return self.outputs(graph, ("value",))["value"]

    def scalar(self, graph: Graph) -> Ratio:
        """The value of the output "value", which must not be a matrix."""
        return _scalar(self.value(graph))

    def skipped(self, graph: Graph) -> Mapping[int, Skipped]:
        """For some nodes: the positions of arguments that are not evaluated beforehand."""
        return {index: (0,) for index, node in enumerate(graph.nodes) if isinstance(node, AtNode)}

    def symbol(self, name: str) -> Ratio:
        """The value of a symbol."""
        value = self.tower.value(name)
        return substituted(value, self._replaced, self.nonzero) if self._replaced else value

    def root(self, index: int, base: Ratio, degree: int) -> Ratio:
        """The nonnegative root of that degree."""
        del index
        root = known_root(base, degree)
        if root is None:
            raise RejectedError(f"the root of degree {degree} is not known in this tower")
        return root

    def call(self, index: int, node: Call, values: Mapping[int, Value]) -> Ratio:
        """The value of a named function."""
        del index, values
        raise RejectedError(f"the function {node.function!r} is possible only in programs")

    def _values(self, graph: Graph, ends: Iterable[int]) -> dict[int, Value]:
        """The values of these nodes and of those they need."""
        values: dict[int, Value] = {}
        for index in graph.reachable(ends, self.skipped(graph)):
            try:
                values[index] = self._node(graph, index, values)
            except GivenUpError:
                raise  # nothing is wrong there
            except RejectedError as rejection:
                raise type(rejection)(f"node {index}: {rejection}") from None
        return values

    def _node(self, graph: Graph, index: int, values: Mapping[int, Value]) -> Value:
        node = graph.nodes[index]
        arguments = node.arguments
        self.tower.field.ring.meter.spend(len(arguments))
        match node:
            case Number(value):
                return number(self.tower.field, value)
            case Symbol(name):
                return self.symbol(name)
            case Operation(operator):
                return self._operation(operator, [values[a] for a in arguments])
            case Power(exponent):
                return self._power(index, _scalar(values[arguments[0]]), exponent)
            case Call():
                return self.call(index, node, values)
            case MatrixNode(_, columns):
                entries = [_scalar(values[a]) for a in arguments]
                return Matrix(
                    tuple(
                        tuple(entries[start : start + columns])
                        for start in range(0, len(entries), columns)
                    )
                )
            case DerivativeNode(symbol):
                inner = values[arguments[0]]
                if isinstance(inner, Matrix):
                    return inner.rebuilt([self._derivative(e, symbol) for e in inner.entries()])
                return self._derivative(inner, symbol)
            case AtNode(symbol):
                return self._at(graph, arguments[0], symbol, _scalar(values[arguments[1]]))

    def _operation(self, operator: str, arguments: list[Value]) -> Value:
        result = arguments[0]
        if operator == "neg":
            minus_one = number(self.tower.field, -1)
            return self._multiplied(minus_one, result)
        for argument in arguments[1:]:
            if operator == "add":
                result = _added(result, argument)
            elif operator == "mul":
                result = self._multiplied(result, argument)
            else:
                divisor = _scalar(argument)
                one = number(self.tower.field, 1)
                if isinstance(result, Matrix):
                    result = result.scaled(self.nonzero.quotient(one, divisor))
                else:
                    result = self.nonzero.quotient(result, divisor)
        return result

    def _multiplied(self, left: Value, right: Value) -> Value:
        if isinstance(left, Matrix):
            return left.times(right) if isinstance(right, Matrix) else left.scaled(right)
        return right.scaled(left) if isinstance(right, Matrix) else left * right

    def _power(self, index: int, base: Ratio, exponent: Fraction) -> Ratio:
        if exponent.denominator > 1:
            base = self.root(index, base, exponent.denominator)
        if exponent < 0:
            base = self.nonzero.quotient(number(self.tower.field, 1), base)
        return base.power(abs(exponent.numerator))

    def _derivative(self, value: Ratio, symbol: str) -> Ratio:
        if self._replaced:
            raise RejectedError("a derivative inside a substitution is not supported")
        return derivative(self.tower, value, symbol, self.nonzero)

    def _at(self, graph: Graph, inner: int, symbol: str, new: Ratio) -> Value:
        """The inner node evaluated anew where the symbol has another value.

        Not its value with the symbol replaced: sqrt(k^2) is k for k >= 0, and at k - 5 it is not
        k - 5; and (1/k)/(1/k) is 1, but nothing at k = 0.
        """
        if self._depth >= MAXIMUM_ORDER:
            raise RejectedError("substitutions nested too deeply")
        replaced = {**self._replaced, replaceable(self.tower, symbol): new}
        there = Evaluation(self.tower, self.nonzero, replaced, self._depth + 1)
        return there._values(graph, (inner,))[inner]


def _scalar(value: Value) -> Ratio:
    if isinstance(value, Matrix):
        raise RejectedError("a matrix stands where a number is wanted")
    return value


def _added(left: Value, right: Value) -> Value:
    if isinstance(left, Matrix) and isinstance(right, Matrix):
        return left.plus(right)
    return _scalar(left) + _scalar(right)


def replaceable(tower: Tower, symbol: str) -> int:
    """The place of a symbol that may be replaced: a parameter or free symbol, no generators."""
    if tower.field.generators:
        raise RejectedError("substitution is possible only in a tower without generators")
    if symbol not in tower.field.variables():
        raise RejectedError(f"{symbol!r} cannot be replaced: it is not a variable of the tower")
    tower.used.add(symbol)
    return tower.field.variables().index(symbol)


def substituted(value: Ratio, new: Mapping[int, Ratio], nonzero: Nonzero) -> Ratio:
    """``value`` with the variables at some places replaced; denominators are shown nonzero again.

    The denominators must be all that the expression meant by ``value`` divides by, as is so for
    variables and named elements.
    """
    result = _put(value.numerator, new, value)
    for factor, multiplicity in value.factors.items():
        divisor = _put(factor, new, value)
        for _ in range(multiplicity):
            result = nonzero.quotient(result, divisor)
    return result


def _put(value: Polynomial, new: Mapping[int, Ratio], over: Ratio) -> Ratio:
    """Horner in one variable after the other; what was put in is not replaced again."""
    if not new:
        return polynomial(over.field, value)
    (position, replacement), *others = new.items()
    parts = value.by_power(position)
    result = number(over.field, 0)
    for exponent in range(max(parts, default=0), -1, -1):
        result = result * replacement
        if exponent in parts:
            result = result + _put(parts[exponent], dict(others), over)
    return result
