"""Whether a broken claim is false, by values at points of its domain."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import Misshapen, NoValue
from mutation.tree import Tree, to_tree

from claim_campaign.compare import holds
from claim_campaign.draw import Domain, domain_of, points
from claim_campaign.free_claims import CLAIMS
from claim_campaign.point import DIGITS, NotCovered, Point
from claim_campaign.roots import lie
from claim_campaign.subject import Rel, Subject, rel

POINTS = 8
PLAIN = ("identity", "inequality", "recursion", "implication", "equivalence", "limit", "value")
INFINITY: Tree = ("symbol", "infinity")
FAR = 40
"""A limit is looked at this many powers of ten away, and half as many."""
NEAR = mpmath.mpf(10) ** -15
"""What a convergent expression may be away from its limit there, relative."""


def is_false(subject: Subject, random: Random) -> bool | None:
    """Whether the claim is false somewhere on its domain; None if no point says anything. Raises
    NotCovered.
    """
    if subject.claim.kind == "location":
        return _roots_elsewhere(subject, random)
    if subject.claim.kind in CLAIMS:
        return CLAIMS[subject.claim.kind](subject, random)
    if subject.claim.kind not in PLAIN:
        raise NotCovered(f"claims of kind {subject.claim.kind}")
    relations, conditions = subject.relations(), subject.conditions()
    if any(r.operator == "->" for r in (*relations, *conditions)):
        return _limit_is_false(subject, relations, conditions, random)
    try:
        match subject.connective():
            case "if":
                return _fails(subject, conditions, relations, random)
            case "implies":
                return _fails(subject, relations, conditions, random)
            case _:
                there = _fails(subject, relations, conditions, random)
                back = _fails(subject, conditions, relations, random)
                return there or back if None not in (there, back) else there or back or None
    except Misshapen:
        return None


def _fails(
    subject: Subject, given: Sequence[Rel], claimed: Sequence[Rel], random: Random
) -> bool | None:
    """Whether something claimed fails at a point where all that is given holds."""
    found = points(domain_of(subject, given), POINTS, random)
    said = []
    for point in found:
        is_value = subject.claim.kind == "value"
        said.append(_all_shown(subject, point) if is_value else _all(claimed, point))
        if said[-1] is False:
            return True
    if found and not any(said):
        return True  # defined nowhere, so nothing is claimed
    return False if True in said else None


def _all(claimed: Sequence[Rel], point: Point) -> bool | None:
    each = [holds(relation, point) for relation in claimed]
    return False if False in each else None if None in each else True


def _all_shown(subject: Subject, point: Point) -> bool | None:
    """Whether every printed number is the other side, rounded to its digits."""
    assert subject.claim.formula is not None
    for printed in subject.claim.formula.readings[0].relations:
        sides = rel(printed)
        exact, shown, decimals = sides.left, sides.right, printed.right_decimals
        if decimals is None:
            exact, shown, decimals = sides.right, sides.left, printed.left_decimals
        if not isinstance(decimals, int):
            raise NotCovered("a value without digits, or a matrix")
        try:
            away = abs(point.value(exact) - point.value(shown))
        except NoValue:
            return None
        if away > (mpmath.mpf(10) ** -decimals) / 2:
            return False
    return True


def _roots_elsewhere(subject: Subject, random: Random) -> bool | None:
    claim = subject.claim
    if not {"polynomial", "where"} <= claim.own.keys():
        raise NotCovered("roots that are listed")
    tree = to_tree(claim.own["polynomial"].expression)
    variable, where = claim.own["variable"].symbol, claim.own["where"].word
    said = None
    for point in points(domain_of(subject), POINTS * 3, random):
        try:
            if not lie(tree, variable, where, point):
                return True
        except NoValue:
            continue
        said = False
    return said


def _limit_is_false(
    subject: Subject, relations: Sequence[Rel], conditions: Sequence[Rel], random: Random
) -> bool | None:
    (arrow,) = (r for r in conditions if r.operator == "->")
    (relation,) = relations
    if arrow.left[0] != "symbol":
        raise NotCovered("a limit in an expression")
    others = [r for r in conditions if r is not arrow]
    said = []
    for point in points(_without_limit(subject, arrow, others), POINTS // 2, random):
        try:
            said.append(_tends_elsewhere(relation, arrow, point))
        except NoValue:
            continue
    return any(said) if said else None


def _without_limit(subject: Subject, arrow: Rel, others: Sequence[Rel]) -> Domain:
    domain = domain_of(subject, others)
    name = arrow.left[1]
    kept = tuple(r for r in domain.given if name not in r.symbols() or r.symbols() == {name})
    return Domain(subject, domain.needed - {"infinity"}, kept)


def _tends_elsewhere(relation: Rel, arrow: Rel, point: Point) -> bool:
    with mpmath.workdps(2 * DIGITS):
        there = [_value_near(relation.left, arrow, point, power) for power in (FAR // 2, FAR)]
        if relation.right in (INFINITY, ("neg", INFINITY)):
            sign = -1 if relation.right[0] == "neg" else 1
            grows = sign * there[1] > sign * there[0]
            return not (grows and sign * there[1] > 1000)
        wanted = point.value(relation.right)
        return bool(abs(there[1] - wanted) > NEAR * max(1, abs(wanted)))


def _value_near(tree: Tree, arrow: Rel, point: Point, power: int) -> Any:
    assert point.moved is not None
    name, far = arrow.left[1], mpmath.mpf(10) ** power
    if arrow.right == INFINITY:
        return point.moved(name, far).value(tree)
    if arrow.right == ("neg", INFINITY):
        return point.moved(name, -far).value(tree)
    return point.moved(name, point.value(arrow.right) + 1 / far).value(tree)
