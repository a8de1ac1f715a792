"""Whether a statement is true at sampled points, in 60-digit floating point.

An evaluator of its own for tests: it takes towers, graphs and models from the plain data and
shares nothing with the checker. It can refute; it never proves.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp

Data = dict[str, Any]
Values = Mapping[str, Any]

DIGITS = 60
NEAR = mp.mpf(10) ** -25


def _number(text: str) -> Any:
    above, _, below = text.partition("/")
    return mp.mpf(int(above)) / int(below or 1)


def _polynomial(terms: list[Any], values: list[Any]) -> Any:
    return mp.fsum(
        _number(c) * mp.fprod(v**e for v, e in zip(values, exponents, strict=False))
        for c, exponents in terms
    )


class Names(dict[str, Any]):
    """Every name of a tower at one point; elements are computed when they are asked for."""

    def __init__(self, tower: Data, place: Values) -> None:
        super().__init__(place)
        self._elements = tower["elements"]
        self._ordered = [place[p["symbol"]] for p in tower["parameters"]]
        for generator in tower["generators"]:
            base = _polynomial(generator["radicand"], self._ordered)
            assert base > 0
            self._ordered.append(mp.root(base, generator["power"]))
            self[generator["symbol"]] = self._ordered[-1]

    def __missing__(self, name: str) -> Any:
        fraction = self._elements[name]
        below = _polynomial(fraction["den"], self._ordered)
        return _polynomial(fraction["num"], self._ordered) / below


def point(tower: Data, generator: random.Random, size: float = 2.0) -> dict[str, Any]:
    """A random point of the parameters' domain."""
    found = {}
    for parameter in tower["parameters"]:
        distance = mp.mpf(10) ** generator.uniform(-size, size)
        found[parameter["symbol"]] = _number(parameter.get("from", "0")) + distance
    return found


class Truth:
    """Evaluates the graphs of one tower as functions of its parameters."""

    def __init__(self, tower: Data) -> None:
        self.tower = tower

    def names(self, place: Values) -> Names:
        """All names at a point; further names of the point (free symbols) are kept."""
        return Names(self.tower, place)

    def value(self, graph: Data, place: Values, output: str = "value") -> Any:
        """An output of a graph at a point."""
        return self._node(graph["nodes"], graph["outputs"][output], place, self.names(place))

    def _node(self, nodes: list[Any], index: int, place: Values, names: Values) -> Any:
        kind, *rest = nodes[index]

        def at(number: int) -> Any:
            return self._node(nodes, number, place, names)

        if kind == "number":
            return _number(rest[0])
        if kind == "symbol":
            return names[rest[0]]
        if kind == "add":
            total = at(rest[0])
            for number in rest[1:]:
                total = total + at(number)
            return total
        if kind == "mul":
            product = at(rest[0])
            for number in rest[1:]:
                product = product * at(number)
            return product
        if kind == "div":
            return at(rest[0]) / at(rest[1])
        if kind == "neg":
            return -at(rest[0])
        if kind == "pow":
            return self._power(at(rest[0]), rest[1])
        if kind == "call" and rest[0] == "abs":
            return abs(at(rest[1]))
        if kind == "call":
            return at(rest[3]) if at(rest[1]) < at(rest[2]) else at(rest[4])
        if kind == "matrix":
            rows, columns, *entries = rest
            return mp.matrix(
                [[at(entries[i * columns + j]) for j in range(columns)] for i in range(rows)]
            )
        if kind == "at":
            moved = {**place, rest[1]: at(rest[2])}
            return self._node(nodes, rest[0], moved, self.names(moved))
        return self._derivative(nodes, rest[0], rest[1], place)

    def _power(self, base: Any, exponent: str) -> Any:
        above, _, below = exponent.partition("/")
        if below:
            assert base >= -NEAR, "a root of a negative number"
            return mp.root(abs(base), int(below)) ** int(above)
        return base ** int(above)

    def _derivative(self, nodes: list[Any], index: int, symbol: str, place: Values) -> Any:
        """By a parameter, or by a name of one parameter alone (central difference)."""
        variable = self.moving(symbol, place)
        rate = self._slope(
            lambda there: self._node(nodes, index, there, self.names(there)), variable, place
        )
        if symbol in place:
            return rate
        return rate / self._slope(lambda there: self.names(there)[symbol], variable, place)

    def moving(self, symbol: str, place: Values) -> str:
        """The parameter (or free symbol) behind a name: itself, or the one that moves it."""
        if symbol in place:
            return symbol
        found = [
            name
            for name in place
            if abs(self._slope(lambda there: self.names(there)[symbol], name, place)) > NEAR
        ]
        assert len(found) == 1, "a name that depends on one parameter alone is wanted"
        return found[0]

    def _slope(self, function: Callable[[Values], Any], variable: str, place: Values) -> Any:
        step = mp.mpf(10) ** -20 * max(1, abs(place[variable]))
        up, down = ({**place, variable: place[variable] + sign * step} for sign in (1, -1))
        return (function(up) - function(down)) / (2 * step)


def agree(left: Any, right: Any, tolerance: Any = NEAR) -> bool:
    """Whether two numbers or matrices are the same, relative to their size."""
    if isinstance(left, mp.matrix) or isinstance(right, mp.matrix):
        if not (isinstance(left, mp.matrix) and isinstance(right, mp.matrix)):
            return False
        return (left.rows, left.cols) == (right.rows, right.cols) and all(
            agree(a, b, tolerance) for a, b in zip(list(left), list(right), strict=True)
        )
    return bool(abs(left - right) <= tolerance * (1 + abs(left) + abs(right)))
