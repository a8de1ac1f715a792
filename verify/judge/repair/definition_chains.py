"""Claims at points with one definition changed, through all definitions that use it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.meaning.definition_names import names_in
from gainproof.verify.judge.repair.formula_values import Values, truth
from gainproof.verify.judge.repair.generic_points import Point
from gainproof.verify.judge.repair.printed_formula import Printed, printed
from gainproof.verify.judge.scope import Scope

BY_VALUES = ("identity", "inequality", "equivalence")
PLAIN = ("add", "mul", "neg", "div", "pow")
"""Nodes that have a value by those of their parts; others have one by the source's definitions,
and none is known where the changed one is among these.
"""


class _Chained(Values):
    """Values of defined symbols by their printed definitions."""

    def __init__(self, scope: Scope, point: Point, bodies: Mapping[str, Expr]) -> None:
        super().__init__(scope, point, {})
        self._bodies = bodies

    def symbol(self, name: str) -> Ball | None:
        if name in self._bodies and name not in self._symbols:
            self._symbols[name] = None  # while it is open: a definition in terms of itself
            self._symbols[name] = self._ball(self._bodies[name])
        return super().symbol(name)


class _Changed(_Chained):
    """The same with one definition changed; what does not depend on it is known."""

    def __init__(self, known: _Chained, reach: _Reach, bodies: Mapping[str, Expr]) -> None:
        super().__init__(known.scope, known.point, bodies)
        self._known, self._reach = known, reach

    def symbol(self, name: str) -> Ball | None:
        return super().symbol(name) if name in self._reach.names else self._known.symbol(name)

    def _ball(self, expr: Expr) -> Ball | None:
        if self._reach.hides(expr):
            return None
        return super()._ball(expr) if self._reach.has(expr) else self._known._ball(expr)


@dataclass
class _Reach:
    """The symbols whose printed definitions use one symbol, it included, and what uses these;
    `every` are those whose definitions do, be they numbers, matrices or functions.
    """

    names: frozenset[str]
    every: frozenset[str]
    _seen: dict[bytes, bool] = field(default_factory=dict)

    def has(self, expr: Expr) -> bool:
        """Whether the value of a printed formula depends on one of them."""
        if expr.key not in self._seen:
            self._seen[expr.key] = self._has(expr)
        return self._seen[expr.key]

    def hides(self, expr: Expr) -> bool:
        """Whether a node depends on one of them in a way that its parts do not show."""
        if expr.kind in (*PLAIN, "number", "symbol"):
            return False
        return not self.every.isdisjoint(names_in(expr))

    def _has(self, expr: Expr) -> bool:
        if expr.kind == "symbol":
            return expr.name in self.names
        return expr.kind in PLAIN and any(self.has(part) for part in expr.parts)


class Chain:
    """Claims at their points, for one definition after the other in place of that of `token`."""

    def __init__(
        self,
        token: str,
        claims: Sequence[Claim],
        points: Mapping[str, Sequence[Point]],
        scope: Scope,
        bodies: Mapping[str, Expr],
    ) -> None:
        self._token, self._bodies = token, bodies
        self._printed = {c.id: told for c in claims if (told := _told(c)) is not None}
        self._claims = [c for c in claims if c.id in self._printed]
        every = frozenset(n for n in scope.setting.symbols if token in {n, *scope.reach.of(n)})
        self._reach = _Reach(_users(token, bodies), every)
        self._known = {
            claim.id: [_Chained(scope, point, bodies) for point in points[claim.id]]
            for claim in self._claims
        }

    def agrees(self, body: Expr) -> bool:
        """Whether every claim is seen to hold at its points with the changed definition, one at
        least having a value there.
        """
        seen = False
        for found in self._found(body):
            if found is False:
                return False
            seen = seen or found is True
        return seen

    def is_denied(self, body: Expr) -> bool:
        """Whether a claim is seen to fail at one of its points with the changed definition."""
        return any(found is False for found in self._found(body))

    def _found(self, body: Expr) -> Iterator[bool | None]:
        """Whether each claim holds, point after point."""
        bodies = {**self._bodies, self._token: body}
        for claim in self._claims:
            for known in self._known[claim.id]:
                values = _Changed(known, self._reach, bodies)
                yield _holds(values, self._printed[claim.id])


def _holds(values: Values, told: Printed) -> bool | None:
    """Whether a claim holds at a point; an equivalence, if both its parts hold or neither does,
    which is not known where a side has no value.
    """
    if told.connective != "iff":
        return truth(values, told)
    parts = []
    for links in (told.links, told.conditions):
        found = [truth(values, told, (link,)) for link in links]
        if None in found:
            return None
        parts.append(all(found))
    return parts[0] == parts[1]


def _told(claim: Claim) -> Printed | None:
    """What a claim says of numbers; None for a claim of matrices, or one that points do not
    decide.
    """
    if claim.kind not in BY_VALUES or claim.formula is None:
        return None
    try:
        return printed(claim.formula.readings[0])
    except Malformed:
        return None


def _users(token: str, bodies: Mapping[str, Expr]) -> frozenset[str]:
    """The symbol, and those whose definitions use it, directly or not."""
    uses = {name: symbols_of(body) for name, body in bodies.items()}
    found = {token}
    while more := {name for name, used in uses.items() if used & found} - found:
        found |= more
    return frozenset(found)


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
