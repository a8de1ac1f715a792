"""Points at which claims are looked at while the definition of a symbol changes: a changed one with
which a claim is seen to fail needs no proof that it fails.
"""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.formula import Formula, Relation
from gainproof.verify.judge.reach import closure, names_in, reached
from gainproof.verify.judge.repair.points import Point, free_points
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished

POINTS = 2
FAR_POINTS = 24
Errors = (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError)


def near_points(claim: Claim, convention: Convention) -> list[Point]:
    """Up to `POINTS` generic points, for every changed definition."""
    return _points(claim, convention, POINTS, far=False)


def far_points(claim: Claim, token: str, convention: Convention) -> list[Point]:
    """Up to `FAR_POINTS` from near the ends of the domain to large numbers; none where the
    definition of the symbol `token` decides which points belong to the claim.
    """
    symbols = convention.setting.symbols
    stated = [*claim.domain, *(_conditions(claim.formula) if claim.formula else ())]
    for formula in claim.given:
        stated += formula.readings[0].relations
    for name in reached(claim, convention.setting):
        stated += symbols[name].domain
    names = {name for r in stated for side in (r.left, r.right) for name in names_in(side)}
    return (
        [] if token in closure(names, symbols) else _points(claim, convention, FAR_POINTS, far=True)
    )


def _points(claim: Claim, convention: Convention, count: int, *, far: bool) -> list[Point]:
    scope = Scope(convention.setting, convention.environment)
    if claim.formula is None:
        return []
    try:
        for token in reached(claim, convention.setting):
            scope.symbol(token)
        return free_points(claim, _conditions(claim.formula), scope, count, far=far)
    except Errors:
        return []


def _conditions(formula: Formula) -> tuple[Relation, ...]:
    """Where the formula claims something: an equivalence, at all points."""
    reading = formula.readings[0]
    return () if reading.connective == "iff" else reading.conditions
