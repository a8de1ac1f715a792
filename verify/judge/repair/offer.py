"""Which claims get a repair, and how it stands in their verdicts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.repair.task import RepairTask
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict

NOT_TRUE = ("refuted", "conditional")
NONE_FOUND = "no misprint-like repair found"


def repair_tasks(
    claims: Sequence[Claim],
    setting: Setting,
    verdicts: Iterable[ClaimVerdict],
    environments: Sequence[str],
) -> list[RepairTask]:
    """One for each claim with a formula that is not true as stated."""
    wrong = {verdict.id for verdict in verdicts if verdict.verdict in NOT_TRUE}
    found = []
    for claim in claims:
        if claim.id in wrong and claim.formula is not None and claim.kind != "definition":
            others = tuple(c for c in claims if c.setting == claim.setting and c.id != claim.id)
            found.append(RepairTask(claim, setting, others, tuple(environments)))
    return found


def with_repair(verdict: ClaimVerdict, trial: Trial) -> ClaimVerdict:
    """The verdict with the repair that was found; that none was found is said in the reason."""
    offers: Sequence[Mapping[str, Any]] = (trial.repair or {}).get("offers", ())
    seconds = verdict.seconds + trial.seconds
    if not offers:
        why = NONE_FOUND if trial.failure is None else f"no repair: {trial.failure}"
        truth = (trial.repair or {}).get("truth")
        if truth:
            why += f"; what is true is {truth}"
        return replace(verdict, reason=f"{verdict.reason}; {why}", seconds=seconds)
    first, *rest = offers
    told: dict[str, Any] = {"changes": list(first["changes"]), "under": first["convention"]}
    if rest:
        told["alternatives"] = [
            {"latex": offer["latex"], "changes": list(offer["changes"])} for offer in rest
        ]
    return replace(
        verdict,
        repair={"latex": first["latex"], "verdict": "proved"},
        certificate={**verdict.certificate, "repair": told},
        seconds=seconds,
    )


def explains(definition: Mapping[str, Any], single: Mapping[str, Trial]) -> bool:
    """Whether a changed definition is the better explanation of its claims: one of them has no
    repair of its own, or none has a lighter one.
    """
    weights = []
    for name in definition["claims"]:
        offers = (single[name].repair or {}).get("offers") if name in single else None
        if not offers:
            return True
        weights.append(offers[0]["weight"])
    return bool(definition["weight"] <= min(weights))


def with_definition_repair(
    verdicts: Sequence[ClaimVerdict], trials: Mapping[str, Trial], tokens: Mapping[str, str]
) -> list[ClaimVerdict]:
    """Verdicts in which a changed definition is named that makes several claims true. `trials` are
    those of definition tasks, `tokens` the symbols they are about, both by id of a claim.
    """
    found = {verdict.id: verdict for verdict in verdicts}
    for name, trial in trials.items():
        if trial.repair is None:
            continue
        latex, explained = trial.repair["latex"], list(trial.repair["claims"])
        told = f"{', '.join(explained)} would be proved with {tokens[name]} defined as {latex}"
        for one in dict.fromkeys([*explained, name]):
            verdict = found[one]
            certificate = {**verdict.certificate, "repair of a definition": dict(trial.repair)}
            repair = verdict.repair
            if one == name and one not in explained:
                repair = {"latex": latex, "verdict": "proved"}
            found[one] = replace(
                verdict,
                reason=f"{verdict.reason}; {told}",
                certificate=certificate,
                repair=repair,
            )
    return [found[verdict.id] for verdict in verdicts]
