"""The choice of a convention, made once for all claims of a setting."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim_record import Claim
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict, Finding


def choose(trials: Sequence[Trial]) -> list[ClaimVerdict]:
    """The verdicts under those conventions under which every claim that fits any of them holds."""
    fits, common = _fits(trials), _common(trials)
    return [_chosen(trial, common, fits) for trial in trials]


def admitted(trials: Sequence[Trial]) -> list[str]:
    """Conventions that the source may have: those that `choose` takes, all if there is none."""
    names = list(dict.fromkeys(name for trial in trials for name in trial.findings))
    return _common(trials) or names


def _fits(trials: Sequence[Trial]) -> dict[str, set[str]]:
    return {t.claim.id: {n for n, f in t.findings.items() if f.verdict == "proved"} for t in trials}


def _common(trials: Sequence[Trial]) -> list[str]:
    names = list(dict.fromkeys(name for trial in trials for name in trial.findings))
    fits = _fits(trials)
    return [n for n in names if all(n in fit for fit in fits.values() if fit)]


def _chosen(trial: Trial, common: list[str], fits: Mapping[str, set[str]]) -> ClaimVerdict:
    claim, findings, mine = trial.claim, trial.findings, fits[trial.claim.id]
    if trial.failure is not None or not findings:
        reasons = "; ".join(f"{u.name}: {u.reason}" for u in trial.unusable)
        reason = trial.failure or f"no model could be solved: {reasons}"
        return verdict_of(claim, Finding("undecided", reason), None, trial.seconds)
    if not trial.is_open:
        return verdict_of(claim, next(iter(findings.values())), None, trial.seconds)
    if mine and common:
        best = [n for n in common if n in mine]
        named = best[0] if len(best) == 1 else "any of: " + "; ".join(best)
        others = _others(findings, best)
        return verdict_of(claim, findings[best[0]], named, trial.seconds, others)
    if mine:
        clash = "; ".join(
            f"{other} under {', '.join(sorted(names))}" for other, names in fits.items() if names
        )
        reason = f"no single convention fits all claims of the setting: {clash}"
        fitting = next(n for n in findings if n in mine)
        finding = replace(findings[fitting], verdict="conditional", reason=reason)
        others = _others(findings, sorted(mine))
        return verdict_of(claim, finding, fitting, trial.seconds, others)
    finding, partly = _none_fits(trial, common, fits)
    return verdict_of(claim, finding, partly, trial.seconds, _others(findings, []))


def _none_fits(
    trial: Trial, common: list[str], fits: Mapping[str, set[str]]
) -> tuple[Finding, str | None]:
    """No convention makes the claim true: refuted if each was refuted, with one witness in front.

    The convention that the other claims of the setting chose comes first, then one under which the
    claim holds on a part of its domain; such a one is named.
    """
    findings, unusable = trial.findings, trial.unusable
    unsettled = {
        n: f for n, f in findings.items() if f.verdict in ("undecided", "held", "undefined")
    }
    if unsettled or unusable:
        reasons = [f"{n}: {f.reason}" for n, f in unsettled.items()]
        reasons += [f"{u.name}: {u.reason}" for u in unusable]
        kinds = {f.verdict for f in unsettled.values()}
        verdict = "undefined" if kinds == {"undefined"} and not unusable else "undecided"
        first = next(iter(unsettled.values()), None)
        certificate = {} if first is None or verdict == "undecided" else first.certificate
        return Finding(verdict, "; ".join(reasons), certificate=certificate), None
    settled = [n for n in common if any(fits.values())]
    partly = [n for n, f in findings.items() if f.verdict == "conditional"]
    chosen = [*settled, *partly, *findings][0]
    reason = "; ".join(f"{n}: {f.reason}" for n, f in findings.items())
    finding = replace(findings[chosen], reason=f"fits no convention: {reason}")
    return finding, chosen if finding.verdict == "conditional" else None


def _others(findings: Mapping[str, Finding], fitting: Sequence[str]) -> dict[str, Any]:
    """Witnesses against the conventions that do not fit."""
    return {
        n: f.witness.to_json() if f.witness is not None else f.reason
        for n, f in findings.items()
        if n not in fitting and f.verdict != "proved"
    }


def verdict_of(
    claim: Claim,
    finding: Finding,
    convention: str | None,
    seconds: float,
    others: Mapping[str, Any] | None = None,
) -> ClaimVerdict:
    """The verdict on a claim; `others` are witnesses against conventions that were not chosen."""
    certificate = dict(finding.certificate)
    if others:
        certificate["against other conventions"] = dict(others)
    undefined: tuple[Mapping[str, Any], ...] = ()
    if finding.verdict == "undefined":
        undefined = ({"symbol": certificate.pop("symbol", ""), "solution": None, "consumed": []},)
    return ClaimVerdict(
        id=claim.id,
        place=claim.place,
        kind=claim.kind,
        latex=claim.latex,
        verdict=finding.verdict,
        domain=finding.domain,
        method=finding.method,
        certificate=certificate,
        witness=None if finding.witness is None else finding.witness.to_json(),
        repair=None,
        convention=convention,
        reading=finding.reading,
        undefined=undefined,
        reason=finding.reason,
        seconds=seconds,
    )
