"""How many decimals numbers show: what a claim about rounded values rests on."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.formula import Decimals, Graph
from gainproof.verify.judge.reader.syntax_tree import Branch, children, first_token


def decimals_shown(tree: Branch, graph: Graph) -> Decimals | None:
    """The decimals of `0.50`, `-0.50`, `5.0 \\times 10^{-4}` or `5.0e-4` as printed, those of each
    entry of a matrix of such numbers, row by row; None for anything else. An entry without a point
    shows as many as the fewest of the others: 0 beside 0.25 is no 0.4.
    """
    power = power_of_ten(graph)
    return _of_entries(tree, graph) if power is None else _of_number(tree, power)


def _of_entries(tree: Branch, graph: Graph) -> tuple[int, ...] | None:
    top = graph["nodes"][graph["outputs"]["value"]]
    turned = top[0] == "transpose"
    if turned:
        top = graph["nodes"][top[1]]
    while tree.data != "matrix" and len(inner := children(tree)) == 1:
        (tree,) = inner  # in brackets, or what is transposed
    if top[0] != "matrix" or tree.data != "matrix":
        return None
    rows, columns, *parts = top[1:]
    entries = [entry for row in children(tree) for entry in children(row)]
    powers = [power_of_ten({**graph, "outputs": {"value": part}}) for part in parts]
    shown = [_of_number(e, p) for e, p in zip(entries, powers, strict=True) if p is not None]
    if len(shown) < rows * columns:
        return None
    fewest = min((count for count in shown if count > 0), default=0)
    shown = [count or fewest for count in shown]
    order = [r * columns + c for c in range(columns) for r in range(rows)]
    return tuple(shown[place] for place in (order if turned else range(len(shown))))


def _of_number(tree: Branch, power: int) -> int:
    digits = str(first_token(tree, "NUMBER")).partition("e")[0]
    return len(digits.partition(".")[2]) - power


def power_of_ten(graph: Graph) -> int | None:
    """The exponent of ten behind the digits of a side that is one number; None for others."""
    nodes = graph["nodes"]
    kind, *rest = nodes[graph["outputs"]["value"]]
    if kind == "neg":
        kind, *rest = nodes[rest[0]]
    if kind == "number":
        return 0
    if kind != "mul" or len(rest) != 2 or nodes[rest[0]][0] != "number":
        return None
    kind, *rest = nodes[rest[1]]
    if kind != "pow" or nodes[rest[0]] != ["number", "10"]:
        return None
    exponent = Fraction(rest[1])
    return int(exponent) if exponent.denominator == 1 else None
