"""Random radical expressions of one parameter, and their values straight from the tree."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import flint

from gainproof.verify.judge.exact.expression import (
    Expr,
    absolute,
    add,
    div,
    mul,
    neg,
    number,
    power,
    sqrt,
    symbol,
    walk,
)

X = symbol("x")
CUBE = Fraction(1, 3)


def expression(random: Random, depth: int) -> Expr:
    """A random expression with few roots."""
    if depth == 0 or random.random() < 0.15:
        return random.choice(
            (X, X, X, number(random.randint(-4, 4)), number(Fraction(random.randint(1, 5), 2)))
        )

    def a() -> Expr:
        return expression(random, depth - 1)

    kind = random.choice(
        ("add", "add", "sub", "mul", "mul", "div", "sqrt", "sqrt", "square", "neg", "cube", "abs")
    )
    match kind:
        case "add":
            return add(a(), a())
        case "sub":
            return a() - a()
        case "mul":
            return mul(a(), a())
        case "div":
            return div(a(), a())
        case "sqrt":
            return sqrt(a())
        case "square":
            return power(a(), random.choice((2, 2, 3, -1)))
        case "neg":
            return neg(a())
        case "cube":
            return power(a(), CUBE) if random.random() < 0.4 else power(a(), 2)
        case _:
            return absolute(a()) if random.random() < 0.5 else a() + number(1)


def equal_pair(random: Random, depth: int) -> tuple[Expr, Expr]:
    """Two expressions that are equal wherever both have a value (in some of them up to a sign that
    is checked).
    """
    a, b = expression(random, depth), expression(random, depth)
    pairs = (
        (power(a + b, 2), power(a, 2) + 2 * a * b + power(b, 2)),
        ((a - b) * (a + b), power(a, 2) - power(b, 2)),
        (div(number(1), sqrt(a) + sqrt(b)), div(sqrt(a) - sqrt(b), a - b)),
        (sqrt(power(a, 2)), absolute(a)),
        (sqrt(power(a, 2) + 2 * a * b + power(b, 2)), absolute(a + b)),
        (sqrt(a) * sqrt(a), a),
        (sqrt(a) * sqrt(b), sqrt(a * b)),
        (sqrt(a + b + 2 * sqrt(a * b)), sqrt(a) + sqrt(b)),
        (power(power(a, 3), CUBE), a),
        (power(a, CUBE) * power(b, CUBE), power(a * b, CUBE)),
        (div(a, b) + div(b, a), div(power(a, 2) + power(b, 2), a * b)),
        (sqrt(div(a, b)), div(sqrt(a * b), absolute(b))),
        (sqrt(sqrt(power(a, 4))), absolute(a)),
        (power(a, 3) - power(b, 3), (a - b) * (power(a, 2) + a * b + power(b, 2))),
        (power(sqrt(a) + number(1), 3), a * sqrt(a) + 3 * a + 3 * sqrt(a) + number(1)),
    )
    return random.choice(pairs)


def near_pair(random: Random, depth: int) -> tuple[Expr, Expr]:
    """An equal pair with one side changed, perhaps by very little or on one side of a point."""
    left, right = equal_pair(random, depth)
    tiny = number(Fraction(1, 10 ** random.randint(3, 20)))
    centre = X - number(random.randint(-3, 3))
    changes = (
        right + tiny,
        right * (1 + tiny),
        right + tiny * (absolute(centre) - centre),
        right + tiny * centre * X,
        neg(right),
        sqrt(power(right, 2)),
        right + tiny * (sqrt(power(centre, 2)) + centre),
    )
    return left, random.choice(changes)


class Unclear(Exception):
    """A ball contains zero where its sign matters."""


class NoValue(Exception):
    """The expression has no value at the point."""


def value(expr: Expr, at: Fraction, bits: int = 600) -> Any:
    """A ball round the expression at a point, by plain evaluation of the tree. Raises NoValue,
    Unclear.
    """
    with flint.ctx.workprec(bits):
        done: dict[bytes, Any] = {}
        for node in walk(expr):
            parts = [done[p.key] for p in node.parts]
            done[node.key] = _node(node, parts, at)
        return done[expr.key]


def _node(node: Expr, parts: list[Any], at: Fraction) -> Any:
    match node.kind:
        case "number":
            return flint.arb(flint.fmpq(node.fraction.numerator, node.fraction.denominator))
        case "symbol":
            return flint.arb(flint.fmpq(at.numerator, at.denominator))
        case "add":
            total = parts[0]
            for part in parts[1:]:
                total = total + part
            return total
        case "mul":
            total = parts[0]
            for part in parts[1:]:
                total = total * part
            return total
        case "neg":
            return -parts[0]
        case "div":
            return parts[0] * _inverse(parts[1])
        case _:
            return _power(parts[0], node.fraction)


def _inverse(x: Any) -> Any:
    if x.is_zero():
        raise NoValue
    if x.contains(0):
        raise Unclear
    return 1 / x


def _power(base: Any, exponent: Fraction) -> Any:
    order, times = exponent.denominator, exponent.numerator
    if times < 0:
        base, times = _inverse(base), -times
    if order == 1 or base.is_zero():
        return _whole(base, times)
    if base > 0:
        return _whole(base.root(order), times)
    if base < 0:
        if order % 2 == 0:
            raise NoValue
        return _whole(-((-base).root(order)), times)
    raise Unclear


def _whole(base: Any, times: int) -> Any:
    """By multiplication: arb's own power is not a number for a ball that contains zero."""
    product = flint.arb(1)
    for _ in range(times):
        product = product * base
    return product
