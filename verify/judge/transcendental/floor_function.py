"""Whole parts as whole numbers: that of a x + b is a whole number n where x is (n + t - b)/a with
0 <= t < 1, and of what is seen to lie between whole numbers it is one of these.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from math import inf

from gainproof.verify.judge.domain import box_conditions
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared, enclosed
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    neg,
    number,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.expression import walk as nodes
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.functions import has_jumps
from gainproof.verify.judge.exact.simple_points import simple_points
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.meaning.base_variables import is_whole
from gainproof.verify.judge.transcendental.domain_parts import (
    ABOVE,
    WHOLE,
    ZERO,
    Holds,
    Part,
    line_in,
    opposite,
    summed,
)
from gainproof.verify.judge.transcendental.monomials import (
    UNIT,
    monomial_expr,
    monomials,
    terms_expr,
)

MOST_STEPS = 4
"""Whole numbers that a whole part may be, for it to be looked at one by one."""
PRECISION = 128


def whole_parts(part: Part, node: Expr, holds: Holds) -> Iterator[Part | None]:
    terms = monomials(node.parts[0])
    unit = terms.pop(UNIT, Fraction(0))
    whole = {
        m: c
        for m, c in terms.items()
        if c.denominator == 1 and is_whole(monomial_expr(m), part.boxes)
    }
    rest = {m: c for m, c in terms.items() if m not in whole}
    over, outside = summed({**rest, UNIT: unit % 1}), summed({**whole, UNIT: unit - unit % 1})
    known = _floor_at(over, {})
    if known is not None:
        yield part.put_in(node, add(outside, number(known)))
        return
    steps = _steps(part, over, holds)
    for k in steps or ():
        kept = [
            rel
            for rel in (Rel(">=", over, number(k)), Rel("<", over, number(k + 1)))
            if not holds(rel, part)
        ]
        narrowed = part.under(*kept)
        if narrowed is not None and not any(holds(opposite(rel), part) for rel in kept):
            yield narrowed.put_in(node, add(outside, number(k)))
    replaced = [] if steps else _in_steps(part, holds)
    yield from replaced
    if steps or replaced:
        return
    n = symbol(f"{WHOLE}{labelled(over, part.labels)}")
    boxes = {**part.boxes, n.name: Box(integer=True, stated=_is_stated(part, over))}
    labels = {**part.labels, n.name: f"floor({labelled(over, part.labels)})"}
    within = replace(part, boxes=boxes, labels=labels)
    for rel in (Rel("<=", n, over), Rel("<", over, n + 1)):
        given = (*within.statement.given, rel)
        within = replace(within, statement=replace(within.statement, given=given))
    yield within.put_in(node, add(outside, n))


def _is_stated(part: Part, expr: Expr) -> bool:
    return any(part.boxes.get(name, Box(stated=False)).stated for name in symbols_of(expr))


def _floor_at(expr: Expr, point: Mapping[str, Fraction]) -> int | None:
    """The whole part at a point; None where balls do not tell."""
    with suppress(NoValue, Unresolved):
        found = enclosed(Expr("call", "floor", (expr,)), point, PRECISION).unique_fmpz()
        return None if found is None else int(found)
    return None


def _steps(part: Part, over: Expr, holds: Holds) -> range | None:
    """The few whole numbers that its whole part may be; None where they are not few, or not seen to
    be all.
    """
    statement, boxes = part.within()
    seen = set[int]()
    for point in simple_points(sorted(statement.symbols()), boxes):
        balls = Balls(point, PRECISION)
        with suppress(NoValue, Unresolved):
            sides = (
                (r.operator, balls.round(r.left), balls.round(r.right)) for r in statement.domain
            )
            if all(compared(*each) for each in sides):
                known = _floor_at(over, point)
                seen |= set() if known is None else {known}
        if len(seen) > MOST_STEPS or (seen and max(seen) - min(seen) > MOST_STEPS):
            return None
    if not seen:
        return None
    first = next(
        (k for k in (min(seen), min(seen) - 1) if holds(Rel(">=", over, number(k)), part)), None
    )
    last = next(
        (k for k in (max(seen), max(seen) + 1) if holds(Rel("<", over, number(k + 1)), part)), None
    )
    return None if first is None or last is None else range(first, last + 1)


def _in_steps(part: Part, holds: Holds) -> list[Part | None]:
    """With a symbol replaced, in which the argument of a whole part is of first degree, by that
    whole part alone, and by it and what is above it; empty where there is none. Of several by those
    with the longest steps, which the others divide.
    """
    best: tuple[float, str, Expr, Expr, Expr] | None = None
    for node in nodes(*part.statement.exprs()):
        inner = any(has_jumps(each) for below in node.parts for each in nodes(below))
        if not has_jumps(node) or node.name != "floor" or inner:
            continue
        (over,) = node.parts
        for name in sorted(symbols_of(over)):
            line = line_in(over, name)
            if (
                line is None
                or name.startswith((WHOLE, ABOVE))
                or part.boxes.get(name, Box()).integer
            ):
                continue
            factor, rest = line
            if any(holds(Rel(operator, factor, ZERO), part) for operator in (">", "<")):
                size = _size(factor)
                if best is None or size < best[0]:
                    best = size, name, over, factor, rest
    if best is None:
        return []
    _, name, over, factor, rest = best
    text = labelled(over, part.labels)
    n, t = symbol(f"{WHOLE}{text}"), symbol(f"{ABOVE}{text}")
    box = part.boxes.get(name, Box(stated=False))
    boxes = {k: b for k, b in part.boxes.items() if k != name}
    boxes[n.name] = Box(integer=True, stated=box.stated)
    boxes[t.name] = Box(Fraction(0), Fraction(1), lower_open=False, stated=box.stated)
    labels = {**part.labels, n.name: f"floor({text})", t.name: f"mod({text}, 1)"}
    found = []
    for letters, sign in (((n,), 0), ((n, t), 1)):
        value = terms_expr(monomials(div(add(*letters, neg(rest)), factor)))
        put_in = partial(substituted, values={name: value})
        within = replace(
            part,
            statement=part.statement.mapped(put_in),
            boxes=boxes,
            labels=labels,
            told={(t, ZERO): frozenset((sign,))},
            back={k: put_in(e) for k, e in {name: symbol(name), **part.back}.items()},
            steps=(*part.steps, over),
        )
        moved = [Rel(r.operator, put_in(r.left), put_in(r.right)) for r in part.conditions]
        found.append(within.under(*moved, *box_conditions(name, value, box)))
    return found


def _size(factor: Expr) -> float:
    with suppress(NoValue, Unresolved):
        return abs(float(enclosed(factor, {}, PRECISION).mid()))
    return inf
