"""What a symbol must be at generic points, recognised as a monomial of the source's symbols."""

from __future__ import annotations

from collections.abc import Callable

import flint

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.exact.poly import Ball
from gainproof.verify.judge.formula import Relation
from gainproof.verify.judge.reach import reached
from gainproof.verify.judge.repair.closings import root
from gainproof.verify.judge.repair.points import generic_points
from gainproof.verify.judge.repair.recognise import monomial
from gainproof.verify.judge.repair.values import Values
from gainproof.verify.judge.scope import Scope, UndefinedSymbol

POINTS = 5


def recognised(claim: Claim, relation: Relation, token: str, convention: Convention) -> Expr | None:
    """c * product of powers of up to two symbols that solves an equation for a symbol at every
    point, or None. Raises Undecided, UndefinedSymbol.
    """
    setting = convention.setting
    scope = Scope(setting, convention.environment)
    names = []
    for name in sorted(reached(claim, setting) | set(setting.symbols)):
        try:
            scope.symbol(name)
        except (Undecided, Malformed, UndefinedSymbol):
            continue
        names.append(name)
    assert claim.formula is not None
    points, put_in = generic_points(claim, claim.formula.readings[0].conditions, scope, POINTS)
    left, right = read_graph(relation.left), read_graph(relation.right)
    solved: list[Ball] = []
    for point in points:
        base = Values(scope, point, put_in)
        with flint.ctx.workprec(base.precision):
            value = root(_difference(left, right, token, base))
        if value is None:
            return None
        solved.append(value)
    known = [Values(scope, point, put_in) for point in points]
    at = [[values.symbol(name) for values in known] for name in names]
    usable = [(n, column) for n, column in zip(names, at, strict=True) if None not in column]
    if len(solved) < POINTS:
        return None
    return monomial(solved, [n for n, _ in usable], [column for _, column in usable])


def _difference(left: Expr, right: Expr, token: str, base: Values) -> Callable[[Ball], Ball | None]:
    def difference(h: Ball) -> Ball | None:
        values = Values(base.scope, base.point, base.put_in, overriding={token: h})
        a, b = values.ball(left), values.ball(right)
        return None if a is None or b is None else (a - b).mid()

    return difference
