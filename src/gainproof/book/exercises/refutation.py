"""Exact counterexamples to relations of a certificate: a rational point of the tower at which the
two sides lie in balls that do not overlap.

The balls are enclosures (python-flint), evaluated straight from the formulas as they are written;
the values of roots and elements are those that the tower defines. Nothing is rounded on the way to
a conclusion, and what is not separated is not called false.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from gainproof.book.exercises.tower_values import TowerValues
from gainproof.verify.judge.exact.ball_text import enclosure, separated
from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, add, number, symbols_of
from gainproof.verify.judge.exact.expression_graph import read_values
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.statement import Enclosure
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided

PRECISIONS = (128, 512)
DIGITS, MOST_NAMES = 8, 6
TERMS = 4
"""How many terms of a sum are added up for its witness, after the first."""

Claim = Mapping[str, Any]


@dataclass(frozen=True)
class Witness:
    """The point, and what the two sides are there, as decimal text that encloses them (`midpoint`
    and `radius`). `shape`: how the sides should stand to each other; `entry`: row and column, where
    they are entries of matrices. `names`: what the names of the relation are there that the point
    does not give, as far as they are few.
    """

    shape: str
    point: Mapping[str, str]
    left: Mapping[str, str]
    right: Mapping[str, str]
    entry: str = ""
    names: Mapping[str, Mapping[str, str]] = field(default_factory=dict)

    def plain(self) -> dict[str, Any]:
        """As plain data."""
        return {
            "shape": self.shape,
            "point": dict(self.point),
            "left": dict(self.left),
            "right": dict(self.right),
            "entry": self.entry,
            "names": {name: dict(value) for name, value in self.names.items()},
        }


def refuted(kind: str, claim: Claim, tower: TowerValues, proved: Claim) -> Witness | None:
    """A counterexample to a relation, or None where none is found.

    `proved`: the relation of the same kind that the checker has proved in its place; the limit that
    an expression has is known from it.
    """
    try:
        witness = _refuted(kind, claim, tower, proved)
    except (Undecided, Malformed):
        return None
    if witness is None or kind in ("limit", "sum"):
        return witness
    return replace(witness, names=_names(kind, claim, tower, witness.point))


def _refuted(kind: str, claim: Claim, tower: TowerValues, proved: Claim) -> Witness | None:
    match kind:
        case "equal":
            return _unequal(claim, tower)
        case "positive":
            return _negative(claim, tower)
        case "limit":
            return _other_limit(claim, tower, proved)
        case "monotone":
            return _other_trend(claim, tower)
        case "sum":
            return _other_sum(claim, tower)
        case _:
            return None


def _names(
    kind: str, claim: Claim, tower: TowerValues, point: Mapping[str, str]
) -> dict[str, dict[str, str]]:
    """The values of the relation's names at a point that gives the parameters."""
    fields = ("left", "right") if kind == "equal" else ("expression",)
    nodes = [node for field_ in fields for node in claim[field_]["nodes"]]
    told = sorted({node[1] for node in nodes if node[0] == "symbol"} - set(point))
    known = {name: Fraction(value) for name, value in point.items()}
    found = {}
    for name in told:
        value = tower.values.get(name)
        if value is None or not symbols_of(value) <= set(known):
            continue
        try:
            found[name] = _side(enclosure(enclosed(value, known, PRECISIONS[0]), DIGITS))
        except (NoValue, Unresolved):
            continue
    return found if len(found) <= MOST_NAMES else {}


def _unequal(claim: Claim, tower: TowerValues) -> Witness | None:
    free = tuple(claim["free"])
    left, right = (_entries(claim[side]) for side in ("left", "right"))
    if left.keys() != right.keys():
        return None
    for entry in left:
        one, other = (tower.resolved(side[entry], free) for side in (left, right))
        for point, (a, b) in _balls(tower, free, one, other):
            shown = separated(a, b)
            if shown is not None:
                return _witness("equal", _told(point), shown, entry)
    return None


