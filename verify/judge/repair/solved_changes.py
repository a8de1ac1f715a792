"""What would make a formula true: one number, exponent, factor or term, solved for at each point
and recognised.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Protocol

import flint

from gainproof.verify.judge.exact.expression import Expr, number, power, symbols_of
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.repair.edits import LARGE, PLAIN, Table
from gainproof.verify.judge.repair.formula_values import PRECISION, Values, combined
from gainproof.verify.judge.repair.number_changes import MOST_EXPONENT
from gainproof.verify.judge.repair.number_recognition import common_rational, monomial
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.requested_operations import open_places, open_sides
from gainproof.verify.judge.repair.tree_construction import (
    ONE,
    Path,
    multiplied,
    opposite,
    product,
    quotient,
    raised,
    replaced,
    total,
    without,
)
from gainproof.verify.judge.repair.whole_formula import Change, Step

STEPS = 40
LEAST_POINTS = 4
"""At fewer points anything is a monomial."""
Rule = Callable[[Ball, Ball], Ball]


class Context(Protocol):
    """What closings and pairs of edits need to know of a search."""

    formula: Printed
    table: Table
    numbers: frozenset[str]
    points: list[Values]

    @property
    def is_late(self) -> bool:
        """Whether the time is over."""
        ...


def closings(context: Context) -> Iterator[Change]:
    """Formulas with one thing solved for; only for one equation."""
    formula = context.formula
    if len(formula.links) != 1 or formula.links[0].operator != "=":
        return
    yield from _numbers(context)
    if len(context.points) < LEAST_POINTS:
        return
    names = context.table.symbols
    at = [[values.symbol(name) for values in context.points] for name in names]
    known = [(n, column) for n, column in zip(names, at, strict=True) if None not in column]
    tokens, columns = [n for n, _ in known], [column for _, column in known]
    for side in open_sides(formula):
        for path, node in (
            open_places(formula.sides[side]) if symbols_of(formula.sides[side]) else ()
        ):
            if context.is_late:
                return
            above = _above(formula.sides[side], path)
            for rule, make, weight, what in _holes(node, above):
                found = _solved(context, side, path, rule)
                if found is None:
                    continue
                # a rational number is told by more bits than flint works with by itself
                with flint.ctx.workprec(PRECISION):
                    new = make(found, tokens, columns)
                # a term that is 0 is a part too many, which is an edit
                if new is None or new == node or (path and new == number(0)):
                    continue
                changed = formula.with_side(side, replaced(formula.sides[side], path, new))
                step = Step(what, node, new)
                if not path and (turned := _turned(formula, side, new)) is not None:
                    changed, step = turned
                yield Change(changed, weight, (step,))


def _turned(formula: Printed, side: int, new: Expr) -> tuple[Printed, Step] | None:
    """A side that was a symbol x and would be y/x, put the way it was printed: x = y over the other
    side.
    """
    before = formula.sides[side]
    if before.kind != "symbol" or new.kind != "div":
        return None
    above, below = new.parts
    factors = below.parts if below.kind == "mul" else (below,)
    if before not in factors:
        return None
    kept = quotient(above, product(*without(factors, factors.index(before))))
    link = formula.links[0]
    other = link.right if side == link.left else link.left
    old = formula.sides[other]
    top, bottom = old.parts if old.kind == "div" else (old, ONE)
    made = multiplied(quotient(bottom, top), kept)
    return formula.with_side(other, made), Step("upside down, with a factor", old, made)


def _numbers(context: Context) -> Iterator[Change]:
    """A side that is a number, however printed, as the number that the other side is."""
    formula = context.formula
    for side in open_sides(formula):
        before = formula.sides[side]
        if symbols_of(before):
            continue
        found = _solved(context, side, (), lambda _, h: h)
        new = None if found is None else number_filled(found)
        if new is not None and new != before:
            yield Change(formula.with_side(side, new), PLAIN, (Step("a number", before, new),))


Make = Callable[[Sequence[Ball], Sequence[str], Sequence[Sequence[Ball]]], Expr | None]


def _above(expr: Expr, path: Path) -> str:
    """The kind of the node that holds the one at `path`; empty for a whole side."""
    kind = ""
    for k in path:
        kind, expr = expr.kind, expr.parts[k]
    return kind


def _holes(node: Expr, above: str) -> Iterator[tuple[Rule, Make, int, str]]:
    """How a hole enters at a node, and the node with the hole filled. A factor of a factor is one
    of the whole product.
    """
    if node.kind == "number":
        yield lambda _, h: h, number_filled, PLAIN, "a number"
        return
    if node.kind == "pow":
        yield (
            lambda x, h: (h * x.log() / rational(node.fraction)).exp(),
            lambda found, *_: exponent_filled(node, found),
            PLAIN,
            "an exponent",
        )
    if above not in ("mul", "div", "neg"):
        yield (
            lambda x, h: h * x,
            lambda found, names, at: _times(node, monomial(found, names, at)),
            LARGE,
            "a factor",
        )
    yield (
        lambda x, h: h + x,
        lambda found, names, at: plus_filled(node, monomial(found, names, at)),
        LARGE,
        "a missing term",
    )


def _times(node: Expr, factor: Expr | None) -> Expr | None:
    return None if factor is None else multiplied(node, factor)


def _solved(context: Context, side: int, path: Path, rule: Rule) -> list[Ball] | None:
    """The value of the hole at each point, or None."""
    found = []
    for values in context.points:
        with flint.ctx.workprec(values.precision):
            value = _at_point(values, context.formula, side, path, rule)
        if value is None:
            return None
        found.append(value)
    return found


def _at_point(values: Values, formula: Printed, side: int, path: Path, rule: Rule) -> Ball | None:
    link = formula.links[0]
    other = values.ball(formula.sides[link.left if side == link.right else link.right])
    chain = [formula.sides[side]]
    for k in path:
        chain.append(chain[-1].parts[k])
    start = values.ball(chain[-1])
    if other is None or start is None:
        return None

    def difference(h: Ball) -> Ball | None:
        value: Ball | None = rule(start, h)
        for node, k in zip(reversed(chain[:-1]), reversed(path), strict=True):
            parts = [value if j == k else values.ball(p) for j, p in enumerate(node.parts)]
            if any(p is None or not p.is_finite() for p in parts):
                return None
            value = combined(node, parts)
        return None if value is None else (value - other).mid()

    return root(difference)


def root(f: Callable[[Ball], Ball | None]) -> Ball | None:
    """A zero by secants, from two starts near one; None if none is reached."""
    a, b = flint.arb(flint.fmpq(9, 10)), flint.arb(flint.fmpq(11, 10))
    at_a, at_b = f(a), f(b)
    for _ in range(STEPS):
        if at_a is None or at_b is None or not at_b.is_finite():
            return None
        if at_b.is_zero():
            return b
        slope = at_b - at_a
        if slope.contains(0):
            return None
        step = (at_b * (b - a) / slope).mid()
        if not step.is_finite() or abs(b) > 10**6:
            return None
        a, at_a, b = b, at_b, (b - step).mid()
        if abs(step) * 2**90 < abs(b) + flint.arb(2) ** -60:
            return b
        at_b = f(b)
    return None


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
