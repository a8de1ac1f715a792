"""SymPy expressions as expression graphs, the plain data that crosses borders.

A graph is {"nodes": [...], "outputs": {name: node number}}; a node is ["number", "p/q"],
["symbol", name], ["add", i, j, ...], ["mul", i, j, ...], ["div", i, j], ["neg", i],
["pow", i, "p/q"], ["call", name, i, ...], ["matrix", rows, columns, i, ...],
["derivative", i, name] or ["at", i, name, j], and refers only to earlier nodes.
Equal nodes are stored once.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

import sympy as sp

Graph = dict[str, Any]


def real(name: str) -> sp.Symbol:
    """The real symbol of that name; positivity stays in the domain (see `quantity`)."""
    return sp.Symbol(name, real=True)


def column(*entries: sp.Expr | int) -> sp.ImmutableDenseMatrix:
    """A column vector."""
    return sp.ImmutableDenseMatrix([[entry] for entry in entries])


class ExpressionError(ValueError):
    """An expression that the graph format cannot hold."""


def graph_of(outputs: Mapping[str, Any] | Any) -> Graph:
    """The graph of named SymPy expressions, or of one expression under the name "value"."""
    named = outputs if isinstance(outputs, Mapping) else {"value": outputs}
    writer = _Writer()
    numbers = {name: writer.write(sp.sympify(value)) for name, value in named.items()}
    return {"nodes": writer.nodes, "outputs": numbers}


class _Writer:
    def __init__(self) -> None:
        self.nodes: list[list[Any]] = []
        self._known: dict[tuple[Any, ...], int] = {}

    def _put(self, *node: Any) -> int:
        if node not in self._known:
            self._known[node] = len(self.nodes)
            self.nodes.append(list(node))
        return self._known[node]

    def write(self, value: Any) -> int:
        if isinstance(value, sp.MatrixBase):
            entries = [self.write(entry) for entry in value.flat()]
            return self._put("matrix", value.rows, value.cols, *entries)
        if isinstance(value, sp.Rational):
            return self._put("number", str(value))
        if isinstance(value, sp.Symbol):
            return self._put("symbol", value.name)
        if isinstance(value, (sp.MatMul, sp.MatAdd)):
            children = [self.write(_explicit(part)) for part in value.args]
            return self._put("mul" if isinstance(value, sp.MatMul) else "add", *children)
        if isinstance(value, sp.Add):
            return self._put("add", *[self.write(part) for part in value.args])
        if isinstance(value, sp.Mul):
            return self._product(value)
        if isinstance(value, sp.Pow):
            return self._power(value)
        if isinstance(value, sp.Derivative):
            number = self.write(value.expr)
            for variable in cast("tuple[Any, ...]", value.variables):
                number = self._put("derivative", number, variable.name)
            return number
        if isinstance(value, sp.Subs):
            number, later = self.write(value.expr), set(value.variables)
            for name, point in zip(value.variables, value.point, strict=True):
                later.remove(name)
                if later & point.free_symbols:  # all at once is not one after the other
                    raise ExpressionError(f"a value free of {later} is wanted, {point} came")
                number = self._put("at", number, name.name, self.write(point))
            return number
        raise ExpressionError(f"no node for {type(value).__name__}: {value}")

    def _product(self, value: sp.Mul) -> int:
        top: list[int] = []
        bottom: list[int] = []
        for factor in value.args:
            if isinstance(factor, sp.Pow) and factor.exp == -1:
                bottom.append(self.write(factor.base))
            elif factor != -1:
                top.append(self.write(factor))
        number = self._fold(top) if top else self._put("number", "1")
        if bottom:
            number = self._put("div", number, self._fold(bottom))
        return self._put("neg", number) if -1 in value.args else number

    def _fold(self, numbers: list[int]) -> int:
        return numbers[0] if len(numbers) == 1 else self._put("mul", *numbers)

    def _power(self, value: sp.Pow) -> int:
        base, exponent = value.args
        if not isinstance(exponent, sp.Rational):
            raise ExpressionError(f"rational exponents only are wanted, {value} came")
        if exponent == -1:
            return self._put("div", self._put("number", "1"), self.write(base))
        return self._put("pow", self.write(base), str(exponent))


def _explicit(value: Any) -> Any:
    return sp.ImmutableDenseMatrix(value) if isinstance(value, sp.MatrixBase) else value
