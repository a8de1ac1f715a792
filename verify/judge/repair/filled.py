"""A node whose hole is filled with what was recognised in it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, power
from gainproof.verify.judge.exact.poly import Ball
from gainproof.verify.judge.repair.construct import (
    ONE,
    opposite,
    product,
    quotient,
    raised,
    total,
)
from gainproof.verify.judge.repair.numbers import MOST_EXPONENT
from gainproof.verify.judge.repair.recognise import common_rational


def number_filled(found: Sequence[Ball], *_: object) -> Expr | None:
    """The rational number that all values are, as printed; None if there is none."""
    value = common_rational(found)
    if value is None:
        return None
    size = quotient(number(abs(value.numerator)), number(value.denominator))
    return size if value >= 0 else opposite(size)


def exponent_filled(node: Expr, found: Sequence[Ball]) -> Expr | None:
    """A power with the exponent that all values are."""
    value = common_rational(found)
    if value is None or max(abs(value), Fraction(value.denominator)) > MOST_EXPONENT:
        return None
    return raised(node.parts[0], value) if value else power(node.parts[0], 0)


def times_filled(node: Expr, factor: Expr | None) -> Expr | None:
    """The node times a factor, numbers multiplied out, equal bases once."""
    if factor is None:
        return None
    if factor.kind == "neg":
        inner = times_filled(node, factor.parts[0])
        return None if inner is None else opposite(inner)
    above, below = factor.parts if factor.kind == "div" else (factor, ONE)
    top, bottom = node.parts if node.kind == "div" else (node, ONE)
    size = Fraction(1)
    powers: dict[Expr, Fraction] = {}
    for side, sign in ((product(above, top), 1), (product(below, bottom), -1)):
        for factor in side.parts if side.kind == "mul" else (side,):
            if factor.kind == "number":
                size *= factor.fraction**sign
                continue
            whole = factor.kind == "pow" and factor.fraction.denominator == 1
            base, exponent = (factor.parts[0], factor.fraction) if whole else (factor, Fraction(1))
            powers[base] = powers.get(base, Fraction(0)) + sign * exponent
    tops = [raised(base, e) for base, e in powers.items() if e > 0]
    bottoms = [raised(base, -e) for base, e in powers.items() if e < 0]
    return quotient(
        product(number(size.numerator), *tops), product(number(size.denominator), *bottoms)
    )


def plus_filled(node: Expr, term: Expr | None) -> Expr | None:
    """The node with a term added."""
    return None if term is None else total(node, term)
