"""Values of expressions that hold numbers only."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.rational_roots import integer_root
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS

MOST_BITS = 50_000
"""Size of a value: powers inside one another write numbers that no memory holds."""


def constant_value(expr: Expr) -> Fraction | None:
    """The value of an expression of numbers only, if it is rational; None for others, for those in
    which a root is not rational, and for those in which a number is too large.
    """
    done: dict[bytes, Fraction] = {}
    for node in walk(expr):
        parts = [done.get(p.key) for p in node.parts]
        if any(p is None for p in parts):
            return None
        values = [p for p in parts if p is not None]
        value: Fraction | None = None
        match node.kind:
            case "number":
                value = node.fraction
            case "add":
                value = sum(values, Fraction(0))
            case "neg":
                value = -values[0]
            case "mul":
                value = Fraction(1)
                for v in values:
                    if _bits(value) > MOST_BITS:
                        return None
                    value *= v
            case "div":
                value = None if values[1] == 0 else values[0] / values[1]
            case "pow":
                value = _power(values[0], node.fraction)
        if value is None or _bits(value) > MOST_BITS:
            return None
        done[node.key] = value
    return done[expr.key]


def _power(base: Fraction, exponent: Fraction) -> Fraction | None:
    order, times = exponent.denominator, exponent.numerator
    if abs(times) > DEFAULT_LIMITS.exponent or (base == 0 and times < 0):
        return None
    root = rational_root(base, order)
    if root is None or _bits(root) * abs(times) > MOST_BITS:
        return None
    return root**times


def _bits(value: Fraction) -> int:
    return value.numerator.bit_length() + value.denominator.bit_length()


def rational_root(value: Fraction, order: int) -> Fraction | None:
    """The real root of a rational number that has a rational one; of a negative one for odd
    orders.
    """
    if order == 1:
        return value
    if (value < 0 and order % 2 == 0) or order > DEFAULT_LIMITS.exponent:
        return None
    top, bottom = (integer_root(abs(n), order) for n in (value.numerator, value.denominator))
    if top is None or bottom is None:
        return None
    return Fraction(-top if value < 0 else top, bottom)
