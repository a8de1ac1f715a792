"""Generic exact points of a claim's domain: a formula that is false is seen to be false there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import ceil
from random import Random

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.balls import NoValue, Unresolved, compared, enclosed, sign_at
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Relation
from gainproof.verify.judge.hypotheses import solved
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.transcendental.sign_changes import halved

SEED = 7
TRIES = 300
PRECISION = 128
ROOT_BITS = 256
"""So near to it is a root that is no small rational number."""
GRID = 97
Point = Mapping[str, Fraction]


def generic_points(
    claim: Claim,
    conditions: Sequence[Relation],
    scope: Scope,
    count: int,
    *,
    far: bool = False,
) -> tuple[list[Point], dict[str, Expr]]:
    """Up to `count` points where all conditions of the claim hold, and what equations among these
    say of variables; `far` ones reach from near the ends of the domain to large numbers. Raises
    Undecided.
    """
    boxes, rest = _conditions(claim, conditions, scope)
    replaced, left = _solved(rest, boxes, scope)
    return _where(left, boxes, count, far=far), replaced


def free_points(
    claim: Claim,
    conditions: Sequence[Relation],
    scope: Scope,
    count: int,
    *,
    far: bool = False,
) -> list[Point]:
    """The points of `generic_points` if no equation among the conditions says what a variable is;
    else none. Raises Undecided.
    """
    boxes, rest = _conditions(claim, conditions, scope)
    # to solve an equation takes proofs
    if any(r.operator == "=" and symbols_of(r.left, r.right) for r in rest):
        return []
    left = [r for r in rest if r.operator != "="]
    return _where(left, boxes, count, far=far)


def _conditions(
    claim: Claim, conditions: Sequence[Relation], scope: Scope
) -> tuple[dict[str, Box], tuple[Rel, ...]]:
    """Boxes of the variables, and the conditions of the claim that boxes do not say."""
    stated = [scope.relation(r) for r in conditions]
    stated += [scope.relation(r) for r in claim.domain]
    for formula in claim.given:
        stated += [scope.relation(r) for r in formula.readings[0].relations]
    for token in list(scope.used):
        stated += [scope.relation(r) for r in scope.setting.symbols[token].domain]
    return bounded(scope.boxes(), stated)


def _where(left: Sequence[Rel], boxes: Mapping[str, Box], count: int, *, far: bool) -> list[Point]:
    """The first points of the boxes where relations hold."""
    found: list[Point] = []
    for point in _random(boxes, TRIES, far=far):
        if all(_holds(rel, point) for rel in left):
            found.append(point)
            if len(found) == count:
                break
    return found


def _solved(
    conditions: Sequence[Rel], boxes: Mapping[str, Box], scope: Scope
) -> tuple[dict[str, Expr], list[Rel]]:
    """Equations among the conditions, each solved for one variable."""
    rest = list(conditions)
    found: dict[str, Expr] = {}
    while equation := next((r for r in rest if r.operator == "="), None):
        rest.remove(equation)
        if not symbols_of(equation.left, equation.right):
            continue
        names = symbols_of(equation.left, equation.right)
        if len(names) == 1:
            (name,) = names
            value = _only_root(equation.left - equation.right, name, boxes.get(name, Box()))
        else:
            name, value = solved(equation, boxes, scope.environment.parameter, scope.labels())
        put_in = {name: value}
        found = {n: substituted(e, put_in) for n, e in found.items()} | put_in
        rest = [
            Rel(r.operator, substituted(r.left, put_in), substituted(r.right, put_in)) for r in rest
        ]
    return found, rest


def _only_root(expr: Expr, name: str, box: Box) -> Expr:
    """Where an expression in one variable changes its sign on a grid over its box, if it does so
    once: a small rational number if it is 0 there, else one near enough to tell numbers by. Raises
    Undecided.
    """

    def inside(share: Fraction) -> Fraction:
        low, high = box.lower, box.upper
        if low is not None and high is not None:
            return low + (high - low) * share
        if low is None and high is None:
            return (2 * share - 1) / (share * (1 - share))
        return low + share / (1 - share) if low is not None else (high or 0) - share / (1 - share)

    def sign(share: Fraction) -> int:
        return sign_at(expr, {name: inside(share)}, ROOT_BITS + PRECISION)

    # a prime number of parts: roots at nice places lie between
    grid = [Fraction(n, GRID) for n in range(1, GRID)]
    signs = [sign(share) for share in grid]
    steps = list(zip(grid, signs, grid[1:], signs[1:], strict=False))
    changes = [(a, b) for a, s, b, t in steps if s and t and s != t]
    if len(changes) != 1:
        raise Undecided("a hypothesis with one root on the domain is wanted")
    low, _ = halved(sign, *changes[0], ROOT_BITS)
    near = inside(low).limit_denominator(10**6)
    try:
        exact = enclosed(expr, {name: near}, ROOT_BITS + PRECISION).contains(0)
    except (NoValue, Unresolved):
        exact = False
    return number(near if exact else inside(low))


def _random(boxes: Mapping[str, Box], tries: int, *, far: bool) -> Iterator[Point]:
    source = Random(SEED)
    for attempt in range(tries):
        size = 1 + attempt // 60
        yield {name: _inside(box, source, size, far=far) for name, box in boxes.items()}


def _inside(box: Box, source: Random, size: int, *, far: bool) -> Fraction:
    """A number of the box with a denominator that no formula has."""
    share = Fraction(source.randrange(1, 997), 997)
    scale = Fraction(10) ** source.randrange(-5, 6) if far else Fraction(1)
    if box.integer:
        low = 0 if box.lower is None else ceil(box.lower) + int(box.lower_open)
        if box.upper is None:
            return Fraction(low + source.randrange(1, 12 * size) * max(1, int(scale)))
        return Fraction(low + source.randrange(0, max(1, int(box.upper) - low + 1)))
    if box.lower is not None and box.upper is not None:
        near = share * scale / (1 + share * scale) if far else share
        return box.lower + (box.upper - box.lower) * near
    reach = (share * source.choice((2, 5, 9 * size)) + Fraction(1, 89)) * scale
    if box.lower is not None:
        return box.lower + reach
    if box.upper is not None:
        return box.upper - reach
    # unstated symbols stand for gains and lengths more often than not
    return -reach if source.random() < 0.2 * (size - 1) else reach


def _holds(rel: Rel, point: Point) -> bool:
    try:
        a, b = (enclosed(side, point, PRECISION) for side in (rel.left, rel.right))
    except (NoValue, Unresolved, Undecided):
        return False
    return bool(compared(rel.operator, a, b))
