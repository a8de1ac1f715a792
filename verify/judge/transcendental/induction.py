"""Identities with sums and products up to a symbol, by induction over it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    neg,
    number,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.expression_text import is_series
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.meaning.sums import MOST_SHIFT, series_of


def open_sums(statement: Statement) -> list[Expr]:
    """The sums and products that have no closed form here."""
    return [n for n in walk(*statement.exprs()) if is_series(n)]


def induction(
    statement: Statement, boxes: Mapping[str, Box]
) -> list[tuple[str, Statement, Mapping[str, Box]]]:
    """What has to be decided, in words, as statements, with the domains: the first number, and the
    step to each next one. Raises Undecided where the statement has another form.
    """
    sums = open_sums(statement)
    name = _variable(sums, boxes)
    box = boxes[name]
    if not box.integer or box.lower is None:
        raise Undecided(f"an induction over {name} without a first number")
    if any(name in symbols_of(c.left, c.right) for c in (*statement.conditions, *statement.given)):
        raise Undecided(f"an induction over {name} under conditions on it")
    if any(r.operator != "=" for r in statement.relations) or statement.connective != "if":
        raise Undecided("an induction for anything but identities")
    start = Fraction(-(-box.lower.numerator // box.lower.denominator))
    if box.lower_open and start == box.lower:
        start += 1
    first = statement.mapped(lambda e: _written_out(e, name, start))
    steps, needed = [], list(statement.needed)
    for difference in (add(r.left, neg(r.right)) for r in statement.relations):
        if any(n.name == "product" for n in walk(difference) if is_series(n)):
            rels, values = _product_step(difference, name)
            steps += rels
            needed += values
        else:
            steps.append(Rel("=", _step(difference, name), number(0)))
    later = replace(box, lower=start + 1, lower_open=False)
    others = {n: b for n, b in boxes.items() if n != name}
    step = Statement(tuple(steps), statement.conditions, "if", tuple(needed))
    return [
        (f"for the first number {start}", first, others),
        ("from each number to the next", step, {**boxes, name: later}),
    ]


def _variable(sums: list[Expr], boxes: Mapping[str, Box]) -> str:
    names = {n for s in sums for n in symbols_of(s.parts[3]) if boxes.get(n, Box()).integer}
    if len(names) != 1:
        raise Undecided("sums or products whose upper bounds hold several symbols or none")
    return names.pop()


def _written_out(expr: Expr, name: str, value: Fraction) -> Expr:
    """The expression at one number; all bounds must be numbers then."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return series_of(node.name, parts)[0] if is_series(node) else None

    return rebuilt(substituted(expr, {name: number(value)}), change)


def _step(expr: Expr, name: str) -> Expr:
    """expr(k) - expr(k - 1), each sum up to k - 1 written as the one up to k without its last
    term.
    """
    before = substituted(expr, {name: symbol(name) - 1})
    last: dict[bytes, Expr] = {}
    for node in walk(expr):
        if node.kind == "call" and node.name == "sum":
            summand, index, low, high = node.parts
            offset = constant_value(substituted(high - symbol(name), {name: number(0)}))
            shifted = substituted(high, {name: symbol(name) + 1}) - high - 1
            slope = constant_value(substituted(shifted, {name: number(0)}))
            if offset is None or slope != 0 or not _is_line(high, name):
                raise Undecided("a sum whose upper bound is not the number itself plus a constant")
            if name in symbols_of(low) or name in symbols_of(summand):
                raise Undecided("a sum whose terms or lower bound depend on its upper bound")
            earlier = substituted(node, {name: symbol(name) - 1})
            last[earlier.key] = node - substituted(summand, {index.name: high})

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        return last.get(node.key)

    return expr - rebuilt(before, change)


def _product_step(expr: Expr, name: str) -> tuple[list[Rel], list[Expr]]:
    """That expr(k) = 0 follows from expr(k - 1) = 0, for an expression a p + b of one product p,
    and what must have values for it: b(k - 1) a'(k) = a(k - 1) b(k) with a(k - 1) not zero, where
    a' holds the factors that p(k) has more.
    """
    (node, *others) = dict.fromkeys(n for n in walk(expr) if is_series(n))
    if others:
        raise Undecided("an induction over several products, or a product beside a sum")
    factor, index, low, high = node.parts
    line = coefficients(high, name) or {}
    more = constant_value(line.get(1, number(0))) or Fraction(0)
    if set(line) - {0, 1} or more.denominator != 1 or not 1 <= more <= MOST_SHIFT:
        raise Undecided("a product whose upper bound does not rise by a few with the number")
    if name in symbols_of(low) or name in symbols_of(factor):
        raise Undecided("a product whose factors or lower bound depend on its upper bound")
    so_far = symbol("product so far")
    known = coefficients(
        rebuilt(expr, lambda n, _: so_far if n.key == node.key else None), so_far.name
    )
    if known is None or set(known) - {0, 1}:
        raise Undecided("a product that stands in a divisor, root, power or function")
    slope, rest = (known.get(power, number(0)) for power in (1, 0))
    earlier = {name: symbol(name) - 1}
    slope_before, rest_before = substituted(slope, earlier), substituted(rest, earlier)
    last = [substituted(factor, {index.name: high - j if j else high}) for j in range(int(more))]
    steps = [
        Rel("=", mul(rest_before, slope, *last), mul(slope_before, rest)),
        Rel("!=", slope_before, number(0)),
    ]
    return steps, [*last, slope, rest, rest_before]


def _is_line(expr: Expr, name: str) -> bool:
    """Whether a sum of symbols and numbers only."""
    return all(n.kind in ("add", "neg", "symbol", "number") for n in walk(expr)) and symbols_of(
        expr
    ) == {name}
