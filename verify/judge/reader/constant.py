"""Exact value of an expression made of numbers only: what an exponent must be."""

from __future__ import annotations

from fractions import Fraction

from lark import Token, Tree

from gainproof.verify.judge.reader.formula_limits import MOST_EXPONENT


def constant_value(tree: Tree[Token]) -> Fraction | None:
    """The value of a number, a quotient of two numbers, or either with a sign; None for anything
    else.

    A number beyond the limit of exponents is given as it is: the caller refuses it.
    """
    match tree.data:
        case "number":
            return Fraction(str(tree.children[0]))
        case "group" | "braced" | "single" | "sum" if len(tree.children) in (1, 3):
            inner = [child for child in tree.children if isinstance(child, Tree)]
            return constant_value(inner[0]) if len(inner) == 1 else None
        case "plus_sum" if len(tree.children) == 2 and isinstance(tree.children[1], Tree):
            return constant_value(tree.children[1])
        case "minus_sum" if len(tree.children) == 2 and isinstance(tree.children[1], Tree):
            value = constant_value(tree.children[1])
            return None if value is None else -value
        case "product" if len(tree.children) == 1 and isinstance(tree.children[0], Tree):
            return constant_value(tree.children[0])
        case "product" if len(tree.children) == 2:
            first, second = tree.children
            if isinstance(first, Tree) and isinstance(second, Tree) and second.data == "divided":
                return _quotient(first, second.children[1])
        case "fraction" | "over":
            above, below = (child for child in tree.children if isinstance(child, Tree))
            return _quotient(above, below)
    return None


def _quotient(numerator: object, denominator: object) -> Fraction | None:
    if not (isinstance(numerator, Tree) and isinstance(denominator, Tree)):
        return None
    above, below = constant_value(numerator), constant_value(denominator)
    if above is None or below is None or below == 0:
        return None
    if max(abs(above), abs(below)) > MOST_EXPONENT**2:
        return Fraction(MOST_EXPONENT + 1)
    return above / below
