"""Judges claim files: every claim under every convention its setting admits, the choice made once
for the setting; then the nearest true formulas for what is not true.

Verdicts that rest on an accident are told: what was broken off may have chosen a convention, said
what a symbol is, or offered a repair, so that another run may come to something else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import count
from typing import Any

from gainproof.verify.judge.claim.record import Claim, ClaimFile, Setting
from gainproof.verify.judge.convention_choice import choose, verdict_of
from gainproof.verify.judge.definition_use import contradicted, with_blame
from gainproof.verify.judge.dimensions.claim import claim_readings, degrees_are_open
from gainproof.verify.judge.kinds.catalogue import KINDS
from gainproof.verify.judge.kinds.definition import compared_token, is_as_declared, is_compared
from gainproof.verify.judge.matrices.decision import decide
from gainproof.verify.judge.repair.offers import NOT_TRUE
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.stages import (
    Done,
    Stage,
    may_get_repair,
    with_other_conventions,
    with_repairs,
)
from gainproof.verify.judge.task import Models, Task, TrialTask
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.undefined.defining_claim import Fixed, fixed_symbols
from gainproof.verify.judge.verdict import ClaimVerdict, Finding
from gainproof.verify.judge.worker import Judges, OnTrial, Workers

Progress = Callable[[int, int], None]
"""Called with the number of trials so far, and of the claims of which each needs one; what comes
after these looks for repairs.
"""
WITHOUT_DECISION = {kind.name: kind.not_decided for kind in KINDS if kind.not_decided}
FAILED = ("refuted", "conditional")
Lost = list[tuple[Task, str]]
"""Tasks of which nothing is known, and why."""


def judge_file(
    claim_file: ClaimFile,
    models: Models,
    *,
    progress: Progress | None = None,
    seconds: float | None = None,
    processes: int = 1,
    workers: Judges | None = None,
    only: str | None = None,
    solved: dict[Any, Environment] | None = None,
) -> tuple[ClaimVerdict, ...]:
    """The verdict on every claim, in order. `models` are the catalogue's, as plain data.

    With `only` the verdict on the claim of this id alone: of the others, those of its setting are
    tried, since conventions are chosen for all of them, and no repair is looked for that is not
    its own.

    With `seconds` every claim is judged in a child process that ends when it has used so much
    processor time; up to `processes` of them run at once; or by `workers`, which stay for other
    files. A file that is not trusted should be judged in one of these ways.
    Without either they are judged here; `solved` keeps the settings' solutions for other files.

    Nothing is raised for a claim that cannot be decided: its verdict is `undecided` and says why. A
    verdict that rests on an `accident` says so: judged again, the claim may get another.
    """
    if only is not None:
        claim_file = _setting_of(claim_file, only)
    wanted = [claim for claim in claim_file.claims if claim.kind not in WITHOUT_DECISION]
    so_far = count(1)

    def tell(_: Trial) -> None:
        if progress is not None:
            progress(next(so_far), len(wanted))

    if workers is not None:
        return _judged(claim_file, wanted, partial(workers.run, on_trial=tell), only)
    if seconds is None:
        return _judged(claim_file, wanted, here(models, tell, solved), only)
    with Workers(models, seconds, processes) as own:
        return _judged(claim_file, wanted, partial(own.run, on_trial=tell), only)


def _setting_of(claim_file: ClaimFile, name: str) -> ClaimFile:
    """The file with the setting of one claim and the claims on it."""
    (setting,) = (claim.setting for claim in claim_file.claims if claim.id == name)
    return replace(
        claim_file,
        settings={setting: claim_file.settings[setting]},
        claims=tuple(claim for claim in claim_file.claims if claim.setting == setting),
    )


def _judged(
    claim_file: ClaimFile, wanted: Sequence[Claim], done: Done, only: str | None
) -> tuple[ClaimVerdict, ...]:
    claims = claim_file.claims
    lost: Lost = []
    done = noted(done, lost)
    trials = dict(done([TrialTask(c, claim_file.settings[c.setting]) for c in wanted]))
    stages: list[Stage] = []
    symbols: list[Fixed] = []
    for setting in claim_file.settings.values():
        mine = [claim for claim in wanted if claim.setting == setting.name]
        setting, fixed = fixed_symbols(setting, mine, done)
        symbols += fixed
        for symbol in fixed:
            trials |= symbol.trials
        used_up = {symbol.consumed for symbol in fixed}
        left = tuple(claim for claim in mine if claim.id not in used_up)
        tried = tuple(trials[claim.id] for claim in left)
        all_here = tuple(claim for claim in claims if claim.setting == setting.name)
        compared = done([TrialTask(c, setting) for c in all_here if is_compared(c, setting)])
        verdicts = _verdicts(setting, all_here, tried, compared)
        verdicts += [used_up_verdict(c, fixed) for c in mine if c.id in used_up]
        stages.append(Stage(setting, all_here, left, tried, tuple(verdicts)))
    stages = with_other_conventions(stages, done)
    if only is None or any(may_get_repair(v) for s in stages for v in s.verdicts if v.id == only):
        stages = with_repairs(stages, done)
    found = {
        v.id: with_symbols(v, symbols)
        for stage in stages
        for v in with_accidents(stage, lost, undefined_symbols=_has_undefined(claim_file, stage))
    }
    return tuple(found[claim.id] for claim in claims if only in (None, claim.id))


def _has_undefined(claim_file: ClaimFile, stage: Stage) -> bool:
    """Whether claims were to say what a symbol of the setting is."""
    symbols = claim_file.settings[stage.setting.name].symbols
    return any(entry.role == "undefined" for entry in symbols.values())


def judge_setting(
    setting: Setting, claims: Iterable[Claim], models: Models, solved: dict[Any, Environment]
) -> list[ClaimVerdict]:
    """The verdicts on all claims of one setting, without repairs."""
    chosen = [claim for claim in claims if claim.setting == setting.name]
    trials = [
        TrialTask(claim, setting).run(models, solved)
        for claim in chosen
        if claim.kind not in WITHOUT_DECISION
    ]
    compared = {
        claim.id: TrialTask(claim, setting).run(models, solved)
        for claim in chosen
        if is_compared(claim, setting)
    }
    return _verdicts(setting, chosen, trials, compared)


def here(models: Models, on_trial: OnTrial, known: dict[Any, Environment] | None = None) -> Done:
    """Tasks run in this process, one after the other."""
    solved = {} if known is None else known

    def done(tasks: Sequence[Task]) -> dict[str, Trial]:
        found = {}
        for task in tasks:
            found[task.claim.id] = task.run(models, solved)
            on_trial(found[task.claim.id])
        return found

    return done


def _verdicts(
    setting: Setting,
    claims: Sequence[Claim],
    trials: Sequence[Trial],
    compared: Mapping[str, Trial],
) -> list[ClaimVerdict]:
    plain = [
        _plain(claim, setting, claims, compared.get(claim.id))
        for claim in claims
        if claim.setting == setting.name and claim.kind in WITHOUT_DECISION
    ]
    return with_blame([*plain, *choose(trials)], claims, setting)


def _plain(
    claim: Claim, setting: Setting, claims: Sequence[Claim], compared: Trial | None
) -> ClaimVerdict:
    fault = contradicted(claim, setting, claims)
    if fault is None and claim.formula is not None:
        fault = claim_readings(claim, setting)[1]
    if claim.matrices is not None and setting.matrices is not None:
        return verdict_of(claim, decide(claim.matrices, setting.matrices), None, 0.0)
    if fault is not None:
        if (doubt := degrees_are_open(claim, setting)) is not None:
            return verdict_of(claim, Finding("undecided", doubt), None, 0.0)
        return verdict_of(claim, Finding("refuted", fault, method="dimensions"), None, 0.0)
    if is_as_declared(claim, setting) or (compared is not None and compared.findings):
        return _of_definition(claim, setting, compared)
    reason = claim.note if claim.kind == "remark" and claim.note else WITHOUT_DECISION[claim.kind]
    return verdict_of(claim, Finding(claim.kind, reason), None, 0.0)


def _of_definition(claim: Claim, setting: Setting, compared: Trial | None) -> ClaimVerdict:
    """Refuted if under no convention it is what its symbol stands for in all other claims; without
    a trial it is that as declared.
    """
    findings = [] if compared is None else list(compared.findings.values())
    seconds = 0.0 if compared is None else compared.seconds
    token = compared_token(claim, setting)
    if findings and all(finding.verdict in FAILED for finding in findings):
        reason = f"not what {token} stands for in this setting: {findings[0].reason}"
        found = findings[0].told_as("refuted", reason, findings[0].domain)
        return verdict_of(claim, found, None, seconds)
    reason = WITHOUT_DECISION["definition"]
    method = None
    if compared is None or any(finding.verdict == "proved" for finding in findings):
        method = f"equal to what {token} stands for"
        reason = f"{reason}; it is what {token} stands for in this setting"
    return verdict_of(claim, Finding("definition", reason, method=method), None, seconds)


def used_up_verdict(claim: Claim, fixed: Sequence[Fixed]) -> ClaimVerdict:
    """A claim that says what a symbol is defines it: it is not true or false beyond that."""
    symbol = next(s for s in fixed if s.consumed == claim.id)
    others = ", ".join(name for name in symbol.users if name != claim.id)
    reason = (
        f"used up to say what {symbol.token} is, which the source never defines: "
        f"{symbol.solution}, the only solution ({symbol.reason}); judged with it: {others}"
    )
    return verdict_of(claim, Finding("definition", reason), None, 0.0)


def with_symbols(verdict: ClaimVerdict, fixed: Sequence[Fixed]) -> ClaimVerdict:
    """The verdict with the undefined symbols that its claim uses."""
    mine = [symbol for symbol in fixed if verdict.id in symbol.users]
    if not mine:
        return verdict
    entries = tuple(symbol.entry() for symbol in mine)
    reason = verdict.reason
    if verdict.verdict == "undefined":
        reason = "; ".join(symbol.reason for symbol in mine if symbol.consumed is None)
    return replace(verdict, undefined=entries, reason=reason or verdict.reason)


def noted(done: Done, lost: Lost) -> Done:
    """The same; what came to an accident is noted."""

    def run(tasks: Sequence[Task]) -> Mapping[str, Trial]:
        found = done(tasks)
        for task in tasks:
            accident = found[task.claim.id].accident
            if accident is not None:
                lost.append((task, accident))
        return found

    return run


def with_accidents(
    stage: Stage, lost: Lost, *, undefined_symbols: bool
) -> tuple[ClaimVerdict, ...]:
    """The verdicts on a setting, with the accident on which each rests that may rest on one."""
    mine = [(task, why) for task, why in lost if task.claim.setting == stage.setting.name]
    own = {task.claim.id: why for task, why in reversed(mine)}
    trials = {trial.claim.id: trial for trial in stage.tried}
    found = []
    for verdict in stage.verdicts:
        why = own.get(verdict.id)
        touched = undefined_symbols or _rests_on_others(verdict, trials.get(verdict.id), stage)
        if why is None and mine and touched:
            task, what = mine[0]
            why = f"claim {task.claim.id}, of the same setting, was not judged: {what}"
        found.append(replace(verdict, accident=why))
    return tuple(found)


def _rests_on_others(verdict: ClaimVerdict, trial: Trial | None, stage: Stage) -> bool:
    """Whether the other claims of the setting had a part in a verdict: in the choice among
    conventions, or in what is true instead, which may be another definition.
    """
    if stage.setting.matrices is not None:
        return False
    if verdict.verdict in (*NOT_TRUE, "definition"):
        return True
    return trial is not None and (trial.is_open or len(trial.findings) != 1)