def _entries(graph: Claim) -> dict[str, Expr]:
    """The entries of a matrix by row and column; a formula is the only entry, without a place."""
    value = read_values(graph)["value"]
    if isinstance(value, Expr):
        return {"": value}
    return {f"{i},{j}": entry for i, row in enumerate(value, 1) for j, entry in enumerate(row, 1)}


def _negative(claim: Claim, tower: TowerValues) -> Witness | None:
    value = tower.resolved(read_tree(claim["expression"]))
    for point, (ball, zero) in _balls(tower, (), value, number(0)):
        if ball < 0:
            shown = separated(ball, zero)
            if shown is not None:
                return _witness("positive", _told(point), shown)
    return None


def _other_limit(claim: Claim, tower: TowerValues, proved: Claim) -> Witness | None:
    """A limit is one number: another than the proved one is none."""
    same = ("expression", "variable", "point")
    if any(claim[field] != proved[field] for field in same):
        return None
    if any(isinstance(each["value"], str) for each in (claim, proved)):
        return None
    found = tower.resolved(read_tree(proved["value"]))
    told = tower.resolved(read_tree(claim["value"]))
    for point, (a, b) in _balls(tower, (), found, told):
        shown = separated(a, b)
        if shown is not None:
            return _witness("limit", _told(point), shown)
    return None


def _other_trend(claim: Claim, tower: TowerValues) -> Witness | None:
    slope = tower.slope(read_tree(claim["expression"]), claim["variable"])
    for point, (ball, zero) in _balls(tower, (), slope, number(0)):
        if (ball < 0) if claim["trend"] == "increasing" else (ball > 0):
            shown = separated(ball, zero)
            if shown is not None:
                shape = f"monotone {claim['trend']}"
                return _witness(shape, _told(point), shown)
    return None


def _other_sum(claim: Claim, tower: TowerValues) -> Witness | None:
    """Terms added up one by one, to the first upper end at which the closed form is another."""
    index, upper, start = claim["index"], claim["upper"], int(claim["start"])
    term = tower.resolved(read_tree(claim["summand"]), (index,))
    closed = tower.resolved(read_tree(claim["closed"]))
    first = max(start, int(tower.boxes[upper].lower or 0))
    for last in range(first, first + TERMS):
        known = {upper: number(last)}
        terms = [substituted(term, {**known, index: number(k)}) for k in range(start, last + 1)]
        total, told = add(*terms), substituted(closed, known)
        if symbols_of(total, told):
            return None
        for _, (a, b) in _balls(tower, (), total, told):
            shown = separated(a, b)
            if shown is not None:
                return _witness("sum", {upper: str(last)}, shown)
    return None


def _balls(
    tower: TowerValues, free: Sequence[str], one: Expr, other: Expr
) -> Iterator[tuple[dict[str, Fraction], tuple[Ball, Ball]]]:
    """Balls round two values at points at which both have one."""
    for point in tower.points(free, symbols_of(one, other)):
        for precision in PRECISIONS:
            try:
                yield point, (enclosed(one, point, precision), enclosed(other, point, precision))
            except NoValue:
                break
            except Unresolved:
                continue


def agree(kind: str, claim: Claim, tower: TowerValues) -> bool:
    """Whether no counterexample is found: of a proved relation it says that the tower is read
    rightly here.
    """
    return refuted(kind, claim, tower, claim) is None


def _told(point: Mapping[str, Fraction]) -> dict[str, str]:
    return {name: str(value) for name, value in point.items()}


def _witness(
    shape: str, point: Mapping[str, str], shown: tuple[Enclosure, Enclosure], entry: str = ""
) -> Witness:
    left, right = map(_side, shown)
    return Witness(shape, point, left, right, entry)


def _side(found: Enclosure) -> dict[str, str]:
    return {"midpoint": found.midpoint, "radius": found.radius}
