"""Where the variables live that stand for function values.

A variable is stated, so that no divisor may vanish, where a domain behind it is stated or where it
is a constant.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType

import flint

from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, neg, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.expression_text import is_series
from gainproof.verify.judge.exact.polynomial import exact_value
from gainproof.verify.judge.meaning.sequences import is_term
from gainproof.verify.judge.transcendental.half_tangent import half_tangent, half_tangent_of_turns
from gainproof.verify.judge.transcendental.monomials import Monomial, monomial_expr
from gainproof.verify.judge.transcendental.pi import VARIABLE

EULER = symbol("e")
"""Base of exponentials; no base variable is called like that."""
QUARTER, HALF = Fraction(157, 100), Fraction(314, 100)
"""A little less than a quarter of a turn and half a turn."""

MOST = MappingProxyType({"erf": Fraction(1), "atan": Fraction(11, 7)})
"""Function values lie below these numbers, and above their opposites."""

BITS = 64
"""Of what encloses a function of numbers."""

Positive = Callable[[Expr], bool]


@dataclass(frozen=True)
class Ranges:
    """Answers from the domains of the base variables; `is_positive` is known to be true, or not
    known.
    """

    boxes: Mapping[str, Box]
    is_positive: Positive

    def power(self, base: Expr, monomial: Monomial, divisor: int, positive: bool) -> Box:
        """Of base^(monomial/divisor): above 1, between 0 and 1, positive, or anything."""
        exponent = monomial_expr(monomial)
        if (near := _of_numbers(_power(base, exponent / divisor))) is not None:
            return near
        box = self._any(base, exponent)
        if not positive:
            return box
        grows = base == EULER or self.is_positive(base - 1)
        falls = not grows and self.is_positive(1 - base)
        up, down = self.is_positive(exponent), self.is_positive(neg(exponent))
        if (grows and up) or (falls and down):
            return replace(box, lower=Fraction(1))
        if (grows and down) or (falls and up):
            return replace(box, lower=Fraction(0), upper=Fraction(1))
        return replace(box, lower=Fraction(0))

    def tangent(self, monomial: Monomial, divisor: int, *, turned: bool) -> Box:
        """Of tan(monomial/(2 divisor)): between -1 and 1 less than a quarter of a turn from 0."""
        angle = monomial_expr(monomial)
        box = self._any(angle)
        turns = self.turns(monomial, divisor)
        if turns is not None:
            known = _half_a_turn_on(turns) if turned else turns
            return replace((known and half_tangent_of_turns(known)) or box, stated=box.stated)
        if turned:
            return box
        known = self.boxes.get(angle.name) if angle.kind == "symbol" else None
        found = None if known is None else half_tangent(known, divisor)
        if found is None and self.within(QUARTER, monomial, divisor):
            found = Box(lower=Fraction(-1), upper=Fraction(1))
        return replace(found or box, stated=box.stated)

    def turns(self, monomial: Monomial, divisor: int) -> Box | None:
        """Where the angle over pi lives, if it is pi times a symbol."""
        names = [base.name for base, n in monomial if base.kind == "symbol" and n == 1]
        if len(monomial) != 2 or len(names) != 2 or VARIABLE.name not in names:
            return None
        (name,) = set(names) - {VARIABLE.name}
        box = self.boxes.get(name)
        if box is None:
            return None
        lower, upper = (None if e is None else e / divisor for e in (box.lower, box.upper))
        return replace(box, lower=lower, upper=upper, integer=False)

    def is_below_half_turn(self, monomial: Monomial, divisor: int) -> bool:
        """Whether the angle monomial/divisor is known to lie between -pi and pi."""
        turns = self.turns(monomial, divisor)
        if turns is None or turns.lower is None or turns.upper is None:
            return self.within(HALF, monomial, divisor)
        above = turns.lower > -1 or (turns.lower == -1 and turns.lower_open)
        return above and (turns.upper < 1 or (turns.upper == 1 and turns.upper_open))

    def within(self, bound: Fraction, monomial: Monomial, divisor: int) -> bool:
        """Whether the angle monomial/divisor is known to lie between -bound and bound."""
        angle, most = monomial_expr(monomial), number(bound * divisor)
        return self.is_positive(most - angle) and self.is_positive(most + angle)

    def value(self, node: Expr) -> Box:
        """A logarithm is positive above 1, the angle of a tangent above 0, and so is the error
        function; both of these have bounds.
        """
        if (near := _of_numbers(node)) is not None:
            return near
        box = Box(stated=False) if self._is_open(node) else self._any(node)
        most = MOST.get(node.name)
        least = None if most is None else -most
        if is_series(node) or (not box.stated and node.name != "atan"):
            return replace(box, lower=least, upper=most)
        over = node.parts[0] - (1 if node.name == "log" else 0)
        if self.is_positive(over):
            return Box(lower=Fraction(0), upper=most, stated=box.stated)
        if self.is_positive(neg(over)):
            return Box(lower=least, upper=Fraction(0), stated=box.stated)
        return replace(box, lower=least, upper=most)

    def _any(self, *exprs: Expr) -> Box:
        names = symbols_of(*exprs) - {VARIABLE.name, EULER.name}
        return Box(stated=not names or any(self.boxes[n].stated for n in names if n in self.boxes))

    def _is_open(self, node: Expr) -> bool:
        """Whether a sum of one term of a sequence or more, whatever its bounds: the term with the
        greatest index is in it once, and of that one nothing is stated.
        """
        if node.name != "sum":
            return False
        summand, index, low, high = node.parts
        bare = rebuilt(summand, lambda n, _: number(1) if is_term(n) else None)
        return (
            not symbols_of(bare)
            and symbols_of(summand) == {index.name}
            and any(is_term(n) for n in walk(summand))
            and self.is_positive(high - low + 1)
        )


def _half_a_turn_on(turns: Box) -> Box | None:
    """Where an angle and half a turn more, or less, lies between half a turn back and one on."""
    if turns.lower is None or turns.upper is None:
        return None
    by = 1 if turns.upper <= 0 else -1
    return replace(turns, lower=turns.lower + by, upper=turns.upper + by)


def _power(base: Expr, exponent: Expr) -> Expr:
    parts = ("exp", (exponent,)) if base == EULER else ("power", (base, exponent))
    return Expr("call", *parts)


def _of_numbers(node: Expr) -> Box | None:
    """Two rationals around the value of a function of numbers, in which no symbol stands."""
    if symbols_of(node):
        return None
    try:
        ball = enclosed(node, {}, BITS)
    except (NoValue, Unresolved):
        return None
    if not ball.is_finite() or ball.is_exact():
        return None
    with flint.ctx.workprec(BITS):
        return Box(lower=exact_value(ball.lower()), upper=exact_value(ball.upper()))
