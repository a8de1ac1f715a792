"""Whether a relation holds at a point, as far as ninety digits tell; that it fails, four hundred
have to say too.
"""

from __future__ import annotations

from collections.abc import Iterable

from mutation.arithmetic import Misshapen, NoValue, differ

from claim_campaign.point import DIGITS, NotCovered, Point
from claim_campaign.subject import Rel

FINE = 400
"""Digits that leave enough of 1 - exp(-693), which is 1 to ninety digits: no point that is drawn is
nearer to zero than 1/1000.
"""


def holds(relation: Rel, point: Point) -> bool | None:
    """None where a side has no value. Raises NotCovered, Misshapen."""
    said = _holds(relation, point, DIGITS)
    return _holds(relation, point, FINE) if said is False else said


def _holds(relation: Rel, point: Point, digits: int) -> bool | None:
    try:
        left, right = (point.value(side, digits) for side in (relation.left, relation.right))
    except NoValue:
        return None
    if isinstance(left, list) != isinstance(right, list):
        raise Misshapen("a matrix and a number")
    apart = differ(left, right)
    if relation.operator in ("=", "!="):
        return apart == (relation.operator == "!=")
    if isinstance(left, list):
        raise NotCovered("an order of matrices")
    match relation.operator:
        case "<" | "<=":
            return bool(left < right) if apart else relation.operator == "<="
        case ">" | ">=":
            return bool(left > right) if apart else relation.operator == ">="
    raise NotCovered(f"the relation {relation.operator}")


def holds_all(relations: Iterable[Rel], point: Point) -> bool:
    """Whether each holds."""
    return all(holds(relation, point) for relation in relations)
