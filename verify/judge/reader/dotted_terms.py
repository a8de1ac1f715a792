"""Dots between entries, terms or factors that differ in one index only, and are declared so.

`(b_1, \\cdots, b_n)` is read where `b_i` is declared with a whole number i, `\\omega(1) + \\cdots +
\\omega(n)` where `\\omega` is a function of a whole number; the first and the last entry say from
where to where.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from gainproof.verify.judge.reader.index_patterns import Pattern, common_pattern, instance
from gainproof.verify.judge.reader.syntax_tree import Branch, children, sole, tokens

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.graph_building import Builder
    from gainproof.verify.judge.reader.slash import Part


def has_dots(trees: Sequence[Branch]) -> bool:
    """Whether one of the trees is nothing but dots."""
    return any(sole(tree).data == "dots" for tree in trees)


def dotted_sum(builder: Builder, tree: Branch) -> int:
    """`a_1 + a_2 + \\cdots + a_n`."""
    terms = children(tree)
    if tree.data == "minus_sum" or tokens(tree, "MINUS") or len(terms) == 1:
        raise builder.error("dots amid a sum with a minus sign: write \\sum", tree)
    return _dotted(builder, "sum", terms, tree)


def dotted_product(builder: Builder, parts: Sequence[Part]) -> int:
    """`a_1 a_2 \\cdots a_n`."""
    dots = next(part.factor for part in parts if sole(part.factor).data == "dots")
    if any(part.operator in ("divided", "crossed") or part.bars for part in parts):
        raise builder.error("dots amid a quotient: write \\prod", dots)
    return _dotted(builder, "product", [part.factor for part in parts], dots)


def dotted_row(builder: Builder, rows: Sequence[Sequence[Branch]], tree: Branch) -> int:
    """`(b_1, \\cdots, b_n)`, or one below the other, which is its transpose."""
    if len(rows) == 1:
        return _dotted(builder, "family", rows[0], tree)
    if any(len(row) != 1 for row in rows):
        raise builder.error("dots in a matrix of several rows and columns", tree)
    number = _dotted(builder, "family", [row[0] for row in rows], tree)
    return builder.nodes.add("transpose", number)


def _dotted(builder: Builder, name: str, items: Sequence[Branch], tree: Branch) -> int:
    places = [place for place, item in enumerate(items) if sole(item).data == "dots"]
    if len(places) != 1 or places[0] != len(items) - 2 or places[0] == 0:
        problem = "dots want what comes first before them and what comes last behind"
        raise builder.error(problem, tree)
    numbers = [builder.value(item) for item in items if sole(item).data != "dots"]
    pattern = common_pattern(builder, numbers[0], numbers[-1])
    if pattern is None:
        problem = "dots stand for a pattern that is not declared: entries that differ in an index"
        raise builder.error(problem, tree)
    for step, number in enumerate(numbers[1:-1], 1):
        if instance(builder, pattern, _shifted(builder, pattern, step)) != number:
            raise builder.error("entries before dots that are not consecutive", tree)
    index = builder.nodes.add("symbol", pattern.symbol)
    return builder.nodes.add("call", name, pattern.entry, index, pattern.low, pattern.high)


def _shifted(builder: Builder, pattern: Pattern, step: int) -> int:
    """The index of the entry that stands `step` places behind the first."""
    kind, *rest = builder.nodes.node(pattern.low)
    if kind == "number":
        return builder.nodes.add("number", str(Fraction(str(rest[0])) + step))
    if kind == "add":
        *terms, last = (int(part) for part in rest)
        kind, *rest = builder.nodes.node(last)
        if kind == "number":
            moved = builder.nodes.add("number", str(Fraction(str(rest[0])) + step))
            return builder.nodes.add("add", *terms, moved)
    return builder.nodes.add("add", pattern.low, builder.nodes.add("number", str(step)))
