"""A node whose hole is filled with what was recognised in it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, power
from gainproof.verify.judge.exact.poly import Ball
from gainproof.verify.judge.repair.construct import (
    opposite,
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


def plus_filled(node: Expr, term: Expr | None) -> Expr | None:
    """The node with a term added."""
    return None if term is None else total(node, term)
