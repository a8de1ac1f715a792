"""Zeros between points at which an expression has opposite signs.

Along a line inside the domain the two points are brought together until a ball over all that lies
between them shows that every part has a value there: the expression is continuous then, and by the
intermediate value theorem it is 0 somewhere between.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain, islice, pairwise, product

import flint

from gainproof.verify.judge.exact.ball_text import value_shown
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared, sign_at
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.simple_points import simple_points
from gainproof.verify.judge.exact.statement import (
    STRICT,
    Enclosure,
    Outcome,
    Statement,
    Witness,
    refuted,
)
from gainproof.verify.judge.transcendental.algebraic_form import bound_names
from gainproof.verify.judge.transcendental.missing_values import factors, lacks
from gainproof.verify.judge.transcendental.special_points import lacking
from gainproof.verify.judge.verdict_words import LACKS_VALUE

PRECISION = 128
HALVINGS = 60
PARTS = 16
MOST_OF_GRID = 3
GRID = tuple(map(Fraction, ("0", "1", "-1", "2", "-2", "1/2", "-1/2", "3", "-3")))
BASES = 2
"""Simple points through which a line is laid in the direction of each symbol."""
STEPS = tuple(Fraction(n, 4) for n in (1, 2, 3, 4, 6, 8, 12, 16, 24, 40))


@dataclass(frozen=True)
class Crossing:
    """A zero of one symbol between two rationals, the other symbols being at a point."""

    name: str
    lower: Fraction
    upper: Fraction
    others: Mapping[str, Fraction]

    def values(self) -> dict[str, Fraction | Ball]:
        """Balls round all that lies between, and the other symbols."""
        with flint.ctx.workprec(PRECISION):
            ends = (flint.arb(rational(end)) for end in (self.lower, self.upper))
            between = next(ends).union(next(ends))
        return {**self.others, self.name: between}

    def point(self, zero: Expr, labels: Mapping[str, str]) -> dict[str, str]:
        """In words where it is."""
        near = f"a root of {labelled(zero, labels)} near {float(self.lower):.6g}"
        found = {n: str(v) for n, v in self.others.items()} | {self.name: near}
        return {labels.get(n, n): text for n, text in sorted(found.items())}


def without_value(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """`refuted` where what a side needs to be other than 0, in stated domains, changes its sign."""
    for rel, lack in lacking(statement, boxes):
        found = crossing(lack.zero, statement, boxes)
        if found is None:
            continue
        left, right = (
            Enclosure("", "", lack.reason)
            if lack in lacks(side)
            else value_shown(side, Balls(found.values(), PRECISION))
            for side in (rel.left, rel.right)
        )
        point = found.point(lack.zero, labels)
        witness = Witness(point, rel.operator, left, right, note=LACKS_VALUE)
        return refuted(witness, "a change of sign of what must not be 0")
    return None


def equal_sides(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """`refuted` where the difference of the sides of a strict relation, or of !=, is 0 as a factor
    of it changes its sign.
    """
    if statement.connective != "if" or bound_names(statement):
        return None
    for rel in statement.relations:
        if rel.operator not in STRICT:
            continue
        difference = rel.left if rel.right == number(0) else rel.left - rel.right
        found = crossing(difference, statement, boxes)
        if found is None:
            continue
        side = rel.right if rel.right.kind == "number" else rel.left
        both = value_shown(side, Balls(found.values(), PRECISION))
        note = "both sides are equal, by a change of sign"
        point = found.point(difference, labels)
        witness = Witness(point, rel.operator, both, both, exact=True, note=note)
        return refuted(witness, "a change of sign")
    return None


def fails_on_lines(statement: Statement, boxes: Boxes, labels: Mapping[str, str]) -> Outcome | None:
    """`refuted` by balls at points of these lines and of a small grid."""
    if statement.connective != "if" or bound_names(statement):
        return None
    names = sorted(statement.symbols())
    lines = (
        {**base, name: value}
        for base in islice(simple_points(names, boxes), BASES)
        for name in names
        for value in _spread(boxes.get(name, Box()))
    )
    for point in chain(lines, _grid(names, boxes)):
        witness = failure_at(statement, point, labels)
        if witness is not None:
            return refuted(witness, "balls at an exact point")
    return None


def crossing(zero: Expr, statement: Statement, boxes: Boxes) -> Crossing | None:
    """Where an expression is shown to be 0 in the domain; None if no change of sign is found."""
    names = sorted(statement.symbols())
    for part in factors(zero):
        for base in islice(simple_points(names, boxes), BASES):
            for name in sorted(symbols_of(part)):
                box = boxes.get(name, Box())
                if box.integer:
                    continue
                others = {n: v for n, v in base.items() if n != name}
                for ends in _opposite(part, name, others, box):
                    found = _narrowed(part, Crossing(name, *ends, others))
                    if found is not None and _has_values(found, zero, statement):
                        return found
    return None


def _opposite(
    zero: Expr, name: str, others: Mapping[str, Fraction], box: Box
) -> Iterator[tuple[Fraction, Fraction]]:
    """Neighbouring points at which it has opposite signs."""
    signs = [(at, sign_at(zero, {**others, name: at}, PRECISION)) for at in _spread(box)]
    known = [(at, sign) for at, sign in signs if sign]
    for (low, first), (high, second) in pairwise(known):
        if first != second:
            yield low, high


def _narrowed(zero: Expr, found: Crossing) -> Crossing | None:
    """With ends closer together; None where no sign is seen."""
    ends = halved(
        lambda at: sign_at(zero, {**found.others, found.name: at}, PRECISION),
        found.lower,
        found.upper,
        HALVINGS,
    )
    return None if ends[0] == ends[1] else replace(found, lower=ends[0], upper=ends[1])


def halved(
    sign: Callable[[Fraction], int], low: Fraction, high: Fraction, times: int
) -> tuple[Fraction, Fraction]:
    """Points of opposite signs between two such, as close together as so many halvings bring them;
    twice one point where the sign is 0, or not seen.
    """
    first = sign(low)
    for _ in range(times):
        middle = (low + high) / 2
        now = sign(middle)
        if not now:
            return middle, middle
        low, high = (middle, high) if now == first else (low, middle)
    return low, high


def _has_values(found: Crossing, zero: Expr, statement: Statement) -> bool:
    """Whether balls over all that lies between show values, and that all conditions hold."""
    balls = Balls(found.values(), PRECISION)
    try:
        if not balls.round(zero).is_finite():
            return False
        for needed in statement.needed:
            balls.round(needed)
        sides = ((r.operator, balls.round(r.left), balls.round(r.right)) for r in statement.domain)
        return all(compared(*each) for each in sides)
    except (NoValue, Unresolved):
        return False


def _spread(box: Box) -> list[Fraction]:
    """Numbers of a domain, closer together near 0 and near its ends."""
    steps = (Fraction(0), *STEPS, *(-step for step in STEPS))
    wanted = set(steps)
    if box.lower is not None and box.upper is not None:
        width = box.upper - box.lower
        wanted |= {box.lower + width * Fraction(k, PARTS) for k in range(PARTS + 1)}
    else:
        ends = [end for end in (box.lower, box.upper) if end is not None]
        wanted |= {end + step for end in ends for step in steps}
    return sorted(filter(box.holds, wanted))


def _grid(names: Sequence[str], boxes: Boxes) -> Iterator[dict[str, Fraction]]:
    """Small numbers for few symbols, not only whole ones."""
    if not 1 < len(names) <= MOST_OF_GRID:
        return
    choices = [list(filter(boxes.get(n, Box()).holds, GRID)) for n in names]
    for values in product(*choices):
        yield dict(zip(names, values, strict=True))
