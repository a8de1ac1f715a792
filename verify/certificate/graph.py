"""Expression graphs: the shape of a claim or a kernel, checked before anything is computed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import (
    MAXIMUM_NODES,
    MAXIMUM_ORDER,
    MAXIMUM_POWER,
    MAXIMUM_ROOT,
    MalformedError,
)


@dataclass(frozen=True, slots=True)
class Number:
    """A rational number."""

    value: Fraction
    arguments: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Symbol:
    """A named quantity."""

    name: str
    arguments: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Operation:
    """add, mul, div or neg of earlier nodes."""

    operator: str
    arguments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Power:
    """A rational power; a fractional one is the positive root."""

    exponent: Fraction
    arguments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Call:
    """A named function of earlier nodes."""

    function: str
    arguments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class MatrixNode:
    """A matrix, row by row."""

    rows: int
    columns: int
    arguments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class DerivativeNode:
    """The total derivative by a symbol."""

    symbol: str
    arguments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AtNode:
    """The first argument with a symbol replaced by the second."""

    symbol: str
    arguments: tuple[int, ...]


Skipped: TypeAlias = tuple[int, ...]

Node: TypeAlias = Number | Symbol | Operation | Power | Call | MatrixNode | DerivativeNode | AtNode

_ARITY = {"abs": 1, "select": 4, "unknown": 2, "fixed_point": 3, "near_cbrt": 1}
_FIXED = (("div", 2), ("neg", 1))


@dataclass(frozen=True, slots=True)
class Graph:
    """Nodes, each built from earlier ones, and the numbers of the named outputs."""

    nodes: tuple[Node, ...]
    outputs: Mapping[str, int]

    def reachable(self, outputs: Iterable[int], skipped: Mapping[int, Skipped]) -> list[int]:
        """The nodes that these outputs depend on, ascending.

        ``skipped`` names, for some nodes, the positions of arguments that are not evaluated.
        """
        wanted = set(outputs)
        for number in range(len(self.nodes) - 1, -1, -1):
            if number in wanted:
                arguments = self.nodes[number].arguments
                leave = skipped.get(number, ())
                wanted.update(a for i, a in enumerate(arguments) if i not in leave)
        return sorted(wanted)


def read_graph(value: Plain, place: str) -> Graph:
    """A graph with any outputs; every node must serve one of them."""
    fields = schema.record(value, ("nodes", "outputs"), place)
    entries = schema.items(fields["nodes"], f"{place}.nodes")
    if len(entries) > MAXIMUM_NODES:
        raise MalformedError(f"{place}: more than {MAXIMUM_NODES} nodes")
    nodes = tuple(
        _node(entry, number, f"{place}.nodes[{number}]") for number, entry in enumerate(entries)
    )
    outputs = {
        schema.name(key, f"{place}.outputs"): schema.integer(
            node, 0, len(nodes) - 1, f"{place}.outputs.{key}"
        )
        for key, node in schema.table(fields["outputs"], f"{place}.outputs").items()
    }
    graph = Graph(nodes, outputs)
    reached = graph.reachable(outputs.values(), {})
    if len(reached) != len(nodes) or not nodes:
        idle = sorted(set(range(len(nodes))) - set(reached))
        raise MalformedError(f"{place}: nodes {idle[:5]} serve no output")
    return graph


def read_expression(value: Plain, place: str) -> Graph:
    """A graph with the single output "value"."""
    graph = read_graph(value, place)
    if tuple(graph.outputs) != ("value",):
        raise MalformedError(f"{place}: a graph with the single output 'value' is wanted")
    return graph


def _node(value: Plain, number: int, place: str) -> Node:
    entry = schema.items(value, place)
    if not entry or not isinstance(entry[0], str):
        raise MalformedError(f"{place}: a node starts with its kind")
    kind, rest = entry[0], entry[1:]
    if kind == "number" and len(rest) == 1:
        return Number(schema.number(rest[0], place))
    if kind == "symbol" and len(rest) == 1:
        return Symbol(schema.name(rest[0], place))
    if (kind in ("add", "mul") and len(rest) >= 2) or (kind, len(rest)) in _FIXED:
        return Operation(kind, _earlier(rest, number, place))
    if kind == "pow" and len(rest) == 2:
        return Power(_exponent(rest[1], place), _earlier(rest[:1], number, place))
    if kind == "call" and rest:
        function = schema.name(rest[0], place)
        if _ARITY.get(function) != len(rest) - 1:
            raise MalformedError(f"{place}: {function!r} of {len(rest) - 1} arguments is not known")
        return Call(function, _earlier(rest[1:], number, place))
    if kind == "matrix" and len(rest) >= 2:
        rows = schema.integer(rest[0], 1, MAXIMUM_ORDER, place)
        columns = schema.integer(rest[1], 1, MAXIMUM_ORDER, place)
        if len(rest) != 2 + rows * columns:
            raise MalformedError(f"{place}: {rows * columns} entries wanted")
        return MatrixNode(rows, columns, _earlier(rest[2:], number, place))
    if kind == "derivative" and len(rest) == 2:
        return DerivativeNode(schema.name(rest[1], place), _earlier(rest[:1], number, place))
    if kind == "at" and len(rest) == 3:
        return AtNode(schema.name(rest[1], place), _earlier([rest[0], rest[2]], number, place))
    raise MalformedError(f"{place}: {kind[:20]!r} with {len(rest)} entries is not a node")


def _earlier(entries: list[Plain], number: int, place: str) -> tuple[int, ...]:
    if number == 0:
        raise MalformedError(f"{place}: the first node cannot refer to an earlier one")
    return tuple(schema.integer(entry, 0, number - 1, place) for entry in entries)


def _exponent(value: Plain, place: str) -> Fraction:
    exponent = schema.number(value, place)
    if abs(exponent.numerator) > MAXIMUM_POWER or exponent.denominator > MAXIMUM_ROOT:
        raise MalformedError(f"{place}: the exponent {value} is out of bounds")
    return exponent
