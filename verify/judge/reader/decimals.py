"""How many decimals a number shows: what a claim about a rounded value rests on."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.tree import Branch, first_token


def decimals_shown(tree: Branch, graph: Graph) -> int | None:
    """The decimals of `0.50`, `-0.50`, `5.0 \\times 10^{-4}` or `5.0e-4` as printed; None for
    anything that is not one number.
    """
    power = power_of_ten(graph)
    if power is None:
        return None
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
