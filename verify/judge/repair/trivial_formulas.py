"""Formulas that hold whatever the filter is say nothing, and are no repair."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property, lru_cache
from random import Random

import flint

from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.repair.formula_values import PRECISION, Values, truth
from gainproof.verify.judge.repair.printed_formula import Link, Printed
from gainproof.verify.judge.scope import Scope, UndefinedSymbol

SEED = 11
SAMPLES = 12
MANY_SAMPLES = 60


class OffTheModel:
    """Points where quantities and defined symbols have values of their own, of either sign.

    `names` are the symbols of the claim as printed that mean something, empty if none does: then
    only formulas whose sides are written alike are trivial.
    """

    def __init__(self, scope: Scope, names: frozenset[str]) -> None:
        self.names = frozenset(name for name in names if _means_something(scope, name))
        self._scope = scope
        source = Random(SEED)
        tokens = sorted(scope.setting.symbols)
        self._draws = [
            {name: _draw(source, positive=sample % 2 == 0) for name in tokens}
            for sample in range(MANY_SAMPLES)
        ]
        self.values = [self._at(draw) for draw in self._draws[:SAMPLES]]

    def _at(self, draw: dict[str, Ball]) -> Values:
        return Values(self._scope, {}, {}, overriding=draw)

    @cached_property
    def many(self) -> list[Values]:
        """More points than `values`, for what is looked at where something holds."""
        return [self._at(draw) for draw in self._draws]

    def moved(self, name: str) -> Iterator[tuple[Values, Values]]:
        """Points, each with one at which this symbol alone has another value."""
        for n, values in enumerate(self.values):
            if name in self._draws[n]:
                other = self._draws[n + SAMPLES][name]
                yield values, self._at({**self._draws[n], name: other})

    def is_trivial(self, formula: Printed) -> bool:
        """Whether the formula needs neither the model nor the source's definitions."""
        if all(_alike(formula, link.left, link.right) for link in formula.links):
            return True
        claimed = [(link.operator, *_ends(formula, link)) for link in formula.links]
        stated = [(link.operator, *_ends(formula, link)) for link in formula.conditions]
        if claimed == stated or (formula.connective == "if" and set(claimed) & set(stated)):
            return True
        used = set().union(*[symbols_of(side) for side in formula.sides])
        if not used:
            return True
        if any(self._is_constant(formula, link) for link in formula.links):
            return True
        if not self.names:
            return False
        found = [truth(values, formula) for values in self.values]
        return False not in found and True in found

    def _is_constant(self, formula: Printed, link: Link) -> bool:
        """Whether an order compares sides that differ by a number whatever their symbols are."""
        left, right = formula.sides[link.left], formula.sides[link.right]
        if link.operator == "=" or not symbols_of(left) & symbols_of(right):
            return False
        pairs = [(values.ball(left), values.ball(right)) for values in self.values]
        gaps = [a - b for a, b in pairs if a is not None and b is not None]
        return len(gaps) > 2 and all(gap.overlaps(gaps[0]) for gap in gaps)


def _means_something(scope: Scope, name: str) -> bool:
    try:
        value = scope.symbol(name)
        return not isinstance(value, Expr) or value.kind != "symbol"
    except (Undecided, Malformed, UndefinedSymbol):
        return True


def _draw(source: Random, *, positive: bool) -> Ball:
    value = Fraction(source.randrange(100, 3000), 997)
    # the ball of a rational number is as wide as the precision at which it is made
    with flint.ctx.workprec(PRECISION):
        return flint.arb(rational(value if positive or source.random() < 0.5 else -value))


def _ends(formula: Printed, link: object) -> tuple[bytes, bytes]:
    left, right = (formula.sides[getattr(link, end)] for end in ("left", "right"))
    return sorted_key(left), sorted_key(right)


def _alike(formula: Printed, left: int, right: int) -> bool:
    return sorted_key(formula.sides[left]) == sorted_key(formula.sides[right])


def sorted_key(expr: Expr) -> bytes:
    """A key that is the same for sums and products in any order."""
    return _sorted(expr).key


@lru_cache(maxsize=1 << 15)  # the changes of one formula share nearly all of their parts
def _sorted(expr: Expr) -> Expr:
    parts = [_sorted(part) for part in expr.parts]
    if expr.kind in ("add", "mul"):
        parts.sort(key=lambda part: part.key)
    return Expr(expr.kind, expr.value, tuple(parts))
