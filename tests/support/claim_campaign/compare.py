"""Whether a relation holds at a point, as far as ninety digits tell."""

from __future__ import annotations

from collections.abc import Iterable

from mutation.arithmetic import Misshapen, NoValue, differ

from claim_campaign.point import NotCovered, Point
from claim_campaign.subject import Rel


def holds(relation: Rel, point: Point) -> bool | None:
    """None where a side has no value. Raises NotCovered, Misshapen."""
    try:
        left, right = point.value(relation.left), point.value(relation.right)
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
