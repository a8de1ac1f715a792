"""Claims at points with one definition changed, through all definitions that use it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Malformed
from gainproof.verify.judge.exact.poly import Ball
from gainproof.verify.judge.repair.points import Point
from gainproof.verify.judge.repair.printed import printed
from gainproof.verify.judge.repair.values import Values, truth
from gainproof.verify.judge.scope import Scope

BY_VALUES = ("identity", "inequality")


class _Chained(Values):
    """Values of defined symbols by their printed definitions, one of which may be changed."""

    def __init__(self, scope: Scope, point: Point, bodies: Mapping[str, Expr]) -> None:
        super().__init__(scope, point, {})
        self._bodies = bodies

    def symbol(self, name: str) -> Ball | None:
        if name in self._bodies and name not in self._symbols:
            self._symbols[name] = None  # while it is open: a definition in terms of itself
            self._symbols[name] = self._ball(self._bodies[name])
        return super().symbol(name)


def printed_bodies(setting: Setting) -> dict[str, Expr]:
    """Printed definitions by symbol."""
    found = {}
    for token, entry in setting.symbols.items():
        if entry.definition is not None and not entry.arguments:
            try:
                found[token] = read_graph(entry.definition.readings[0].relations[0].right)
            except Malformed:
                continue
    return found


def agrees_chained(
    token: str,
    body: Expr,
    claims: Sequence[Claim],
    points: Mapping[str, Sequence[Point]],
    scope: Scope,
    bodies: Mapping[str, Expr],
) -> bool:
    """Whether every claim is seen to hold at its points with the changed definition, one at least
    having a value there.
    """
    seen = False
    for claim in claims:
        if claim.kind not in BY_VALUES or claim.formula is None:
            continue
        told = printed(claim.formula.readings[0])
        for point in points[claim.id]:
            found = truth(_Chained(scope, point, {**bodies, token: body}), told)
            if found is False:
                return False
            seen = seen or found is True
    return seen
