"""Signs, operators, operators lost in print."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, neg
from gainproof.verify.judge.repair.construct import (
    ONE,
    exchanged,
    is_of_one_number,
    opposite,
    product,
    quotient,
    remade,
    total,
    without,
)
from gainproof.verify.judge.repair.edit import PLAIN, SLIGHT, Edit, Table
from gainproof.verify.judge.repair.expanded import PARITY


def signs(node: Expr, _: Table) -> Iterator[Edit]:
    """One term of a sum, or what a function is taken of, with the other sign."""
    # nobody prints sin(-x): the sign would stand in front
    if node.kind == "call" and node.name in PARITY and node.parts[0].kind != "neg":
        return
    if node.kind == "add" or is_of_one_number(node):
        what = "sign of a term" if node.kind == "add" else "sign of an argument"
        for k, part in enumerate(node.parts):
            parts = exchanged(node.parts, k, opposite(part))
            yield Edit(remade(node.kind, node.value, parts), SLIGHT, what, part)


def operators(node: Expr, _: Table) -> Iterator[Edit]:
    """Another operator between neighbours, or one lost between two factors."""
    match node.kind:
        case "add":
            for k in range(len(node.parts) - 1):
                a, b = node.parts[k], node.parts[k + 1]
                if {a, b} & {ONE, neg(ONE)}:
                    continue  # times 1 is the term left out
                yield _joined(node, k, product(a, b), "a sum that is a product")
                yield _joined(node, k, quotient(a, b), "a sum that is a quotient")
        case "mul":
            for k in range(len(node.parts) - 1):
                a, b = node.parts[k], node.parts[k + 1]
                yield _joined(node, k, total(a, b), "a product that is a sum")
                yield _joined(node, k, total(a, opposite(b)), "a product that is a difference")
            for k, factor in enumerate(node.parts):
                under = quotient(product(*without(node.parts, k)), factor)
                yield Edit(under, SLIGHT, "a factor that divides", factor)
        case "div":
            a, b = node.parts
            yield Edit(product(a, b), SLIGHT, "a quotient that is a product")
            yield Edit(quotient(b, a), PLAIN, "a fraction upside down")
            yield Edit(total(a, b), PLAIN, "a quotient that is a sum")
            yield Edit(total(a, opposite(b)), PLAIN, "a quotient that is a difference")


def _joined(node: Expr, k: int, new: Expr, what: str) -> Edit:
    parts = (*node.parts[:k], new, *node.parts[k + 2 :])
    return Edit(remade(node.kind, node.value, parts), SLIGHT, what)
