"""Balls round printed formulas at a point: symbols have their values, nodes are evaluated once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.repair.printed_formula import Link, Printed
from gainproof.verify.judge.scope import Scope, UndefinedSymbol

MOST_KEPT = 200_000
AGREED_BITS = 60
PRECISION = 128


class Values:
    """Values at one point. `put_in` are variables that equations among the conditions fix;
    `overriding` gives symbols another value than the source's; `resolved` keeps formulas in base
    variables, which are the same at all points of one scope, by what is printed.
    """

    def __init__(
        self,
        scope: Scope,
        point: Mapping[str, Fraction],
        put_in: Mapping[str, Expr],
        precision: int = PRECISION,
        overriding: Mapping[str, Ball] | None = None,
        resolved: dict[bytes, Expr | None] | None = None,
    ) -> None:
        self.scope, self.point, self.put_in, self.precision = scope, point, put_in, precision
        self._balls = Balls(point, precision)
        self._symbols: dict[str, Ball | None] = dict(overriding or {})
        self._own = frozenset(overriding or {})
        self._kept: dict[bytes, Ball | None] = {}
        self._in_base = {} if resolved is None else resolved

    def symbol(self, name: str) -> Ball | None:
        """A symbol's value, or None."""
        if name not in self._symbols:
            self._symbols[name] = self._base(name)
        return self._symbols[name]

    def _base(self, name: str) -> Ball | None:
        try:
            return self._enclosed(number_of(self.scope.symbol(name)))
        except (Undecided, Malformed, UndefinedSymbol):
            return None

    def _enclosed(self, expr: Expr) -> Ball | None:
        try:
            if self.put_in:
                expr = substituted(expr, self.put_in)
            return self._balls.round(expr)
        except (NoValue, Unresolved):
            return None

    def ball(self, expr: Expr) -> Ball | None:
        """A ball round a printed formula, or None where it has no value or none is known."""
        if len(self._kept) > MOST_KEPT:
            self._kept.clear()
        with flint.ctx.workprec(self.precision):
            return self._ball(expr)

    def _ball(self, expr: Expr) -> Ball | None:
        if expr.key in self._kept:
            return self._kept[expr.key]
        found = self._node(expr)
        self._kept[expr.key] = found
        return found

    def _node(self, expr: Expr) -> Ball | None:
        match expr.kind:
            case "number":
                return flint.arb(rational(expr.fraction))
            case "symbol":
                return self.symbol(expr.name)
            case "add" | "mul" | "neg" | "div" | "pow":
                parts = [self._ball(part) for part in expr.parts]
                if any(part is None for part in parts):
                    return None
                return combined(expr, parts)
            case _:
                return self._resolved(expr)

    def _resolved(self, expr: Expr) -> Ball | None:
        """Derivatives, substitutions, sums and functions: in base variables only."""
        if self._own:
            return None
        if expr.key not in self._in_base:
            self._in_base[expr.key] = self._read(expr)
        found = self._in_base[expr.key]
        try:
            return None if found is None else self._enclosed(found)
        except (Undecided, Malformed, UndefinedSymbol):
            return None

    def _read(self, expr: Expr) -> Expr | None:
        fresh = Scope(
            self.scope.setting, self.scope.environment, self.scope.choice, self.scope.held
        )
        try:
            return fresh.expression(graph_of(expr))
        except (Undecided, Malformed, UndefinedSymbol):
            return None


def values_at(
    scope: Scope, points: Sequence[Mapping[str, Fraction]], put_in: Mapping[str, Expr]
) -> list[Values]:
    """Values at several points, for which a printed formula is put in base variables once."""
    resolved: dict[bytes, Expr | None] = {}
    return [Values(scope, point, put_in, resolved=resolved) for point in points]


def combined(expr: Expr, parts: list[Ball]) -> Ball | None:
    """A sum, product, opposite, quotient or power of values; None where there is none."""
    match expr.kind:
        case "add":
            value = parts[0]
            for part in parts[1:]:
                value = value + part
            return value
        case "mul":
            value = parts[0]
            for part in parts[1:]:
                value = value * part
            return value
        case "neg":
            return -parts[0]
        case "div":
            return None if parts[1].contains(0) else parts[0] / parts[1]
        case "pow":
            return power(parts[0], expr.fraction)
        case _:
            return None


def power(base: Ball, exponent: Fraction) -> Ball | None:
    """A rational power; None where there is none or it is not resolved."""
    order, times = exponent.denominator, exponent.numerator
    if order > 1 and not base.is_zero():
        if base.contains(0) or (base < 0 and order % 2 == 0):
            return None
        base = base.root(order) if base > 0 else -((-base).root(order))
    if times < 0 and base.contains(0):
        return None
    return base ** int(times)


def truth(values: Values, formula: Printed, links: tuple[Link, ...] | None = None) -> bool | None:
    """Whether all links hold at the point as far as balls tell; None if a side has no value."""
    unknown = False
    for link in formula.links if links is None else links:
        a, b = values.ball(formula.sides[link.left]), values.ball(formula.sides[link.right])
        if a is None or b is None:
            unknown = True
            continue
        found = _compared(link.operator, a, b)
        if found is False:
            return False
        unknown = unknown or found is None
    return None if unknown else True


def _compared(operator: str, a: Ball, b: Ball) -> bool | None:
    if not a.overlaps(b):
        return compared(operator, a, b)
    # beside zero there is no relative measure; proof decides about what passes
    gap, size = (a - b).abs_upper(), max(a.abs_upper(), b.abs_upper(), flint.arb(1))
    if gap * 2**AGREED_BITS > size:
        return None
    return operator in ("=", "<=", ">=")
