"""Identities in which several parameters stand under one root: proved where they follow from the
relations of the roots alone.

With t in place of a root of N/D and t^n D^n = N D^(n-1), a difference of sides whose numerator
reduces to 0 is 0 whichever root each t is. No connected set and no branch is needed, so that any
number of parameters may stand under a root; what does not reduce to 0 is left open.
"""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import roots_made_prime
from gainproof.verify.judge.exact.certificate import roots_text, statement_data
from gainproof.verify.judge.exact.radicands import NeedsPower
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.statement import Outcome, Statement, unstated
from gainproof.verify.judge.exact.tower import Tower
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided

WHERE = "where every part has a value"


def decide_formally(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome:
    """`proved` for an identity true on every branch of its roots. Raises Undecided for all others,
    and for one that is not seen to have a value, or that may have none where its domain is stated.
    """
    if statement.connective != "if" or any(r.operator != "=" for r in statement.relations):
        raise Undecided("only identities follow from the relations of their roots")
    prime = statement.mapped(roots_made_prime)
    free = tuple(sorted(prime.symbols()))
    differences = [rel.left - rel.right for rel in prime.relations]
    whole = (*differences, *prime.needed)
    try:
        tower = build_tower(whole, (), free, frozenset(), DEFAULT_LIMITS, formal=True)
    except NeedsPower as need:  # pragma: no cover - no symbol counts as positive here
        raise Undecided(str(need)) from need
    for difference in differences:
        if not tower.element(difference).num.is_zero():
            raise Undecided("the sides do not become equal by the relations of the roots")
    _refuse_stated(tower, boxes)
    points = try_points(statement, boxes, labels)
    if points is None or points.verdict != "held":
        raise Undecided("the formula was not seen to have a value")
    known = {name: boxes.get(name, unstated()) for name in statement.symbols()}
    certificate = {
        "checked": "replayed",
        "engine": "formal",
        "statement": statement_data(statement, known, None, labels),
        "variables": {
            tower.names[place]: labels.get(name, name)
            for place, name in zip(tower.free_indices, free, strict=True)
        },
        "tower": tower.relations_text(),
        "roots": roots_text(statement),
    }
    return Outcome(
        "proved",
        WHERE if tower.checks else "everywhere",
        "follows from the relations of the roots, on every branch",
        "identity of polynomials over roots",
        None,
        certificate,
    )


def _refuse_stated(tower: Tower, boxes: Mapping[str, Box]) -> None:
    """Raises Undecided if a divisor or a radicand holds a symbol with a stated domain: whether the
    formula has a value on all of it is not asked here.
    """
    for check in tower.checks:
        degrees = check.poly.degrees()
        for place, name in zip(tower.free_indices, tower.free, strict=True):
            if degrees[place] > 0 and boxes.get(name, unstated()).stated:
                raise Undecided("a part may have no value for some values in the stated domain")
