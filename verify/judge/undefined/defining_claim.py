"""Which claim says what an undefined symbol is: the one that leaves most of the others true."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import reached
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.task import Task, TrialTask
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.undefined.task import SolveTask, with_definition

Done = Callable[[Sequence[Task]], Mapping[str, Trial]]
MOST_SOLUTIONS = 4


@dataclass(frozen=True)
class Fixed:
    """What is known of an undefined symbol.

    `solution` is LaTeX, None if no claim could be solved; `consumed` is the claim that was used up,
    None if the symbol stays undefined, and `reason` says why or on what ground it does not.
    `trials` are those of the other claims that use the symbol, with the solution put in.
    """

    token: str
    solution: str | None
    consumed: str | None
    reason: str
    users: tuple[str, ...]
    trials: Mapping[str, Trial] = field(default_factory=dict)

    def entry(self) -> dict[str, Any]:
        """As it stands in verdicts."""
        consumed = [] if self.consumed is None else [self.consumed]
        return {"symbol": self.token, "solution": self.solution, "consumed": consumed}


def fixed_symbols(
    setting: Setting, claims: Sequence[Claim], done: Done
) -> tuple[Setting, list[Fixed]]:
    """The setting with every undefined symbol defined that the claims fix, and what was found."""
    found: list[Fixed] = []
    for token in [t for t, entry in setting.symbols.items() if entry.role == "undefined"]:
        users = [c for c in claims if token in reached(c, setting)]
        if not users:
            continue
        candidates = _solved(token, setting, users, done)
        best = _best(token, setting, users, candidates, done)
        if best.consumed is not None and best.solution is not None:
            formula = read_formula(best.solution, setting.symbols)
            setting = with_definition(setting, token, formula)
        found.append(best)
    return setting, found


def _solved(
    token: str, setting: Setting, users: Sequence[Claim], done: Done
) -> list[tuple[Claim, Mapping[str, Any]]]:
    """Claims that could be solved, with their solutions; of equal solutions one."""
    tasks: list[Task] = []
    for claim in users:
        others = {t for t in reached(claim, setting) if setting.symbols[t].role == "undefined"}
        if others == {token} and claim.kind == "identity":
            tasks.append(SolveTask(claim, setting, token))
    trials = done(tasks)
    found: dict[str, tuple[Claim, Mapping[str, Any]]] = {}
    for task in tasks:
        solution = trials[task.claim.id].repair
        if solution is not None:
            found.setdefault(solution["definition"], (task.claim, solution))
    ordered = sorted(found.values(), key=lambda pair: not pair[1]["unique"])
    return ordered[:MOST_SOLUTIONS]


def _best(
    token: str,
    setting: Setting,
    users: Sequence[Claim],
    candidates: Sequence[tuple[Claim, Mapping[str, Any]]],
    done: Done,
) -> Fixed:
    names = tuple(claim.id for claim in users)
    if not candidates:
        reason = f"{token} is never defined, and no claim could be solved for it"
        return Fixed(token, None, None, reason, names)
    ranked: list[tuple[tuple[int, int, int], Fixed]] = []
    for claim, solution in candidates:
        latex = solution["definition"]
        formula: Formula = read_formula(latex, setting.symbols)
        changed = with_definition(setting, token, formula)
        others = [c for c in users if c.id != claim.id]
        if not all(_is_within(other, claim) for other in others):
            continue
        trials = done([TrialTask(other, changed) for other in others])
        proved = sum(_is(trial, "proved") for trial in trials.values())
        wrong = sum(
            not _is(t, "proved") and _is(t, "refuted", "conditional") for t in trials.values()
        )
        one = Fixed(token, latex, claim.id, solution["how"], names, trials)
        one = _accepted(one, solution["unique"], proved, wrong)
        ranked.append(((one.consumed is None, wrong - proved, len(latex)), one))
    if not ranked:
        reason = f"{token} is never defined, and the claims that use it hold on different domains"
        return Fixed(token, None, None, reason, names)
    return min(ranked, key=lambda pair: pair[0])[1]


def _is_within(claim: Claim, other: Claim) -> bool:
    """Whether a claim is made only where another one is: it states all that the other states."""
    return all(condition in _stated(claim) for condition in _stated(other))


def _stated(claim: Claim) -> list[object]:
    printed = claim.formula.readings[0].conditions if claim.formula is not None else ()
    return [*claim.domain, *printed, *[formula.readings for formula in claim.given]]


def _is(trial: Trial, *verdicts: str) -> bool:
    return any(finding.verdict in verdicts for finding in trial.findings.values())


def _accepted(one: Fixed, unique: bool, proved: int, wrong: int) -> Fixed:
    """The symbol counts as fixed if the solution is unique and other claims bear it out."""
    told = f"solving {one.consumed} gives {one.solution}"
    if not unique:
        why = f"{told}, which is not shown to be the only solution ({one.reason})"
    elif not one.trials:
        why = f"{told}, but no other claim uses {one.token}, so that nothing is left to judge"
    elif proved <= wrong:
        why = f"{told}, with which {proved} of {len(one.trials)} other claims are true"
    else:
        return one
    return replace(one, consumed=None, reason=f"{one.token} is never defined: {why}", trials={})
