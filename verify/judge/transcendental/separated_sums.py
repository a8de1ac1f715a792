"""Sums of terms that share no symbol: each sum becomes one variable, at or above its least value.

The least value of f(x) + g(y) is that of f and that of g together. What holds for every u from that
value on holds for the sum, whatever x and y are; and where each term has its least value the sum
does, so that a divisor f(x) + g(y) with the least value 0 is 0 somewhere. Both are seen in one
symbol at a time, where cells of all of them take long.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import lru_cache

from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, add, mul, number, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.transcendental.lowest_points import lowest
from gainproof.verify.judge.transcendental.missing_values import lacks

LEAST = 3
"""Symbols of a statement: with less, cells are as fast."""
MOST_TOGETHER = 2
"""Symbols of one term."""
BITS = 64
DENOMINATOR = 64
NEAR = 1e-9
MARGIN = Fraction(1, 1000)
FAR = Fraction(10**6)

Terms = list[tuple[Fraction, Expr]]
"""With their factors."""


@dataclass(frozen=True)
class Least:
    """A number that a term is nowhere below, and whether it has that value; None if not known."""

    value: Fraction
    attained: bool | None


@dataclass(frozen=True)
class Sum:
    """Terms without their constant, which have values everywhere, each once with its factor, and
    the least value.
    """

    terms: frozenset[tuple[Expr, Fraction]]
    names: frozenset[str]
    least: Least
    whole: Expr = field(compare=False)


def by_sums(
    statement: Statement, boxes: Boxes, parameter: str | None, labels: Mapping[str, str]
) -> Outcome | None:
    """Proved with sums as variables; None if they do not tell. Raises Undecided if the statement is
    seen to fail, or to have no value, where a sum has its least value.
    """
    if statement.connective != "if" or len(statement.symbols()) < LEAST:
        return None
    sums = dict(_sums(statement, boxes))
    if not sums:
        return None
    taken = symbols_of(*[side for rel in statement.domain for side in (rel.left, rel.right)])
    free = {node: found for node, found in sums.items() if not found[0].names & taken}
    if _has_zero_divisor(statement, boxes, free):
        raise Undecided("a divisor is zero where each of its terms is least")
    names = {
        found: f"sum {k}" for k, found in enumerate(dict.fromkeys(s for s, _ in sums.values()))
    }

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        if node not in sums:
            return None
        found, constant = sums[node]
        return add(symbol(names[found]), number(constant))

    labels = {**labels, **{name: f"({labelled(s.whole, labels)})" for s, name in names.items()}}
    moved = statement.mapped(lambda e: rebuilt(e, change))
    where = {**boxes, **{name: _box(found, boxes) for found, name in names.items()}}
    found = settle(moved, where, parameter, labels, only_proof=True)
    if found.verdict == "proved":
        return replace(found, method=f"sums of terms in symbols of their own; {found.method}")
    own = [name for each in names for name in each.names]
    # sums in common symbols need not have their least values at one point
    if len(set(own)) < len(own) or (taken | moved.symbols()) & set(own):
        return None
    if all(each.least.attained for each in names):
        point = {
            name: replace(where[name], lower_open=False, upper=each.least.value, upper_open=False)
            for each, name in names.items()
        }
        there = settle(moved, {**where, **point}, parameter, labels, only_proof=True)
        if there.verdict in ("refuted", "conditional"):
            raise Undecided("it fails where each term of a sum is least")
    return None


def _sums(statement: Statement, boxes: Boxes) -> Iterator[tuple[Expr, tuple[Sum, Fraction]]]:
    """The outermost sums in two symbols or more of which a least value is known, each with what is
    to be added.
    """
    waiting = list(statement.exprs())
    seen: set[Expr] = set()
    while waiting:
        node = waiting.pop()
        if node in seen:
            continue
        seen.add(node)
        found = _sum(node, boxes) if node.kind == "add" else None
        if found is None:
            waiting += node.parts
        else:
            yield node, found


def _sum(node: Expr, boxes: Boxes) -> tuple[Sum, Fraction] | None:
    names = symbols_of(node)
    if len(names) < 2 or any(boxes.get(n, Box()).integer for n in names):
        return None
    constant, terms = _terms(node, Fraction(1))
    parts = _apart(terms)
    if len(parts) < 2 or any(not 0 < len(symbols_of(p)) <= MOST_TOGETHER for p in parts):
        return None
    total = Fraction(0)
    attained: bool | None = True
    for part in parts:
        least = _least(part, tuple((n, boxes.get(n, Box())) for n in sorted(symbols_of(part))))
        if least is None:
            return None
        total += least.value
        if least.attained is False or attained is False:
            attained = False
        elif least.attained is None:
            attained = None
    together: dict[Expr, Fraction] = {}
    for factor, term in terms:
        together[term] = together.get(term, Fraction(0)) + factor
    whole = add(*[t if factor == 1 else mul(number(factor), t) for t, factor in together.items()])
    least = Least(total, attained)
    return Sum(frozenset(together.items()), frozenset(names), least, whole), constant


def _terms(expr: Expr, factor: Fraction) -> tuple[Fraction, Terms]:
    """The constant and all terms of the expression times a number."""
    match expr.kind:
        case "number":
            return factor * expr.fraction, []
        case "neg":
            return _terms(expr.parts[0], -factor)
        case "add":
            found = [_terms(part, factor) for part in expr.parts]
            return sum((c for c, _ in found), Fraction(0)), [t for _, each in found for t in each]
        case "mul":
            numbers = [part.fraction for part in expr.parts if part.kind == "number"]
            others = [part for part in expr.parts if part.kind != "number"]
            # a term with the factor 0 stays one: it may have no value
            if len(others) == 1:
                for each in numbers:
                    factor *= each
                return _terms(others[0], factor)
    return Fraction(0), [(factor, expr)]


def _apart(terms: Terms) -> list[Expr]:
    """The terms put together where they have symbols in common."""
    groups: list[tuple[set[str], list[Expr]]] = []
    for factor, term in terms:
        names, members = symbols_of(term), [mul(number(factor), term)]
        for other in [g for g in groups if g[0] & names]:
            groups.remove(other)
            names, members = names | other[0], other[1] + members
        groups.append((names, members))
    return [add(*members) for _, members in groups]


@lru_cache(maxsize=1 << 10)
def _least(term: Expr, boxes: tuple[tuple[str, Box], ...]) -> Least | None:
    """None if no such number is found; the term has a value everywhere in the boxes."""
    where = {name: replace(box, stated=True) for name, box in boxes}

    def holds(operator: str, value: Fraction) -> bool | None:
        asked = Statement((Rel(operator, term, number(value)),))
        try:
            return settle(asked, where, None, {}, only_proof=True).verdict == "proved"
        except Undecided:
            return None

    for value in _guesses(term, where):
        if holds(">=", value):
            above = holds(">", value)
            return Least(value, None if above is None else not above)
    return None


def _guesses(term: Expr, boxes: Boxes) -> list[Fraction]:
    """What the least value may be, then a number below it."""
    if len(boxes) != 1:
        return [Fraction(0)]
    ((name, box),) = boxes.items()
    ends = [end for end in (box.lower, box.upper) if end is not None]
    far = [(box.lower or 0) + FAR] if box.upper is None else []
    far += [(box.upper or 0) - FAR] if box.lower is None else []
    points = [*lowest(term, name, box), *ends, *far]
    values = [v for v in (_value(term, name, point) for point in points) if v is not None]
    if not values:
        return [Fraction(0)]
    near = Fraction(min(values))
    simple = near.limit_denominator(DENOMINATOR)
    return [simple, (near - MARGIN).limit_denominator(DENOMINATOR**2)]


def _value(term: Expr, name: str, at: Fraction) -> float | None:
    try:
        ball = enclosed(term, {name: at}, BITS)
    except (NoValue, Unresolved):
        return None
    return float(ball.mid()) if ball.is_finite() else None


def _box(found: Sum, boxes: Boxes) -> Box:
    """Stated if any of its symbols is."""
    stated = any(boxes.get(n, Box()).stated for n in found.names)
    return Box(found.least.value, None, lower_open=found.least.attained is False, stated=stated)


def _has_zero_divisor(
    statement: Statement, boxes: Boxes, sums: Mapping[Expr, tuple[Sum, Fraction]]
) -> bool:
    """Whether a divisor of what is asked is 0 at a point of stated domains."""
    sides = [side for rel in statement.relations for side in (rel.left, rel.right)]
    for expr in (*sides, *statement.needed):
        for lack in lacks(expr):
            found = sums.get(lack.zero)
            if found is None or not all(boxes.get(n, Box()).stated for n in found[0].names):
                continue
            if found[0].least.attained and found[0].least.value + found[1] == 0:
                return True
    return False
