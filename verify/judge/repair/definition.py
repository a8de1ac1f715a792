"""A definition repaired by what the claims that use it need: one slip in it explains several claims
that are not true.

Claims are looked at at points first: a changed definition with which one is seen to fail needs no
proof that it fails.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import closure, names_in, reached
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Formula, Relation
from gainproof.verify.judge.repair.change_words import in_words
from gainproof.verify.judge.repair.definition_chains import Chain, printed_bodies
from gainproof.verify.judge.repair.exchanged_symbols import sample_numbers, table_of
from gainproof.verify.judge.repair.generic_points import Point, free_points
from gainproof.verify.judge.repair.printed_formula import Printed, printed
from gainproof.verify.judge.repair.proof import is_proved, reread, standing
from gainproof.verify.judge.repair.senseless_parts import is_more_senseless
from gainproof.verify.judge.repair.single_changes import changes
from gainproof.verify.judge.repair.suspects import Suspect, suspects_of
from gainproof.verify.judge.repair.task import OVERTIME, SECONDS
from gainproof.verify.judge.repair.whole_formula import Change
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict

MOST_TRIED = 4_000
"""So many changed definitions are looked at, whatever the machine's speed."""
POINTS = 2
FAR_POINTS = 24
Errors = (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError)


@dataclass(frozen=True)
class DefinitionTask:
    """The definitions that may explain why claims of a setting are not true; `claim` is one of
    these, under whose id the answer is kept.
    """

    claim: Claim
    setting: Setting
    suspects: tuple[Suspect, ...]
    conventions: tuple[str, ...]
    seconds: float = SECONDS
    most: float = SECONDS + OVERTIME

    def run(self, models: Models, solved: Solved) -> Trial:
        """A trial whose `repair` holds the lightest changed definition, "changes" in words with
        their "weight", the "token", the "claims" that it makes true and their "verdict": true
        everywhere, or wherever they have a value. None if there is none.
        """
        start = time.perf_counter()
        deadline = time.process_time() + self.seconds
        found: dict[str, Any] | None = None
        for convention in conventions(self.setting, models, solved):
            if isinstance(convention, Convention) and convention.name in self.conventions:
                found = self._searched(convention, deadline)
                break
        seconds, timed = time.perf_counter() - start, time.process_time() > deadline
        return Trial(self.claim, {}, (), False, seconds, repair=found, timed=timed)

    def _searched(self, convention: Convention, deadline: float) -> dict[str, Any] | None:
        survivors: list[tuple[Suspect, Change]] = []
        tried = 0
        scope = Scope(convention.setting, convention.environment)
        bodies = printed_bodies(convention.setting)
        points: dict[str, list[Point]] = {}
        for suspect in self.suspects:
            users = [c for c in suspect.users if c.id not in points]
            points |= {c.id: near_points(c, convention) for c in users}
            chain = Chain(suspect.token, suspect.users, points, scope, bodies)
            far: Chain | None = None
            for change, formula in _changes(suspect, convention.setting):
                tried += 1
                if tried > MOST_TRIED or time.process_time() > deadline:
                    break
                # nearly all are left out by the first point
                if not chain.agrees(_body(change)) or is_more_senseless(change.printed, formula):
                    continue
                if far is None:
                    at = {c.id: far_points(c, suspect.token, convention) for c in suspect.users}
                    far = Chain(suspect.token, suspect.users, at, scope, bodies)
                if not far.is_denied(_body(change)):
                    survivors.append((suspect, change))
        survivors.sort(key=lambda pair: (pair[1].weight, -len(pair[0].wrong), _size(pair[1])))
        for suspect, change in survivors:
            if time.process_time() > deadline:
                break
            found = _borne_out(suspect, change, convention)
            if found is not None:
                return found
        return None


def _borne_out(suspect: Suspect, change: Change, convention: Convention) -> dict[str, Any] | None:
    """The answer if with the change all claims stand."""
    formula = reread(change.printed, convention.setting.symbols)
    if formula is None:
        return None
    setting = changed_definition(convention.setting, suspect.token, formula)
    found = []
    for claim in suspect.wrong:
        found.append(standing(claim, setting, convention.environment))
        if found[-1] is None or (found[-1] == "conditional" and claim.id in suspect.partly):
            return None
    if not all(is_proved(claim, setting, convention.environment) for claim in suspect.right):
        return None
    if any(standing(claim, setting, convention.environment) is None for claim in suspect.kept):
        return None
    return {
        "token": suspect.token,
        "latex": formula.latex,
        "changes": in_words(change),
        "weight": change.weight,
        "claims": [claim.id for claim in suspect.wrong],
        "verdict": "conditional" if "conditional" in found else "proved",
    }


def _changes(suspect: Suspect, setting: Setting) -> Iterator[tuple[Change, Printed]]:
    """Changes of a definition that leave what is defined, each with the definition as printed."""
    definition = setting.symbols[suspect.token].definition
    assert definition is not None
    try:
        formula = printed(definition.readings[0])
    except Malformed:
        return  # slips are looked for in definitions of numbers, not of matrices
    left = formula.sides[formula.links[0].left]
    table = table_of(setting, formula, suspect.users)
    for change in changes(formula, table, sample_numbers(setting)):
        if change.printed.sides[formula.links[0].left] != left:
            continue
        if not _holds(_body(change), suspect.token):
            yield change, formula


def _holds(expr: Expr, token: str) -> bool:
    """Whether a symbol or function of that name stands anywhere in a tree as printed."""
    if expr.value == token and expr.kind in ("symbol", "call"):
        return True
    return any(_holds(part, token) for part in expr.parts)


def _body(change: Change) -> Expr:
    return change.printed.sides[change.printed.links[0].right]


def _size(change: Change) -> int:
    return sum(1 for _ in walk(_body(change)))


def changed_definition(setting: Setting, token: str, formula: Formula) -> Setting:
    """The setting with another definition of a symbol."""
    entry = replace(setting.symbols[token], definition=formula)
    return replace(setting, symbols={**setting.symbols, token: entry})


def definition_task(
    setting: Setting,
    claims: Sequence[Claim],
    verdicts: Mapping[str, ClaimVerdict],
    conventions: Sequence[str],
) -> DefinitionTask | None:
    """The task for a setting, if claims are not true that use definitions."""
    suspects = suspects_of(setting, claims, verdicts)
    if not suspects:
        return None
    return DefinitionTask(suspects[0].wrong[0], setting, suspects, tuple(conventions))


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
