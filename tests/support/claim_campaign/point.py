"""The value of a formula at a point: definitions and functions of the source put in, numbers from
multiprecision.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from typing import Any

import mpmath
from mutation.arithmetic import Misshapen, NoValue, plus, product, real, root, times
from mutation.tree import Tree

DIGITS = 90
STEP = mpmath.mpf(10) ** -25
DOUBT = mpmath.mpf(10) ** -40
"""Estimated error of an integral beyond which it has no value here."""
MOST_TERMS = 2000
FUNCTIONS: Mapping[str, Callable[[Any], Any]] = {
    name: getattr(mpmath, name)
    for name in ("sin", "cos", "tan", "exp", "log", "atan", "asin", "acos", "sinh", "cosh", "tanh")
}


class NotCovered(Exception):
    """A construct that this evaluator does not know."""


@dataclass(frozen=True)
class Definition:
    """`body` may use the names in `arguments`."""

    arguments: tuple[str, ...]
    body: Tree


@dataclass(frozen=True)
class Point:
    """Values of all symbols that are not defined by others. `moved` is the point with one of them
    changed and, where it is a quantity of a model, all others that depend on it.
    """

    values: Mapping[str, Any]
    definitions: Mapping[str, Definition] = field(default_factory=dict)
    moved: Callable[[str, Any], Point] | None = None

    def value(self, tree: Tree, digits: int = DIGITS) -> Any:
        """The number, or matrix as rows, of a tree. Raises NoValue, Misshapen, NotCovered."""
        with mpmath.workdps(digits):
            return self._value(tree, {})

    def _symbol(self, name: str, local: Mapping[str, Any]) -> Any:
        if name in local:
            return local[name]
        if name in self.values:
            found = self.values[name]
            if found is None:
                raise NoValue(name)
            return found
        definition = self.definitions.get(name)
        if definition is None or definition.arguments:
            raise NotCovered(name)
        return self._value(definition.body, local)  # an abbreviation: bound names reach into it

    def _value(self, tree: Tree, local: Mapping[str, Any]) -> Any:
        match tree[0]:
            case "number":
                return real(tree[1])
            case "symbol":
                return self._symbol(tree[1], local)
            case "matrix":
                rows, columns = tree[1], tree[2]
                entries = [self._value(part, local) for part in tree[3:]]
                return _joined([entries[r * columns : (r + 1) * columns] for r in range(rows)])
            case "transpose":
                inner = self._value(tree[1], local)
                return [list(row) for row in zip(*inner, strict=True)]
            case "inverse":
                return _inverse(self._value(tree[1], local))
            case "derivative":
                return self._slope(tree[1], tree[2], local)
            case "at":
                return self._at(tree[1], tree[2], self._value(tree[3], local), local)
            case "call":
                return self._call(tree, local)
            case "pow":
                return root(self._value(tree[1], local), tree[2])
            case "neg":
                return times(-1, self._value(tree[1], local))
            case "div":
                top, bottom = (self._value(part, local) for part in tree[1:])
                if isinstance(bottom, list) or bottom == 0:
                    raise NoValue("division")
                return times(1 / bottom, top)
            case "add" | "mul":
                total = self._value(tree[1], local)
                for part in tree[2:]:
                    other = self._value(part, local)
                    total = plus(total, other) if tree[0] == "add" else product(total, other)
                return total
        raise NotCovered(str(tree[0]))

    def _call(self, tree: Tree, local: Mapping[str, Any]) -> Any:
        name, arguments = tree[1], tree[2:]
        if name == "sum":
            return self._sum(arguments, local)
        if name == "integral":
            return self._integral(arguments, local)
        values = [self._value(part, local) for part in arguments]
        if name in self.definitions:
            definition = self.definitions[name]
            bound = {**local, **dict(zip(definition.arguments, values, strict=True))}
            return self._value(definition.body, bound)
        if name == "abs":
            return abs(values[0])
        if name == "power":
            return _power(values[0], values[1])
        if name not in FUNCTIONS:
            raise NotCovered(name)
        try:
            found = FUNCTIONS[name](values[0])
        except (ValueError, ZeroDivisionError):
            raise NoValue(name) from None
        if isinstance(found, mpmath.mpc) or not mpmath.isfinite(found):
            raise NoValue(name)
        return found

    def _sum(self, arguments: Tree, local: Mapping[str, Any]) -> Any:
        low, high = (self._value(part, local) for part in arguments[2:])
        if low != int(low) or high != int(high) or not 0 <= high - low < MOST_TERMS:
            raise NotCovered("sum")
        index = arguments[1][1]
        total = real(0)
        for n in range(int(low), int(high) + 1):
            total = plus(total, self._value(arguments[0], {**local, index: real(n)}))
        return total

    def _integral(self, arguments: Tree, local: Mapping[str, Any]) -> Any:
        low, high = (self._value(part, local) for part in arguments[2:])
        name = arguments[1][1]
        found, error = mpmath.quad(
            lambda x: self._value(arguments[0], {**local, name: x}), [low, high], error=True
        )
        if error > DOUBT * max(1, abs(found)):
            raise NoValue("integral")
        return found

    def _at(self, tree: Tree, name: str, value: Any, local: Mapping[str, Any]) -> Any:
        if name in local:
            return self._value(tree, {**local, name: value})
        if self.moved is None or name not in self.values:
            raise NotCovered("at")
        return self.moved(name, value)._value(tree, local)

    def _slope(self, tree: Tree, name: str, local: Mapping[str, Any]) -> Any:
        """A central difference, good to about forty digits."""
        here = self._symbol(name, local)
        step = STEP * max(abs(here), 1)
        high, low = (self._at(tree, name, here + move, local) for move in (step, -step))
        return times(1 / (2 * step), plus(high, times(-1, low)))


def _joined(rows: list[list[Any]]) -> list[list[Any]]:
    """A matrix whose entries may be matrices, such as a covariance of blocks."""
    found: list[list[Any]] = []
    for row in rows:
        blocks = [part if isinstance(part, list) else [[part]] for part in row]
        if len({len(block) for block in blocks}) != 1:
            raise Misshapen("blocks")
        found += [[*chain(*lines)] for lines in zip(*blocks, strict=True)]
    return found


def _power(base: Any, exponent: Any) -> Any:
    if isinstance(base, list):
        raise Misshapen("power of a matrix")
    if base == 0 and exponent <= 0:
        raise NoValue("power")
    if base < 0 and exponent != int(exponent):
        raise NoValue("power")
    return base ** (int(exponent) if exponent == int(exponent) else exponent)


def _inverse(matrix: Any) -> Any:
    if not isinstance(matrix, list):
        return root(matrix, Fraction(-1))
    if len(matrix) != len(matrix[0]):
        raise Misshapen("inverse")
    try:
        found = mpmath.matrix(matrix) ** -1
    except ZeroDivisionError:
        raise NoValue("inverse") from None
    return [[found[r, c] for c in range(len(matrix))] for r in range(len(matrix))]
