"""Which claims get a repair, and how it stands in their verdicts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention_choice import admitted_for
from gainproof.verify.judge.kinds.catalogue import kind_named
from gainproof.verify.judge.matrices.repair import MatrixRepairTask
from gainproof.verify.judge.repair.edits import SLIGHT
from gainproof.verify.judge.repair.task import RepairTask
from gainproof.verify.judge.task import Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict
from gainproof.verify.judge.verdict_words import NO_REPAIR

NOT_TRUE = ("refuted", "conditional")


def repair_tasks(
    claims: Sequence[Claim],
    setting: Setting,
    verdicts: Iterable[ClaimVerdict],
    trials: Sequence[Trial],
) -> list[Task]:
    """One for each claim with a formula that is not true as stated. One that is true wherever it
    has a value has no slip but in its conditions.
    """
    wrong = {v.id: v for v in verdicts if v.verdict in NOT_TRUE}
    found: list[Task] = []
    for claim in claims:
        if claim.id not in wrong or not kind_named(claim.kind).repaired:
            continue
        if claim.matrices is not None:
            found.append(MatrixRepairTask(claim, setting))
        if claim.formula is not None:
            if wrong[claim.id].only_lacks_values and not _has_conditions(claim):
                continue
            others = tuple(c for c in claims if c.setting == claim.setting and c.id != claim.id)
            under = tuple(admitted_for(claim, trials))
            tried = next((t.findings for t in trials if t.claim.id == claim.id), {})
            verdict = wrong[claim.id].verdict
            partly = verdict == "conditional" and all(f.verdict == verdict for f in tried.values())
            found.append(RepairTask(claim, setting, others, under, partly))
    return found


def _has_conditions(claim: Claim) -> bool:
    readings = () if claim.formula is None else claim.formula.readings
    return bool(claim.domain or claim.given or any(r.conditions for r in readings))


def with_repair(verdict: ClaimVerdict, trial: Trial) -> ClaimVerdict:
    """The verdict with the repair that was found; that none was found is said in the reason."""
    offers: Sequence[Mapping[str, Any]] = (trial.repair or {}).get("offers", ())
    seconds = verdict.seconds + trial.seconds
    if offers:
        repairs = tuple(
            repair_as_told(offer["latex"], "proved", offer["changes"], offer["convention"])
            for offer in offers
        )
        return replace(verdict, repairs=repairs, seconds=seconds)
    why = NO_REPAIR if trial.failure is None else f"no repair: {trial.failure}"
    truth = (trial.repair or {}).get("truth")
    if truth:
        why += f"; what is true is {truth}"
    return replace(verdict, reason=f"{verdict.reason}; {why}", truth=truth, seconds=seconds)


def repair_as_told(
    latex: str, verdict: str, changes: Sequence[str], under: str = ""
) -> dict[str, Any]:
    """A repair as it stands in a verdict."""
    return {"latex": latex, "verdict": verdict, "changes": list(changes), "under": under}


def explains(definition: Mapping[str, Any], single: Mapping[str, Trial]) -> bool:
    """Whether a changed definition is the better explanation of its claims: one of them has no
    repair of its own, or none has a lighter one. One claim alone blames a definition only for the
    slightest slip.
    """
    names = definition["claims"]
    offers = [(single[n].repair or {}).get("offers") if n in single else None for n in names]
    if len(names) == 1:
        return bool(not offers[0] and definition["weight"] == SLIGHT)
    lightest = min((found[0]["weight"] for found in offers if found), default=0)
    return bool(not all(offers) or definition["weight"] <= lightest)


def with_definition_repair(
    verdicts: Sequence[ClaimVerdict], repair: Mapping[str, Any], printed_in: str | None
) -> list[ClaimVerdict]:
    """Verdicts in which a changed definition is named that makes claims true; the claim
    `printed_in`, if there is one, prints the definition and gets it as its repair.
    """
    latex, explained, token = repair["latex"], list(repair["claims"]), repair["token"]
    wherever = "" if repair["verdict"] == "proved" else " wherever they have a value"
    told = f"{', '.join(explained)} would be proved{wherever} with {token} defined as {latex}"
    found = []
    for verdict in verdicts:
        if verdict.id in (*explained, printed_in):
            certificate = {**verdict.certificate, "repair of a definition": dict(repair)}
            own = repair_as_told(latex, repair["verdict"], repair["changes"])
            verdict = replace(
                verdict,
                reason=f"{verdict.reason}; {told}",
                certificate=certificate,
                repairs=(own,) if verdict.id == printed_in else verdict.repairs,
            )
        found.append(verdict)
    return found
