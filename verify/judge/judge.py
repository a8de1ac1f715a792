"""Judges claim files: every claim under every convention its setting admits, the choice made once
for the setting.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from gainproof.verify.judge.choice import choose, verdict_of
from gainproof.verify.judge.claim_record import Claim, ClaimFile, Setting
from gainproof.verify.judge.dimension import fitting_readings
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.trial import Trial, try_claim
from gainproof.verify.judge.verdict import ClaimVerdict, Finding
from gainproof.verify.judge.worker import tried_apart

Progress = Callable[[str, str], None]
"""Called with the id of a claim and its verdict."""
WITHOUT_DECISION = {
    "definition": "nothing to decide but dimensions",
    "remark": "no decidable content",
}


def judge_file(
    claim_file: ClaimFile,
    models: Sequence[Mapping[str, Any]],
    *,
    progress: Progress | None = None,
    seconds: float | None = None,
    processes: int = 1,
) -> tuple[ClaimVerdict, ...]:
    """The verdict on every claim, in order. `models` are the catalogue's, as plain data.

    With `seconds` every claim is judged in a child process that is killed when the time is over;
    up to `processes` of them run at once. A file that is not trusted should be judged like that.
    Nothing is raised for a claim that cannot be decided: its verdict is `undecided` and says why.
    """
    tried: dict[str, Trial] = {}
    if seconds is not None:
        wanted = [claim for claim in claim_file.claims if claim.kind not in WITHOUT_DECISION]
        tried = tried_apart(claim_file.settings, wanted, models, seconds, processes)
    solved: dict[Any, Environment] = {}
    found: dict[str, ClaimVerdict] = {}
    for setting in claim_file.settings.values():
        for verdict in judge_setting(setting, claim_file.claims, models, solved, tried):
            found[verdict.id] = verdict
            if progress is not None:
                progress(verdict.id, verdict.verdict)
    return tuple(found[claim.id] for claim in claim_file.claims)


def judge_setting(
    setting: Setting,
    claims: Iterable[Claim],
    models: Sequence[Mapping[str, Any]],
    solved: dict[Any, Environment],
    tried: Mapping[str, Trial] | None = None,
) -> list[ClaimVerdict]:
    """The verdicts on all claims of one setting; `tried` are trials already made, by id."""
    done = tried or {}
    verdicts, trials = [], []
    for claim in claims:
        if claim.setting != setting.name:
            continue
        if claim.kind in WITHOUT_DECISION:
            verdicts.append(_plain(claim, setting))
        elif claim.id in done:
            trials.append(done[claim.id])
        else:
            trials.append(try_claim(claim, setting, models, solved))
    return [*verdicts, *choose(trials)]


def _plain(claim: Claim, setting: Setting) -> ClaimVerdict:
    fault = None if claim.formula is None else fitting_readings(claim.formula, setting)[1]
    if fault is not None:
        return verdict_of(claim, Finding("refuted", fault, method="dimensions"), None, 0.0)
    reason = claim.note if claim.kind == "remark" and claim.note else WITHOUT_DECISION[claim.kind]
    return verdict_of(claim, Finding(claim.kind, reason), None, 0.0)
