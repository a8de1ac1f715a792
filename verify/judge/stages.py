"""What is known of the claims of one setting, stage by stage."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.contradicted_convention import other_tasks, under_other_convention
from gainproof.verify.judge.convention_choice import admitted
from gainproof.verify.judge.kinds.definition import defined_token
from gainproof.verify.judge.noise_strength import strength_tasks, with_strengths
from gainproof.verify.judge.repair.definition import DefinitionTask, definition_task
from gainproof.verify.judge.repair.offers import (
    NOT_TRUE,
    explains,
    repair_tasks,
    with_definition_repair,
    with_repair,
)
from gainproof.verify.judge.task import Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict

Done = Callable[[Sequence[Task]], Mapping[str, Trial]]
"""Runs tasks on different claims; what they came to, by id of the claim."""


@dataclass(frozen=True)
class Stage:
    """One setting: all its claims, those that can be decided with their trials, the verdicts."""

    setting: Setting
    claims: tuple[Claim, ...]
    decidable: tuple[Claim, ...]
    tried: tuple[Trial, ...]
    verdicts: tuple[ClaimVerdict, ...]


def with_other_conventions(stages: Iterable[Stage], done: Done) -> list[Stage]:
    """Refuted claims that are all true under one convention which the source excludes are
    conditional; one that another strength of a noise makes true names it.
    """
    stages = list(stages)
    tasks = [t for s in stages for t in other_tasks(s.setting, s.decidable, s.verdicts)]
    trials = done(tasks)
    stages = [
        replace(s, verdicts=tuple(under_other_convention(s.decidable, s.verdicts, trials)))
        for s in stages
    ]
    named = done([t for s in stages for t in strength_tasks(s.setting, s.decidable, s.verdicts)])
    return [replace(s, verdicts=tuple(with_strengths(s.verdicts, named))) for s in stages]


def with_repairs(stages: Iterable[Stage], done: Done) -> list[Stage]:
    """Verdicts with the nearest true formulas: of a definition that explains several claims, else
    of each claim.
    """
    stages = list(stages)
    suspected = {stage.setting.name: _definition_task(stage) for stage in stages}
    single = done(
        [
            task
            for stage in stages
            for task in repair_tasks(stage.claims, stage.setting, stage.verdicts, stage.tried)
        ]
    )
    blamed = done([task for task in suspected.values() if task is not None])
    found = []
    for stage in stages:
        task = suspected[stage.setting.name]
        repair = None if task is None else blamed[task.claim.id].repair
        if repair is None or not explains(repair, single):
            repair = {}
        verdicts = [
            with_repair(v, single[v.id])
            if v.id in single and v.id not in repair.get("claims", ())
            else v
            for v in stage.verdicts
        ]
        if repair:
            verdicts = with_definition_repair(verdicts, repair, _printed_in(stage, repair["token"]))
        found.append(replace(stage, verdicts=tuple(verdicts)))
    return found


def may_get_repair(verdict: ClaimVerdict) -> bool:
    """Whether repairs are looked for that may stand in this verdict; that of a definition may be
    what other claims need.
    """
    return verdict.verdict in (*NOT_TRUE, "definition")


def _definition_task(stage: Stage) -> DefinitionTask | None:
    verdicts = {verdict.id: verdict for verdict in stage.verdicts}
    return definition_task(stage.setting, stage.decidable, verdicts, admitted(stage.tried))


def _printed_in(stage: Stage, token: str) -> str | None:
    """The claim that prints the definition of a symbol."""
    return next((c.id for c in stage.claims if defined_token(c, stage.setting) == token), None)
