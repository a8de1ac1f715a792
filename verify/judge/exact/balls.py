"""Balls round expression trees at rational points, straight from the tree."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.functions import ball_of, first_case, is_cases
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.statement import ALLOWED

NONE = "none of the cases"


class NoValue(ArithmeticError):
    """Division by exactly zero, an even root or a logarithm of a negative number, or that of 0."""


class Unresolved(ArithmeticError):
    """A ball contains zero where its sign matters, or a function is not known."""


class Balls:
    """Balls round the values of expressions at one point, or at all points of a ball; what several
    share is enclosed once.
    """

    def __init__(self, values: Mapping[str, Fraction | Ball], precision: int) -> None:
        self.values, self.precision = values, precision
        self._known: dict[bytes, Ball] = {}

    def round(self, expr: Expr) -> Ball:
        """A ball round the value. Raises NoValue, Unresolved."""
        try:
            return self._round(expr)
        except (NoValue, Unresolved):
            if not any(n.kind == "call" and is_cases(n.name, len(n.parts)) for n in walk(expr)):
                raise
        # of cases that do not apply no value is asked
        return self._round(rebuilt(expr, self._chosen))

    def _round(self, expr: Expr) -> Ball:
        known = self._known
        with flint.ctx.workprec(self.precision):
            for node in walk(expr, known=known):
                known[node.key] = _node(node, [known[p.key] for p in node.parts], self.values)
        return known[expr.key]

    def _chosen(self, node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        """The first value whose conditions hold, none before it being open to doubt."""
        if node.kind != "call" or not is_cases(node.name, len(parts)):
            return None
        rest: Expr | None = Expr(node.kind, node.value, parts)
        while rest is not None:
            comparisons, value, rest = first_case(rest)
            try:
                known = [self._compared(*each) for each in comparisons]
            except NoValue:
                break
            except Unresolved:
                known = [None]
            if all(known):
                return value
            if False not in known:
                return Expr("call", "a condition of which balls do not tell", ())
        return Expr("call", NONE, ())

    def _compared(self, operator: str, left: Expr, right: Expr) -> bool | None:
        a, b = self._round(left), self._round(right)
        if a.is_exact() and b.is_exact():
            return (1 if a > b else -1 if a < b else 0) in ALLOWED[operator]
        return compared(operator, a, b)


def enclosed(expr: Expr, values: Mapping[str, Fraction], precision: int) -> Ball:
    """A ball round the value at a point. Raises NoValue, Unresolved."""
    return Balls(values, precision).round(expr)


def sign_at(expr: Expr, values: Mapping[str, Fraction], precision: int) -> int:
    """Of the value at a point; 0 also where balls do not tell."""
    try:
        ball = enclosed(expr, values, precision)
    except (NoValue, Unresolved):
        return 0
    return 1 if ball > 0 else -1 if ball < 0 else 0


def compared(operator: str, a: Ball, b: Ball) -> bool | None:
    """Whether a relation holds of the numbers of two balls; None where these overlap, and for what
    is no such relation.
    """
    if a.overlaps(b) or operator not in ALLOWED:
        return None
    return (-1 if a < b else 1) in ALLOWED[operator]


def _node(node: Expr, parts: list[Ball], values: Mapping[str, Fraction | Ball]) -> Ball:
    match node.kind:
        case "number":
            return flint.arb(rational(node.fraction))
        case "symbol":
            if node.name not in values:
                raise Unresolved(node.name)
            value = values[node.name]
            return flint.arb(rational(value)) if isinstance(value, Fraction) else value
        case "add" | "mul":
            total = parts[0]
            for part in parts[1:]:
                total = total + part if node.kind == "add" else total * part
            return total
        case "neg":
            return -parts[0]
        case "div":
            return parts[0] * _inverse(parts[1])
        case "pow" if _is_root_of_square(node) and parts[0].contains(0):
            # whatever its ball says, the square is not below 0
            root = flint.arb(0).union(parts[0].abs_upper().root(node.fraction.denominator))
            return _power(root, Fraction(node.fraction.numerator))
        case "pow":
            return _power(parts[0], node.fraction)
        case "call" if node.name == "log" and parts[0] <= 0:
            raise NoValue("a logarithm of a number that is not positive")
        case "call" if node.name == "power" and parts[0] < 0 and _is_broken(parts[1]):
            raise NoValue("a power of a negative number whose exponent is not whole")
        case "call" if node.name == "atan2" and all(part.is_zero() for part in parts):
            raise NoValue("the angle of the origin")
        case "call" if node.name == "no jump" and _jumps(*parts):
            raise NoValue("an angle jumps by a whole turn")
        case "call" if node.name == NONE:
            raise NoValue(NONE)
        case "call" if (known := ball_of(node.name, parts)) is not None:
            return known
        case _:
            raise Unresolved(str(node.value))


def _jumps(y: Ball, x: Ball, rise: Ball) -> bool:
    """Whether y is seen to pass through 0 where x is not positive."""
    return bool(y.is_zero() and x <= 0 and not rise.contains(0))


def _is_root_of_square(node: Expr) -> bool:
    """Whether it is a positive power of an even power, |a| say."""
    inner = node.parts[0]
    even = inner.kind == "pow" and inner.fraction > 0 and inner.fraction.numerator % 2 == 0
    return even and node.fraction > 0 and node.fraction.denominator > 1


def _is_broken(exponent: Ball) -> bool:
    """Whether it is seen to be no whole number and, being exact, no fraction of odd divisor."""
    return bool(exponent.is_exact() and not exponent.is_integer())


def _inverse(x: Ball) -> Ball:
    if x.is_zero():
        raise NoValue("a divisor is zero")
    if x.contains(0):
        raise Unresolved("a divisor that may be zero")
    return 1 / x


def _power(base: Ball, exponent: Fraction) -> Ball:
    order, times = exponent.denominator, abs(exponent.numerator)
    if exponent < 0:
        base = _inverse(base)
    if order > 1 and not base.is_zero():
        if base > 0:
            base = base.root(order)
        elif base < 0 and order % 2:
            base = -((-base).root(order))
        elif base < 0:
            raise NoValue("an even root of a negative number")
        else:
            raise Unresolved("a root of a number that may be zero")
    product = flint.arb(1)
    for _ in range(times):
        product = product * base
    return product
