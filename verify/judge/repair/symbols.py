"""One symbol or function for another; parts dropped or put in."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, symbol
from gainproof.verify.judge.repair.construct import (
    ONE,
    exchanged,
    opposite,
    product,
    quotient,
    remade,
    total,
    without,
)
from gainproof.verify.judge.repair.edit import LARGE, PLAIN, SLIGHT, SYMBOL, Edit, Table

PAIRS = (
    *(("sin", "cos"), ("tan", "cot"), ("sec", "csc"), ("sinh", "cosh")),
    *(("asin", "acos"), ("max", "min")),
)
EXCHANGED = {one: other for pair in PAIRS for one, other in (pair, pair[::-1])}
"""Functions that are mistaken for one another."""


def other_symbols(node: Expr, table: Table) -> Iterator[Edit]:
    """Another declared symbol; one that differs in an index only is a slighter slip."""
    if node.kind != "symbol":
        return
    for name in table.symbols:
        if name != node.name:
            is_sibling = (node.name, name) in table.siblings
            what = "an index" if is_sibling else SYMBOL
            yield Edit(symbol(name), SLIGHT if is_sibling else PLAIN, what)


def other_functions(node: Expr, _: Table) -> Iterator[Edit]:
    """The function that is taken for this one: the cosine for the sine."""
    if node.kind == "call" and (name := EXCHANGED.get(node.name)) is not None:
        yield Edit(Expr("call", name, node.parts), PLAIN, "a function")


def dropped(node: Expr, _: Table) -> Iterator[Edit]:
    """A term or factor too many."""
    if node.kind in ("add", "mul"):
        for k, part in enumerate(node.parts):
            kept = remade(node.kind, None, without(node.parts, k))
            yield Edit(kept, LARGE, "a part too many", part)
    if node.kind == "div":
        top, bottom = node.parts
        yield Edit(top, LARGE, "a divisor too many", bottom)
        if top != ONE:
            yield Edit(quotient(ONE, bottom), LARGE, "a numerator too many", top)


def inserted(node: Expr, table: Table) -> Iterator[Edit]:
    """A term or factor that is missing: a symbol, or one."""
    if node.kind in ("add", "pow"):
        for k, part in enumerate(node.parts):
            for name in table.symbols:
                for new in (product(part, symbol(name)), quotient(part, symbol(name))):
                    parts = exchanged(node.parts, k, new)
                    made = remade(node.kind, node.value, parts)
                    yield Edit(made, LARGE, "a missing factor", part)
    if node.kind in ("symbol", "number"):
        return
    for term in (ONE, *[symbol(name) for name in table.symbols]):
        for new in (total(node, term), total(node, opposite(term))):
            yield Edit(new, LARGE, "a missing term", term)
