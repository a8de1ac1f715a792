"""Claims that are true under another convention than the source states: such a convention is named
if it suits every claim of the setting, for then a slip in each of them is less likely.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.convention_choice import choose
from gainproof.verify.judge.convention_effect import VALUES, in_words, reaches
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.setting.own_model import scaled_model
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial, findings_of
from gainproof.verify.judge.verdict import ClaimVerdict
from gainproof.verify.judge.verdict_words import ALONE, CONTRADICTED, DECIDES

TRUE, FALSE = "proved", "refuted"
CHANCE = frozenset(("value", "limit", "inequality"))
"""Kinds of claims of which a single one may be true under another convention by chance."""


def other_conventions(setting: Setting) -> list[tuple[str, Setting]]:
    """The setting with one of its statements replaced, in every way that reaches a symbol, and in
    words what stands in its place; the words are empty where the setting leaves it open then.
    """
    setting = _with_stated_forms(setting)
    found = [
        (in_words(name, value, setting), _with(setting, name, value))
        for name in VALUES
        if getattr(setting, name) != "search" and reaches(name, setting)
        for value in _others(name, getattr(setting, name))
    ]
    if setting.kind == "steady_state" and setting.model not in (None, "search"):
        found.append(("", replace(setting, model="search")))
    if setting.own_model is not None:
        found.append(("", replace(setting, model="search", own_model=None)))
    return found


def _with(setting: Setting, name: str, value: str) -> Setting:
    changed: dict[str, Any] = {name: value}
    return replace(setting, **changed)


def _others(name: str, stated: str) -> tuple[str, ...]:
    if name == "noise":
        # in units of the measurement noise any power of it would do: that is no explanation
        return ("variance",) if stated == "deviation" else ("deviation",)
    return tuple(value for value in VALUES[name] if value != stated)


FORMS = (
    ("gain", "filter", "filter_gain.", "gain."),
    ("gain", "predictor", "predictor_gain.", "gain."),
    ("covariance", "predicted", "predicted_covariance.", "covariance."),
    ("covariance", "updated", "updated_covariance.", "covariance."),
)
"""Beginnings of quantities that state a convention by themselves, and of those that do not."""


def _with_stated_forms(setting: Setting) -> Setting:
    """The setting with what the names of quantities state as conventions; as it is where both
    forms of a quantity occur.
    """
    for name, value, stated, general in FORMS:
        ends = [value for _, value, _, g in FORMS if g == general]
        used = [f for f in (*ends, "") if _begins(setting, f"{f}_{general}" if f else general)]
        if used == [value]:
            symbols = {
                token: replace(entry, quantity=entry.quantity.replace(stated, general, 1))
                if entry.quantity is not None and entry.quantity.startswith(stated)
                else entry
                for token, entry in setting.symbols.items()
            }
            setting = _with(replace(setting, symbols=symbols), name, value)
    return setting


def _begins(setting: Setting, start: str) -> bool:
    return any((e.quantity or "").startswith(start) for e in setting.symbols.values())


@dataclass(frozen=True)
class OtherConventionsTask:
    """A claim under each convention that the source excludes by one of its statements."""

    claim: Claim
    setting: Setting
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """One trial with the findings of all of them."""
        start = time.perf_counter()
        found: list[Convention] = []
        for words, other in other_conventions(self.setting):
            usable = models if self.setting.own_model is None else _alike(self.setting, models)
            with suppress(Undecided, Malformed, NotEstablished):
                every = list(conventions(other, usable, solved))
                found += [_named(each, words) for each in every if isinstance(each, Convention)]
        findings = findings_of(self.claim, found)
        return Trial(self.claim, findings, (), True, time.perf_counter() - start)


def _named(convention: Convention, words: str) -> Convention:
    """The convention with the words of what it changes in front of what it fills in."""
    filled = convention.environment.name if convention.open else ""
    name = ", ".join(part for part in (words, filled) if part)
    return replace(convention, environment=replace(convention.environment, name=name))


def _alike(setting: Setting, models: Models) -> list[Mapping[str, Any]]:
    """The models with the transition and the measurement of the setting's own."""
    try:
        own = scaled_model(setting).data
    except (Undecided, Malformed, NotEstablished):
        return []

    def matrices(model: Mapping[str, Any]) -> list[list[list[Fraction]]]:
        return [
            [[Fraction(x) for x in row] for row in model[name]]
            for name in ("transition", "measurement")
        ]

    return [model for model in models if matrices(model) == matrices(own)]


def other_tasks(
    setting: Setting, claims: Sequence[Claim], verdicts: Sequence[ClaimVerdict]
) -> list[OtherConventionsTask]:
    """Tasks for all decided claims of a setting, if one of them is refuted."""
    decided = _decided(claims, verdicts)
    if FALSE not in {verdict.verdict for verdict in decided.values()}:
        return []
    if not other_conventions(setting):
        return []
    return [OtherConventionsTask(claim, setting) for claim in claims if claim.id in decided]


def under_other_convention(
    claims: Sequence[Claim], verdicts: Sequence[ClaimVerdict], trials: Mapping[str, Trial]
) -> list[ClaimVerdict]:
    """The verdicts on a setting; refuted claims are `conditional` if one other convention makes
    them all true and keeps every claim true that is; else one that would be true under another says
    so. `trials` are those of `other_tasks`.
    """
    decided = _decided(claims, verdicts)
    if not decided or not decided.keys() <= trials.keys():
        return list(verdicts)
    found = {v.id: v for v in choose([trials[name] for name in decided])}
    if any(verdict.verdict != TRUE for verdict in found.values()):
        return [_alone(v, trials[v.id]) if v.id in decided else v for v in verdicts]
    kinds = {claim.id: claim.kind for claim in claims}
    false = [kinds[name] for name, verdict in decided.items() if verdict.verdict == FALSE]
    if len(false) == 1 and false[0] in CHANCE:
        return list(verdicts)
    return [
        _conditional(v, found[v.id]) if v.id in decided and v.verdict == FALSE else v
        for v in verdicts
    ]


def _decided(claims: Sequence[Claim], verdicts: Sequence[ClaimVerdict]) -> dict[str, ClaimVerdict]:
    names = {claim.id for claim in claims}
    return {v.id: v for v in verdicts if v.verdict in (TRUE, FALSE) and v.id in names}


def _alone(stated: ClaimVerdict, trial: Trial) -> ClaimVerdict:
    """A refuted claim with the convention under which it, if not all the others, would be true."""
    fits = [name for name, finding in trial.findings.items() if finding.verdict == TRUE]
    if stated.verdict != FALSE or stated.kind in CHANCE or not fits:
        return stated
    return replace(stated, certificate={**stated.certificate, ALONE: fits[0]})


def _conditional(stated: ClaimVerdict, other: ClaimVerdict) -> ClaimVerdict:
    reason = (
        f"as the source states its conventions: {stated.reason}; true, with all other claims of "
        f"the setting, under a convention that the source contradicts: {other.convention}"
    )
    # what is kept as a statement is that against the stated convention, if there is one
    own = stated.certificate
    rests = stated if "statement" in own else other
    more = {CONTRADICTED: dict(other.certificate)}
    return replace(
        stated,
        verdict="conditional",
        convention=other.convention,
        domain=other.domain,
        certificate={DECIDES: rests.verdict, **own, **more},
        reason=reason,
    )
