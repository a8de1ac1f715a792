"""Whether claims about filters with free gains are false: stability by eigenvalues, best gains by
what happens beside them, orders by filters solved for at one lag.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import NoValue, real
from mutation.tree import to_tree

from claim_campaign.compare import holds
from claim_campaign.draw import domain_of, points
from claim_campaign.free_filters import radius
from claim_campaign.point import DIGITS, NotCovered, Point
from claim_campaign.solve import solved
from claim_campaign.subject import Rel, Subject, rel

POINTS = 30
ROOTS = 3
"""So often a filter is looked for at one lag."""
BORDER = mpmath.mpf(10) ** -9
STEP = mpmath.mpf(10) ** -25
FLAT = mpmath.mpf(10) ** -20
"""A relative slope below which a place counts as a minimum."""


def stability_is_false(subject: Subject, random: Random) -> bool | None:
    """Whether a filter contradicts the conditions; None if no point says anything."""
    stated = (*subject.relations(), *subject.conditions())
    said: list[bool] = []
    for point in points(domain_of(subject), POINTS, random):
        each = [holds(relation, point) for relation in stated]
        size = radius(_gains(subject, point))
        if None in each or abs(size - 1) < BORDER:
            continue
        met, stable = all(each), bool(size < 1)
        match subject.claim.own["sense"].word:
            case "sufficient":
                said += [not stable] if met else []
            case "necessary":
                said += [not met] if stable else []
            case "unstable":
                said += [stable] if met else []
            case _:
                said.append(met != stable)
    return any(said) if said else None


def optimum_is_false(subject: Subject, random: Random) -> bool | None:
    """Whether stated gains have better ones beside them, the last gain and so the lag kept."""
    claim = subject.claim
    tree, tokens = to_tree(claim.own["minimised"].expression), _tokens(subject)
    stated = (*subject.relations(), *subject.conditions())
    if any(r.operator != "=" for r in stated):
        raise NotCovered("best gains that are no equations")
    said: list[bool] = []
    for point in points(domain_of(subject, stated), POINTS // 4, random):
        try:
            if radius(_gains(subject, point)) > 1 - BORDER:
                continue
            said.append(any(_slope(tree, point, token) > FLAT for token in tokens[:-1]))
        except NoValue:
            continue
    return any(said) if said else None


def ordering_is_false(subject: Subject, random: Random) -> bool | None:
    """Whether two neighbours are in another order at one value of the last gain."""
    claim = subject.claim
    tree, ascending = to_tree(claim.own["compared"].expression), claim.own["ascending"].filters
    laws: Mapping[str, Sequence[Rel]] = {
        name: [rel(r) for f in subject.setting.filters[name] for r in f.readings[0].relations]
        for name in ascending
    }
    positive = [Rel(">", ("symbol", t), ("number", Fraction(0))) for t in _tokens(subject)]
    said: list[bool] = []
    for lower, upper in pairwise(ascending):
        for point in points(domain_of(subject, (*laws[lower], *positive)), POINTS // 4, random):
            if radius(_gains(subject, point)) > 1 - BORDER:
                continue
            others = _at_same_lag(laws[upper], point, subject, random)
            said += [not point.value(tree) < other.value(tree) for other in others]
    return any(said) if said else None


CLAIMS: Mapping[str, Callable[[Subject, Random], bool | None]] = {
    "stability": stability_is_false,
    "optimum": optimum_is_false,
    "ordering": ordering_is_false,
}


def _at_same_lag(law: Sequence[Rel], point: Point, subject: Subject, random: Random) -> list[Point]:
    """Stable filters of a law with the same last gain."""
    tokens = _tokens(subject)
    found: list[Point] = []
    for _ in range(ROOTS):
        moved = point
        for token in tokens[:-1]:
            assert moved.moved is not None
            moved = moved.moved(token, real(random.randrange(1, 150)) / 100)
        try:
            there = solved(law, moved, tokens[:-1], random)
        except NoValue:
            continue
        if radius(_gains(subject, there)) < 1 - BORDER:
            found.append(there)
    return found


def _slope(tree: Any, point: Point, token: str) -> Any:
    assert point.moved is not None
    with mpmath.workdps(DIGITS):
        here = point.values[token]
        high, low = (point.moved(token, here + move).value(tree) for move in (STEP, -STEP))
        return abs((high - low) / (2 * STEP) / point.value(tree))


def _tokens(subject: Subject) -> list[str]:
    """The symbols of the gains, in order."""
    found = {e.quantity: t for t, e in subject.setting.symbols.items() if e.quantity}
    names = [f"filter_gain.{i + 1}" for i in range(subject.setting.states or 0)]
    if not names or any(name not in found for name in names):
        raise NotCovered("gains without a symbol")
    return [found[name] for name in names]


def _gains(subject: Subject, point: Point) -> list[Any]:
    return [point.values[token] for token in _tokens(subject)]
