"""Polynomials over inputs and parts as the graph that is printed.

Its names: `part_1` is the node of a part, `under_1` the divisor of which `over_1` is one over.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

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
        self.legs: dict[int, set[int]] = {}
        for part in parts.known.values():
            self._part(part.symbol.name, part.function, part.arguments)

    def _part(self, name: str, function: str, arguments: tuple[sp.Expr, ...]) -> None:
        nodes = [self.node(argument) for argument in arguments]
        if function == OVER:
            self.divisors[name] = nodes[0]
        elif function == SQRT:
            self.names[name] = root = self.builder.sqrt(nodes[0])
            squares = (t.base for t in sp.Add.make_args(arguments[0]) if t.is_Pow and t.exp == 2)
            sides = (self.node(side).number for base in squares for side in (base, -base))
            self.legs[root.number] = set(sides)
        else:
            self.names[name] = self.builder.call(function, *nodes)

    def node(self, value: sp.Expr, in_pairs: bool = False) -> Node:
        """The node of a polynomial; `in_pairs`: products are divided factor by factor."""
        if isinstance(value, sp.Rational):
            return self.builder.number(str(value))
        if isinstance(value, sp.Symbol):
            if value.name in self.divisors:
                return 1 / self.divisors[value.name]
            return self.names.get(value.name) or self.builder.symbol(value.name)
        if isinstance(value, sp.Add):
            first, *others = (self.node(term, in_pairs) for term in value.args)
            for other in others:
                first = self.builder.operation("add", first, other)
            return first
        return self._product(value, in_pairs)

    def _product(self, value: sp.Expr, in_pairs: bool) -> Node:
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
            factor_node = self.node(base, in_pairs) if divisor is None else divisor
            if in_pairs:
                chosen += [factor_node] * int(power)
            else:
                chosen.append(self._to_the(factor_node, int(power)))
        if in_pairs and over and under:
            return self._in_pairs(over, under, negative)
        product = self._multiplied(over) if over else self.builder.number(1)
        product = product / self._multiplied(under) if under else product
        return -product if negative else product

    def _in_pairs(self, over: list[Node], under: list[Node], negative: bool) -> Node:
        """Each divisor under a factor; those that are left divide one after another."""
        factors, divisors, pairs = list(over), list(under), list[Node]()
        for divisor in under:  # legs first: the quotient of one with its root is at most 1
            legs = self.legs.get(divisor.number, set())
            leg = next((each for each in factors if each.number in legs), None)
            if leg is not None:
                factors.remove(leg)
                divisors.remove(divisor)
                pairs.append(leg / divisor)
        for divisor in divisors:
            if factors:
                pairs.append(factors.pop(0) / divisor)
            else:
                pairs[-1] = pairs[-1] / divisor
        product = self._multiplied([*pairs, *factors])
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


def graph_of_outputs(
    outputs: Mapping[str, sp.Expr], parts: Parts, in_pairs: Collection[str] = ()
) -> Graph:
    """The graph of polynomials that `parts` has read; `in_pairs`: outputs whose products are
    divided factor by factor.
    """
    writing = Writing(GraphBuilder(), parts)
    ends = {name: writing.node(value, name in in_pairs) for name, value in outputs.items()}
    unders = {name.replace(OVER, UNDER): node for name, node in writing.divisors.items()}
    return writing.builder.graph(ends, {**writing.names, **unders})
