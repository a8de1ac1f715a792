"""A definition repaired by what the claims that use it need: one slip in it explains several claims
that are not true.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reach import reached
from gainproof.verify.judge.repair.catalogue import changes
from gainproof.verify.judge.repair.points import Point, generic_points
from gainproof.verify.judge.repair.printed import Printed, printed
from gainproof.verify.judge.repair.proof import is_proved, reread
from gainproof.verify.judge.repair.table import sample_numbers, table_of
from gainproof.verify.judge.repair.task import OVERTIME, SECONDS
from gainproof.verify.judge.repair.values import Values, truth
from gainproof.verify.judge.repair.whole import Change
from gainproof.verify.judge.repair.words import in_words
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial

BY_VALUES = ("identity", "inequality")
LEAST = 2
"""So many claims must be explained: one claim is as likely to be misprinted itself."""
POINTS = 2
Errors = (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError)


@dataclass(frozen=True)
class DefinitionTask:
    """The definition of `token`, the claims using it that are not true and those that are; `claim`
    is the one under whose id the answer is kept.
    """

    claim: Claim
    setting: Setting
    token: str
    wrong: tuple[Claim, ...]
    right: tuple[Claim, ...]
    conventions: tuple[str, ...]
    seconds: float = SECONDS
    most: float = SECONDS + OVERTIME

    def run(self, models: Models, solved: Solved) -> Trial:
        """A trial whose `repair` holds the changed definition, "changes" in words with their
        "weight" and the "claims" that it makes true, if there is one.
        """
        start = time.perf_counter()
        found: dict[str, Any] | None = None
        for convention in conventions(self.setting, models, solved):
            if isinstance(convention, Convention) and convention.name in self.conventions:
                found = self._searched(convention, start + self.seconds)
                break
        return Trial(self.claim, {}, (), False, time.perf_counter() - start, repair=found)

    def _searched(self, convention: Convention, deadline: float) -> dict[str, Any] | None:
        survivors = []
        points = {c.id: _points(c, convention) for c in (*self.wrong, *self.right)}
        for change in self._changes(convention.setting):
            if time.perf_counter() > deadline:
                break
            if self._agrees(change.printed, convention, points):
                survivors.append(change)
        for change in sorted(survivors, key=lambda c: (c.weight, _size(c))):
            formula = reread(change.printed, convention.setting.symbols)
            if formula is None or time.perf_counter() > deadline:
                continue
            setting = changed_definition(convention.setting, self.token, formula)
            if all(
                is_proved(claim, setting, convention.environment)
                for claim in (*self.wrong, *self.right)
            ):
                names = [claim.id for claim in self.wrong]
                return {
                    "latex": formula.latex,
                    "changes": in_words(change),
                    "weight": change.weight,
                    "claims": names,
                }
        return None

    def _changes(self, setting: Setting) -> Iterator[Change]:
        definition = setting.symbols[self.token].definition
        assert definition is not None
        formula = printed(definition.readings[0])
        left = formula.sides[formula.links[0].left]
        table = table_of(setting, formula, (*self.wrong, *self.right))
        for change in changes(formula, table, sample_numbers(setting)):
            circular = any(node[1:2] == [self.token] for node in _nodes(change.printed))
            if change.printed.sides[formula.links[0].left] == left and not circular:
                yield change

    def _agrees(
        self, formula: Printed, convention: Convention, points: Mapping[str, Sequence[Point]]
    ) -> bool:
        """Whether every claim is seen to hold at its points with the changed definition."""
        entry = Formula("", (formula.reading(),))
        setting = changed_definition(convention.setting, self.token, entry)
        for claim in (*self.wrong, *self.right):
            if claim.kind not in BY_VALUES or claim.formula is None:
                continue
            for point in points[claim.id]:
                scope = Scope(setting, convention.environment)
                told = printed(claim.formula.readings[0])
                if truth(Values(scope, point, {}), told) is False:
                    return False
        return True


def _nodes(formula: Printed) -> list[list[Any]]:
    relation = formula.reading().relations[0]
    return [list(node) for node in relation.right["nodes"]]


def _size(change: Change) -> int:
    return len(_nodes(change.printed))


def _points(claim: Claim, convention: Convention) -> list[Point]:
    scope = Scope(convention.setting, convention.environment)
    assert claim.formula is not None
    try:
        for token in reached(claim, convention.setting):
            scope.symbol(token)
        points, put_in = generic_points(claim, claim.formula.readings[0].conditions, scope, POINTS)
    except Errors:
        return []
    return [] if put_in else points


def changed_definition(setting: Setting, token: str, formula: Formula) -> Setting:
    """The setting with another definition of a symbol."""
    entry = replace(setting.symbols[token], definition=formula)
    return replace(setting, symbols={**setting.symbols, token: entry})


def definition_tasks(
    setting: Setting,
    claims: Sequence[Claim],
    verdicts: Mapping[str, str],
    conventions: Sequence[str],
    carriers: Mapping[str, Claim],
) -> list[DefinitionTask]:
    """One for each definition that at least two claims use which are not true. `carriers` are the
    claims that print the definitions.
    """
    found: list[DefinitionTask] = []
    taken: set[str] = set()
    for token, entry in setting.symbols.items():
        if entry.role != "definition" or entry.arguments:
            continue
        users = [c for c in claims if token in reached(c, setting)]
        wrong = tuple(c for c in users if verdicts.get(c.id) in ("refuted", "conditional"))
        right = tuple(c for c in users if verdicts.get(c.id) == "proved")
        carrier = carriers.get(token, wrong[0] if wrong else None)
        if len(wrong) >= LEAST and carrier is not None and carrier.id not in taken:
            taken.add(carrier.id)
            found.append(DefinitionTask(carrier, setting, token, wrong, right, tuple(conventions)))
    return found
