"""Polynomials over inputs and parts as the graph that is printed.

Its names: `part_1` is the node of a part, `under_1` the divisor of which `over_1` is one over.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.own_expressions.parts import OVER, SQRT, Parts
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

UNDER = "under"


class Writing:
    """Writes polynomials into a builder in the order in which SymPy holds them."""

    def __init__(self, builder: GraphBuilder, parts: Parts) -> None:
        self.builder = builder
        self.names: dict[str, Node] = {}
        self.divisors: dict[str, Node] = {}
        for part in parts.known.values():
            self._part(part.symbol.name, part.function, part.arguments)

    def _part(self, name: str, function: str, arguments: tuple[sp.Expr, ...]) -> None:
        nodes = [self.node(argument) for argument in arguments]
        if function == OVER:
            self.divisors[name] = nodes[0]
        elif function == SQRT:
            self.names[name] = self.builder.sqrt(nodes[0])
        else:
            self.names[name] = self.builder.call(function, *nodes)

    def node(self, value: sp.Expr) -> Node:
        """The node of a polynomial."""
        if isinstance(value, sp.Rational):
            return self.builder.number(str(value))
        if isinstance(value, sp.Symbol):
            if value.name in self.divisors:
                return 1 / self.divisors[value.name]
            return self.names.get(value.name) or self.builder.symbol(value.name)
        if isinstance(value, sp.Add):
            first, *others = map(self.node, value.args)
            for other in others:
                first = self.builder.operation("add", first, other)
            return first
        return self._product(value)

    def _product(self, value: sp.Expr) -> Node:
        over: list[Node] = []
        under: list[Node] = []
        negative = False
        for factor in sp.Mul.make_args(value):
            if isinstance(factor, sp.Rational):
                negative = factor < 0
                over += [self.builder.number(abs(int(factor.p)))] if abs(factor.p) != 1 else []
                under += [self.builder.number(int(factor.q))] if factor.q != 1 else []
                continue
            base, power = factor.as_base_exp()
            divisor = self.divisors.get(base.name) if isinstance(base, sp.Symbol) else None
            chosen = over if divisor is None else under
            chosen.append(self._to_the(self.node(base) if divisor is None else divisor, int(power)))
        product = self._multiplied(over) if over else self.builder.number(1)
        product = product / self._multiplied(under) if under else product
        return -product if negative else product

    def _multiplied(self, factors: list[Node]) -> Node:
        first, *others = factors
        for other in others:
            first = first * other
        return first

    def _to_the(self, base: Node, power: int) -> Node:
        """By squares, from the highest binary digit on."""
        result = base
        for digit in bin(power)[3:]:
            result = result * result
            result = result * base if digit == "1" else result
        return result


def graph_of_outputs(outputs: Mapping[str, sp.Expr], parts: Parts) -> Graph:
    """The graph of polynomials that `parts` has read."""
    writing = Writing(GraphBuilder(), parts)
    ends = {name: writing.node(value) for name, value in outputs.items()}
    unders = {name.replace(OVER, UNDER): node for name, node in writing.divisors.items()}
    return writing.builder.graph(ends, {**writing.names, **unders})
