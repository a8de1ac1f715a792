"""Exponents and numbers."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.repair.edits import PLAIN, Edit, Table
from gainproof.verify.judge.repair.tree_construction import (
    HALF,
    ONE,
    TWO,
    exchanged,
    is_of_one_number,
    multiplied,
    quotient,
    raised,
    remade,
)

SMALL = tuple(Fraction(n) for n in range(13))
MOST_EXPONENT = 12


def exponents(node: Expr, _: Table) -> Iterator[Edit]:
    """An exponent one more or less, doubled, halved, of the other sign, lost, or put in."""
    if node.kind == "pow":
        e = node.fraction
        for new in dict.fromkeys((Fraction(1), e + 1, e - 1, 2 * e, e / 2, -e)):
            if new not in (0, e) and abs(new) <= MOST_EXPONENT:
                yield Edit(raised(node.parts[0], new), PLAIN, "an exponent")
        return
    if node.kind in ("symbol", "add", "div", "mul"):
        yield Edit(raised(node, Fraction(2)), PLAIN, "a lost square")
        yield Edit(raised(node, HALF), PLAIN, "a lost root")


def constants(node: Expr, _: Table) -> Iterator[Edit]:
    """Another number: near it, its double or half, a small one, a digit lost."""
    if node.kind != "number":
        return
    v = node.fraction
    near = [v + 1, v - 1, 2 * v, v / 2, 4 * v, v / 4, 10 * v, v / 10, *SMALL]
    digits = str(abs(v.numerator))
    if v.denominator == 1 and len(digits) > 1:
        near += [Fraction(digits[:k] + digits[k + 1 :]) for k in range(len(digits))]
        near += [
            Fraction(digits[:k] + digits[k + 1] + digits[k] + digits[k + 2 :])
            for k in range(len(digits) - 1)
        ]
    for new in dict.fromkeys(near):
        if new != v and new >= 0:
            yield Edit(number(new), PLAIN, "a number")


def factor_two(node: Expr, _: Table) -> Iterator[Edit]:
    """A factor two, lost or too many, in a term of a sum, under an exponent, or in what a function
    is taken of: e^{-x^2} for e^{-x^2/2}.
    """
    if node.kind not in ("add", "pow") and not is_of_one_number(node):
        return
    for k, part in enumerate(node.parts):
        for new in (multiplied(part, TWO), multiplied(part, quotient(ONE, TWO))):
            parts = exchanged(node.parts, k, new)
            made = remade(node.kind, node.value, parts)
            yield Edit(made, PLAIN, "a factor 2", part)
