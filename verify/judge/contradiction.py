"""Claims that are true under another convention than the source states: such a convention is named
if it suits every claim of the setting, for then a slip in each of them is less likely.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.choice import choose
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention_effect import VALUES, reaches
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial, try_claim
from gainproof.verify.judge.verdict import ClaimVerdict, Finding

TRUE, FALSE = "proved", "refuted"
CHANCE = frozenset(("value", "limit", "inequality"))
"""Kinds of claims of which a single one may be true under another convention by chance."""


def other_conventions(setting: Setting) -> list[Setting]:
    """The setting with one of its stated conventions opened, in every way that reaches a symbol."""
    stated = [n for n in VALUES if getattr(setting, n) != "search" and reaches(n, setting)]
    # in units of the measurement noise any power of it would do: that is no explanation
    turned = {"deviation": "variance"}.get(setting.noise, "deviation")
    opened: list[dict[str, Any]] = [
        {name: turned if name == "noise" else "search"} for name in stated
    ]
    if setting.kind == "steady_state" and setting.model not in (None, "search"):
        opened.append({"model": "search"})
    return [replace(setting, **fields) for fields in opened]


@dataclass(frozen=True)
class OtherConventionsTask:
    """A claim under each convention that the source excludes by one of its statements."""

    claim: Claim
    setting: Setting
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """One trial with the findings of all of them."""
        start = time.perf_counter()
        findings: dict[str, Finding] = {}
        for opened in other_conventions(self.setting):
            findings |= try_claim(self.claim, opened, models, solved).findings
        return Trial(self.claim, findings, (), True, time.perf_counter() - start)


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
    them all true and keeps every claim true that is. `trials` are those of `other_tasks`.
    """
    decided = _decided(claims, verdicts)
    if not decided or not decided.keys() <= trials.keys():
        return list(verdicts)
    found = {v.id: v for v in choose([trials[name] for name in decided])}
    if any(verdict.verdict != TRUE for verdict in found.values()):
        return list(verdicts)
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


def _conditional(stated: ClaimVerdict, other: ClaimVerdict) -> ClaimVerdict:
    reason = (
        f"as the source states its conventions: {stated.reason}; true, with all other claims of "
        f"the setting, under a convention that the source contradicts: {other.convention}"
    )
    return replace(
        stated,
        verdict="conditional",
        convention=other.convention,
        domain=other.domain,
        certificate={**stated.certificate, "under the other convention": dict(other.certificate)},
        reason=reason,
    )
