"""Values of expressions that hold numbers only."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.limits import DEFAULT_LIMITS


def constant_value(expr: Expr) -> Fraction | None:
    """The value of an expression of numbers only, without roots; None for others."""
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
                    value *= v
            case "div":
                value = None if values[1] == 0 else values[0] / values[1]
            case "pow":
                value = _integer_power(values[0], node.fraction)
        if value is None:
            return None
        done[node.key] = value
    return done[expr.key]


def _integer_power(base: Fraction, exponent: Fraction) -> Fraction | None:
    if (
        exponent.denominator != 1
        or abs(exponent) > DEFAULT_LIMITS.exponent
        or (base == 0 and exponent < 0)
    ):
        return None
    return base ** int(exponent)
