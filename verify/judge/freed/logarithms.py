"""Logarithms of products as sums of those of their factors, and angles that are an arc tangent.

log(b^a c) = a log b + log c for positive b and c, numbers by their primes, log exp a = a;
sin atan x = x (1 + x^2)^(-1/2), cos atan x = (1 + x^2)^(-1/2), tan atan x = x, and of twice the arc
tangent 2 x/(1 + x^2), (1 - x^2)/(1 + x^2) and their ratio.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power
from gainproof.verify.judge.freed.bases import bases_of
from gainproof.verify.judge.freed.ranges import Positive

Factor = tuple[Expr, Expr]
"""A base and its exponent."""


def sum_of_logarithms(argument: Expr, is_positive: Positive) -> Expr | None:
    """The logarithm as a sum; None if it is of no product, or of one whose factors are not known to
    be positive.
    """
    terms = list[Expr]()
    for base, exponent in _factors(argument, number(1)):
        if base.kind == "call" and base.name == "exp":
            terms.append(mul(exponent, base.parts[0]))
        elif not is_positive(base):
            return None
        elif base != number(1):
            terms.append(mul(exponent, Expr("call", "log", (base,))))
    found = add(*terms) if terms else number(0)
    return None if found == Expr("call", "log", (argument,)) else found


def _factors(expr: Expr, exponent: Expr) -> Iterator[Factor]:
    """Of a product of powers; a power of what may be negative is a base of its own."""
    match expr.kind:
        case "number":
            for base, times in bases_of(expr).items():
                yield base, mul(number(times), exponent)
        case "mul":
            for part in expr.parts:
                yield from _factors(part, exponent)
        case "div":
            yield from _factors(expr.parts[0], exponent)
            yield from _factors(expr.parts[1], mul(number(-1), exponent))
        case "pow":
            yield from _factors(expr.parts[0], mul(number(expr.fraction), exponent))
        case "call" if expr.name == "power":
            yield from _factors(expr.parts[0], mul(expr.parts[1], exponent))
        case _:
            yield expr, exponent


def of_arc_tangent(name: str, argument: Expr) -> Expr | None:
    """A sine, cosine or tangent of an arc tangent, or of twice one, of either sign; None if it is
    of anything else.
    """
    found = _arc_tangent(argument)
    if found is None or name not in ("sin", "cos", "tan"):
        return None
    x, times = found
    square = add(number(1), power(x, 2))
    if abs(times) == 1:
        below = power(square, Fraction(1, 2))
        sine, cosine = x / below, 1 / below
    else:
        sine, cosine = 2 * x / square, (1 - power(x, 2)) / square
    if name == "cos":
        return cosine
    value = x if name == "tan" and abs(times) == 1 else sine if name == "sin" else sine / cosine
    return value if times > 0 else neg(value)


def _arc_tangent(argument: Expr) -> tuple[Expr, int] | None:
    """`m atan x` as x and m, one or two; what is written otherwise is left."""
    match argument.kind:
        case "call" if argument.name == "atan":
            return argument.parts[0], 1
        case "neg":
            found = _arc_tangent(argument.parts[0])
            return None if found is None else (found[0], -found[1])
        case "mul" if len(argument.parts) == 2 and argument.parts[0].kind == "number":
            found, times = _arc_tangent(argument.parts[1]), argument.parts[0].fraction
            if found is not None and abs(times * found[1]) in (1, 2):
                return found[0], int(times * found[1])
    return None
