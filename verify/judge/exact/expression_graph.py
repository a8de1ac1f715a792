"""Expression graphs (plain data, untrusted) read into expression trees, within limits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.expression import Expr, absolute
from gainproof.verify.judge.exact.graph_matrices import Grid, combined
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Malformed


def rational(text: object, limits: Limits = DEFAULT_LIMITS) -> Fraction:
    """A fraction from "p/q" or "p". Raises Malformed for anything else (floats, spaces)."""
    if not isinstance(text, str) or len(text) > 2 * limits.digits + 2:
        raise Malformed(
            f"wanted a fraction as text with at most {limits.digits} digits, got {str(text)[:40]!r}"
        )
    numerator, slash, denominator = text.partition("/")
    digits = numerator.removeprefix("-")
    for part in (digits, denominator) if slash else (digits,):
        if not (part.isascii() and part.isdigit()) or len(part) > limits.digits:
            raise Malformed(f"wanted a fraction such as '3' or '-1/2', got {text[:40]!r}")
    if slash and int(denominator) == 0:
        raise Malformed(f"wanted a fraction, got denominator zero in {text[:40]!r}")
    return Fraction(int(numerator), int(denominator) if slash else 1)


def read_values(
    graph: Mapping[str, Any], limits: Limits = DEFAULT_LIMITS, *, as_tree: bool = False
) -> dict[str, Expr | Grid]:
    """All outputs of a graph. Raises Malformed.

    With `as_tree` matrices and what is done with them stay nodes, since symbols may stand for
    matrices too.
    """
    nodes, outputs = graph.get("nodes"), graph.get("outputs")
    if (
        not isinstance(nodes, Sequence)
        or isinstance(nodes, str)
        or not isinstance(outputs, Mapping)
    ):
        raise Malformed("wanted a graph with 'nodes' and 'outputs'")
    if len(nodes) > limits.nodes:
        raise Malformed(f"wanted at most {limits.nodes} nodes, got {len(nodes)}")
    read: list[Expr | Grid] = []
    depths: list[int] = []
    for position, node in enumerate(nodes):
        value, depth = _node(node, position, read, depths, limits, as_tree)
        if depth > limits.depth:
            raise Malformed(
                f"wanted nesting of at most {limits.depth}, exceeded at node {position}"
            )
        read.append(value)
        depths.append(depth)
    found = {}
    for name, place in outputs.items():
        if not isinstance(place, int) or isinstance(place, bool) or not 0 <= place < len(read):
            raise Malformed(f"output {name!r}: wanted a node number, got {place!r}")
        found[name] = read[place]
    return found


def read_graph(graph: Mapping[str, Any], limits: Limits = DEFAULT_LIMITS) -> Expr:
    """The output "value" of a graph as an expression. Raises Malformed."""
    value = read_values(graph, limits).get("value")
    if not isinstance(value, Expr):
        raise Malformed("wanted a graph with a single expression as output 'value'")
    return value


def _node(
    node: Any,
    position: int,
    read: list[Expr | Grid],
    depths: list[int],
    limits: Limits,
    as_tree: bool,
) -> tuple[Expr | Grid, int]:
    if (
        not isinstance(node, Sequence)
        or isinstance(node, str)
        or not node
        or not isinstance(node[0], str)
    ):
        raise Malformed(
            f"node {position}: wanted a list that starts with a kind, got {str(node)[:60]}"
        )
    kind, rest = node[0], list(node[1:])
    below: list[int] = []

    def either(place: Any) -> Expr | Grid:
        if not isinstance(place, int) or isinstance(place, bool) or not 0 <= place < position:
            raise Malformed(
                f"node {position}: wanted the number of an earlier node, got {str(place)[:40]!r}"
            )
        below.append(depths[place])
        return read[place]

    def part(place: Any) -> Expr:
        value = either(place)
        if not isinstance(value, Expr):
            raise Malformed(f"node {position}: a matrix stands where a scalar is wanted")
        return value

    def count(least: int, most: int | None = None) -> None:
        if len(rest) < least or (most is not None and len(rest) > most):
            raise Malformed(f"node {position}: wrong number of entries for {kind!r}: {len(rest)}")

    made: Expr | Grid
    match kind:
        case "number":
            count(1, 1)
            made = Expr("number", rational(rest[0], limits), ())
        case "symbol":
            count(1, 1)
            made = Expr("symbol", _text(rest[0], position), ())
        case "add" | "mul":
            count(2)
            made = combined(kind, [either(p) for p in rest])
        case "div":
            count(2, 2)
            made = Expr(kind, None, (part(rest[0]), part(rest[1])))
        case "neg":
            count(1, 1)
            made = combined(kind, [either(rest[0])])
        case "pow":
            count(2, 2)
            exponent = rational(rest[1], limits)
            if max(abs(exponent.numerator), exponent.denominator) > limits.exponent:
                raise Malformed(
                    f"node {position}: wanted exponents up to {limits.exponent}, got {exponent}"
                )
            made = Expr(kind, exponent, (part(rest[0]),))
        case "call":
            count(1 if rest == ["pi"] else 2)
            name, arguments = _text(rest[0], position), tuple(part(p) for p in rest[1:])
            made = (
                absolute(arguments[0])
                if (name, len(arguments)) == ("abs", 1) and not as_tree
                else Expr(kind, name, arguments)
            )
        case "derivative":
            count(2, 2)
            made = Expr(kind, _text(rest[1], position), (part(rest[0]),))
        case "at":
            count(3, 3)
            made = Expr(kind, _text(rest[1], position), (part(rest[0]), part(rest[2])))
        case "matrix":
            count(3)
            rows = _matrix(rest, position, part)
            flat = tuple(entry for row in rows for entry in row)
            made = Expr(kind, f"{len(rows)} {len(rows[0])}", flat) if as_tree else rows
        case "transpose" | "inverse" if as_tree:
            count(1, 1)
            made = Expr(kind, None, (part(rest[0]),))
        case "kronecker" if as_tree:
            count(2, 2)
            made = Expr(kind, None, (part(rest[0]), part(rest[1])))
        case _:
            raise Malformed(f"node {position}: unknown kind {kind[:40]!r}")
    return made, 1 + max(below, default=0)


def _text(name: Any, position: int) -> str:
    if not isinstance(name, str) or not 0 < len(name) <= 200:
        raise Malformed(f"node {position}: wanted a name, got {str(name)[:40]!r}")
    return name


def _matrix(rest: list[Any], position: int, part: Any) -> Grid:
    rows, columns = rest[0], rest[1]
    shaped = all(isinstance(n, int) and 1 <= n <= 16 for n in (rows, columns))
    if not shaped or rows * columns != len(rest) - 2:
        raise Malformed(f"node {position}: wanted rows, columns and that many entries in a matrix")
    entries = [part(p) for p in rest[2:]]
    return tuple(tuple(entries[r * columns : (r + 1) * columns]) for r in range(rows))
