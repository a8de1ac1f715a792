"""The choice of a convention, made once for all claims of a setting."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.convention import READING
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict, Finding
from gainproof.verify.judge.verdict_words import OTHERS

MOST_NAMED = 12
UNSETTLED = ("undecided", "held", "undefined")


def choose(trials: Sequence[Trial]) -> list[ClaimVerdict]:
    """The verdicts under those conventions under which every claim that fits any of them holds."""
    fits, common = _fits(trials), _common(trials)
    # where no convention suits all claims, none is ruled out by them
    excluded = _excluded(trials, fits) if common else frozenset()
    return [_chosen(trial, common, fits, excluded) for trial in trials]


def admitted(trials: Sequence[Trial]) -> list[str]:
    """Conventions that the source may have: those that `choose` takes; where there are none, those
    that a claim fits; all if no claim fits any.
    """
    names = list(dict.fromkeys(name for trial in trials for name in trial.findings))
    fitting = set().union(*_fits(trials).values())
    return _common(trials) or [name for name in names if name in fitting] or names


def admitted_for(claim: Claim, trials: Sequence[Trial]) -> list[str]:
    """Conventions under which another formula may stand in the place of a claim: those that the
    source may have; where its claims need different ones, those of the other claims.
    """
    fits = _fits(trials)
    if _common(trials) or not any(fits.values()):
        return admitted(trials)
    others = {name for other, fit in fits.items() if other != claim.id for name in fit}
    return [name for name in admitted(trials) if name in others - fits.get(claim.id, set())]


def _fits(trials: Sequence[Trial]) -> dict[str, set[str]]:
    return {t.claim.id: {n for n, f in t.findings.items() if f.verdict == "proved"} for t in trials}


def _common(trials: Sequence[Trial]) -> list[str]:
    names = list(dict.fromkeys(name for trial in trials for name in trial.findings))
    fits = _fits(trials)
    return [n for n in names if all(n in fit for fit in fits.values() if fit)]


def _chosen(
    trial: Trial, common: list[str], fits: Mapping[str, set[str]], excluded: frozenset[str]
) -> ClaimVerdict:
    claim, findings, mine = trial.claim, trial.findings, fits[trial.claim.id]
    if trial.failure is not None or not findings:
        several = len(trial.unusable) > 1
        reasons = "; ".join(
            f"{u.name}: {u.reason}" if several else u.reason for u in trial.unusable
        )
        reason = trial.failure or f"no model could be solved: {reasons}"
        return verdict_of(claim, Finding("undecided", reason), None, trial.seconds)
    if len(findings) == 1 and not trial.is_open:
        return verdict_of(claim, next(iter(findings.values())), None, trial.seconds)
    if mine and (common or len(mine) == len(findings)):
        # what holds under every convention is true, whatever other claims contradict one another
        best = [n for n in common or findings if n in mine]
        others = _others(findings, best)
        return verdict_of(claim, findings[best[0]], _named(trial, best), trial.seconds, others)
    if mine:
        clash = "; ".join(
            f"{other} under {', '.join(sorted(names))}" for other, names in fits.items() if names
        )
        what = "convention" if trial.is_open else "reading of a definition"
        reason = f"no single {what} fits all claims of the setting: {clash}"
        fitting = next(n for n in findings if n in mine)
        fit = findings[fitting]
        finding = fit.told_as("conditional", reason, fit.domain)
        others = _others(findings, sorted(mine))
        return verdict_of(claim, finding, _named(trial, [fitting]), trial.seconds, others)
    finding, partly = _none_fits(trial, common, fits, excluded)
    named = None if partly is None else _named(trial, [partly])
    return verdict_of(claim, finding, named, trial.seconds, _others(findings, []))


def _named(trial: Trial, fitting: Sequence[str]) -> str | None:
    """The conventions that fit, in words; None if the source left nothing open. Which reading of a
    definition is meant is told with the reading.
    """
    if not trial.is_open:
        return None
    names = list(dict.fromkeys(name.partition(READING)[0] for name in fitting))
    if len(names) == 1:
        return names[0]
    more = f"; and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
    return "any of: " + "; ".join(names[:MOST_NAMED]) + more


def _none_fits(
    trial: Trial, common: list[str], fits: Mapping[str, set[str]], excluded: frozenset[str]
) -> tuple[Finding, str | None]:
    """No convention makes the claim true: refuted if each was refuted, with one witness in front.

    The convention that the other claims of the setting chose comes first, then one under which the
    claim holds on a part of its domain; such a one is named.
    """
    findings = trial.findings
    decided = any(fits.values())
    unusable = () if decided and common else trial.unusable
    possible = {n: f for n, f in findings.items() if n not in excluded}
    unsettled = {n: f for n, f in possible.items() if f.verdict in UNSETTLED}
    if unsettled or unusable:
        reasons = [f"{n}: {f.reason}" for n, f in unsettled.items()]
        reasons += [f"{u.name}: {u.reason}" for u in unusable]
        kinds = {f.verdict for f in unsettled.values()}
        verdict = "undefined" if kinds == {"undefined"} and not unusable else "undecided"
        first = next(iter(unsettled.values()), None)
        certificate = {} if first is None or verdict == "undecided" else first.certificate
        return Finding(verdict, _told(reasons), certificate=certificate), None
    settled = [n for n in common if decided]
    partly = [n for n, f in findings.items() if f.verdict == "conditional"]
    chosen = [*settled, *partly, *findings][0]
    what = "convention" if trial.is_open else "reading of a definition"
    reason = _told([f"{n}: {f.reason}" for n, f in findings.items()])
    finding = replace(findings[chosen], reason=f"fits no {what}: {reason}")
    return finding, chosen if finding.verdict == "conditional" else None


def _told(reasons: Sequence[str]) -> str:
    more = len(reasons) - MOST_NAMED
    return "; ".join(reasons[:MOST_NAMED]) + (f"; and {more} more" if more > 0 else "")


def _excluded(trials: Sequence[Trial], fits: Mapping[str, set[str]]) -> frozenset[str]:
    """Conventions that a claim rules out which is true under another."""
    return frozenset(
        name
        for trial in trials
        if fits[trial.claim.id]
        for name, finding in trial.findings.items()
        if finding.verdict in ("refuted", "conditional")
    )


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
        certificate[OTHERS] = dict(others)
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
        convention=convention,
        reading=finding.reading,
        undefined=undefined,
        reason=finding.reason,
        seconds=seconds,
        any_filter=finding.any_filter and finding.verdict == "proved",
    )
