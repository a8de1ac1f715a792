"""Expressions of a certificate as trees, entry by entry where they are matrices."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any


class NotExportedError(Exception):
    """A statement that is not handed to the tools, with the reason."""


@dataclass(frozen=True, eq=False)
class Tree:
    """`number` (value), `symbol` (name), `add`, `mul`, `div`, or `pow` (integer exponent)."""

    operation: str
    parts: tuple[Tree, ...] = ()
    value: Fraction = Fraction(0)
    name: str = ""
    exponent: int = 0

    def __add__(self, other: Tree) -> Tree:
        return Tree("add", (self, other))

    def __mul__(self, other: Tree) -> Tree:
        return Tree("mul", (self, other))

    def __sub__(self, other: Tree) -> Tree:
        return self + number(-1) * other

    def symbols(self) -> set[str]:
        """Names that occur."""
        return {node.name for node in self.nodes() if node.operation == "symbol"}

    def nodes(self) -> Iterable[Tree]:
        """Every tree in it once, parts before the whole."""
        seen: dict[int, Tree] = {}
        stack: list[tuple[Tree, bool]] = [(self, False)]
        while stack:
            tree, entered = stack.pop()
            if entered:
                seen[id(tree)] = tree
            elif id(tree) not in seen:
                stack.append((tree, True))
                stack.extend((part, False) for part in tree.parts)
        return seen.values()


Matrix = tuple[tuple[Tree, ...], ...]


def number(value: int | str | Fraction) -> Tree:
    return Tree("number", value=Fraction(value))


def symbol(name: str) -> Tree:
    return Tree("symbol", name=name)


def total(terms: Sequence[Tree]) -> Tree:
    """The sum; 0 of none."""
    return Tree("add", tuple(terms)) if len(terms) > 1 else next(iter(terms), number(0))


def polynomial(terms: Sequence[Any], names: Sequence[str]) -> Tree:
    """A certificate's polynomial over these variables."""
    return total([_term(coefficient, powers, names) for coefficient, powers in terms])


def _term(coefficient: str, powers: Sequence[int], names: Sequence[str]) -> Tree:
    factors = [
        symbol(name) if power == 1 else Tree("pow", (symbol(name),), exponent=power)
        for name, power in zip(names, powers, strict=False)
        if power
    ]
    if coefficient != "1" or not factors:
        factors.insert(0, number(coefficient))
    return Tree("mul", tuple(factors)) if len(factors) > 1 else factors[0]


def fraction(value: Mapping[str, Any], names: Sequence[str]) -> Tree:
    """A certificate's fraction."""
    above = polynomial(value["num"], names)
    return Tree("div", (above, polynomial(value["den"], names)))


def product(left: Matrix, right: Matrix) -> Matrix:
    columns = tuple(zip(*right, strict=True))
    return tuple(
        tuple(total([a * b for a, b in zip(row, column, strict=True)]) for column in columns)
        for row in left
    )


def transposed(matrix: Matrix) -> Matrix:
    return tuple(zip(*matrix, strict=True))


def graph(data: Mapping[str, Any]) -> Matrix:
    """The value of a claim's graph as a matrix of trees; NotExportedError for what they lack."""
    values: list[Matrix] = []
    for node in data["nodes"]:
        values.append(_node(node, values))
    end: int = data["outputs"]["value"]
    return values[end]


def _node(node: Sequence[Any], values: Sequence[Matrix]) -> Matrix:
    match node:
        case ["number", value]:
            return ((number(value),),)
        case ["symbol", name]:
            return ((symbol(name),),)
        case ["add", *parts]:
            rows = [values[part] for part in parts]
            return tuple(
                tuple(total(entries) for entries in zip(*row, strict=True))
                for row in zip(*rows, strict=True)
            )
        case ["mul", *parts]:
            result = values[int(parts[0])]
            for part in parts[1:]:
                result = _times(result, values[part])
            return result
        case ["neg", part]:
            return _times(((number(-1),),), values[int(part)])
        case ["div", over, under]:
            below = _scalar(values[under])
            return tuple(
                tuple(Tree("div", (entry, below)) for entry in row) for row in values[over]
            )
        case ["pow", part, power] if "/" not in power:
            return ((Tree("pow", (_scalar(values[part]),), exponent=int(power)),),)
        case ["matrix", rows, columns, *parts]:
            entries = [_scalar(values[part]) for part in parts]
            return tuple(tuple(entries[i * columns : (i + 1) * columns]) for i in range(rows))
    what = {"pow": "roots", "call": "calls", "derivative": "derivatives", "at": "substitutions"}
    raise NotExportedError(what.get(node[0], str(node[0])))


def _times(left: Matrix, right: Matrix) -> Matrix:
    if len(left) == len(left[0]) == 1:
        return tuple(tuple(left[0][0] * entry for entry in row) for row in right)
    if len(right) == len(right[0]) == 1:
        return tuple(tuple(entry * right[0][0] for entry in row) for row in left)
    return product(left, right)


def _scalar(matrix: Matrix) -> Tree:
    if len(matrix) != 1 or len(matrix[0]) != 1:
        raise NotExportedError("inverses of matrices")
    return matrix[0][0]


def one(matrix: Matrix) -> Tree:
    """The entry of a matrix of one."""
    ((entry,),) = matrix
    return entry
