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
    """The node times a factor, its numbers multiplied out."""
    if factor is None:
        return None
    if factor.kind == "neg":
        inner = times_filled(node, factor.parts[0])
        return None if inner is None else opposite(inner)
    above, below = factor.parts if factor.kind == "div" else (factor, ONE)
    top, bottom = node.parts if node.kind == "div" else (node, ONE)
    (a, tops), (b, bottoms) = _gathered(above, top), _gathered(below, bottom)
    size = a / b
    return quotient(
        product(number(size.numerator), *tops), product(number(size.denominator), *bottoms)
    )


def _gathered(*factors: Expr) -> tuple[Fraction, list[Expr]]:
    """The numbers among the factors multiplied, and the others."""
    flat = product(*factors)
    parts = flat.parts if flat.kind == "mul" else (flat,)
    value = Fraction(1)
    for part in parts:
        value *= part.fraction if part.kind == "number" else 1
    return value, _powers([part for part in parts if part.kind != "number"])


def _powers(factors: Sequence[Expr]) -> list[Expr]:
    """Equal bases once, their whole exponents added."""
    found: dict[Expr, Fraction] = {}
    for factor in factors:
        is_power = factor.kind == "pow" and factor.fraction.denominator == 1
        base, exponent = (factor.parts[0], factor.fraction) if is_power else (factor, Fraction(1))
        found[base] = found.get(base, Fraction(0)) + exponent
    return [raised(base, exponent) for base, exponent in found.items()]


def plus_filled(node: Expr, term: Expr | None) -> Expr | None:
    """The node with a term added."""
    return None if term is None else total(node, term)
