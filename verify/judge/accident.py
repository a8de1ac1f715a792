"""Verdicts that rest on an accident: what was broken off may have chosen a convention, said what a
symbol is, or offered a repair, so that another run may come to something else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from gainproof.verify.judge.repair.offer import NOT_TRUE
from gainproof.verify.judge.stages import Done, Stage
from gainproof.verify.judge.task import Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict

Lost = list[tuple[Task, str]]
"""Tasks of which nothing is known, and why."""


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
