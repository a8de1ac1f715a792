"""Judges claim files: every claim under every convention its setting admits, the choice made once
for the setting.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from gainproof.verify.judge.claim_record import Claim, ClaimFile, Setting
from gainproof.verify.judge.convention import Convention, Unusable, conventions
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.kinds import judge_determines, judge_reading
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.verdict import ClaimVerdict, Finding

Progress = Callable[[str, str], None]
"""Called with the id of a claim and its verdict."""
MOST_CHOICES = 8
WITHOUT_DECISION = {
    "definition": "nothing to decide but dimensions",
    "remark": "no decidable content",
}


@dataclass(frozen=True)
class Trial:
    """What one claim came to under each convention, and how long it took."""

    claim: Claim
    findings: tuple[tuple[Convention, Finding], ...]
    seconds: float


def judge_file(
    claim_file: ClaimFile, models: Sequence[Mapping[str, Any]], *, progress: Progress | None = None
) -> tuple[ClaimVerdict, ...]:
    """The verdict on every claim, in order. `models` are the catalogue's, as plain data.

    Nothing is raised for a claim that cannot be decided: its verdict is `undecided` and says why.
    """
    solved: dict[Any, Environment] = {}
    found: dict[str, ClaimVerdict] = {}
    for setting in claim_file.settings.values():
        for verdict in judge_setting(setting, claim_file.claims, models, solved):
            found[verdict.id] = verdict
            if progress is not None:
                progress(verdict.id, verdict.verdict)
    return tuple(found[claim.id] for claim in claim_file.claims)


def judge_setting(
    setting: Setting,
    claims: Sequence[Claim],
    models: Sequence[Mapping[str, Any]],
    solved: dict[Any, Environment],
) -> list[ClaimVerdict]:
    """The verdicts on all claims of one setting, with one convention for all."""
    mine = [claim for claim in claims if claim.setting == setting.name]
    plain = [claim for claim in mine if claim.kind in WITHOUT_DECISION]
    rest = [claim for claim in mine if claim.kind not in WITHOUT_DECISION]
    verdicts = [_plain(claim) for claim in plain]
    if not rest:
        return verdicts
    usable: list[Convention] = []
    unusable: list[Unusable] = []
    try:
        for convention in conventions(setting, models, solved):
            if isinstance(convention, Unusable):
                unusable.append(convention)
            else:
                usable.append(convention)
    except (Undecided, Malformed, NotEstablished) as reason:
        return [
            *verdicts,
            *[_verdict(c, Finding("undecided", str(reason)), None, 0.0) for c in rest],
        ]
    trials = []
    for claim in rest:
        start = time.perf_counter()
        findings = tuple((c, judge_claim(claim, setting, c.environment)) for c in usable)
        trials.append(Trial(claim, findings, time.perf_counter() - start))
    return [*verdicts, *choose(trials, unusable)]


def _plain(claim: Claim) -> ClaimVerdict:
    reason = claim.note if claim.kind == "remark" and claim.note else WITHOUT_DECISION[claim.kind]
    return _verdict(claim, Finding(claim.kind, reason), None, 0.0)


def judge_claim(claim: Claim, setting: Setting, environment: Environment) -> Finding:
    """One claim in one environment; of several readings the one that is proved, else the first."""
    findings = []
    for label, attempt in _attempts(claim, setting, environment):
        finding = replace(_attempt(attempt), reading=label)
        if finding.verdict == "proved":
            return finding
        findings.append(finding)
    if len({f.verdict for f in findings}) > 1 and any(f.verdict == "undecided" for f in findings):
        return next(f for f in findings if f.verdict == "undecided")
    return findings[0]


def _attempts(
    claim: Claim, setting: Setting, environment: Environment
) -> Iterator[tuple[str | None, Callable[[], Finding]]]:
    if claim.kind == "determines":
        yield None, lambda: judge_determines(claim, Scope(setting, environment))
        return
    if claim.formula is None:
        yield (
            None,
            lambda: Finding("undecided", f"a claim of kind {claim.kind} in words is not covered"),
        )
        return
    several = {
        token: range(len(entry.definition.readings))
        for token, entry in setting.symbols.items()
        if entry.definition is not None and len(entry.definition.readings) > 1
    }
    combinations = list(product(*several.values()))[:MOST_CHOICES]
    for reading in claim.formula.readings:
        for combination in combinations:
            choice = dict(zip(several, combination, strict=True))
            names = [reading.text] if reading.text else []
            names += [_reading_name(setting, token, n) for token, n in choice.items()]
            yield (
                "; ".join(names) or None,
                lambda r=reading, c=choice: judge_reading(claim, r, Scope(setting, environment, c)),  # type: ignore[misc]
            )


def _reading_name(setting: Setting, token: str, n: int) -> str:
    definition = setting.symbols[token].definition
    text = definition.readings[n].text if definition is not None else None
    return f"{token}: {text or n + 1}"


def _attempt(work: Callable[[], Finding]) -> Finding:
    try:
        return work()
    except UndefinedSymbol as reason:
        return Finding("undefined", str(reason), certificate={"symbol": reason.token})
    except (Undecided, Malformed, NotEstablished) as reason:
        return Finding("undecided", str(reason))
    except (RecursionError, MemoryError, OverflowError) as reason:
        return Finding("undecided", f"a limit of the machine: {type(reason).__name__}")


def choose(trials: Sequence[Trial], unusable: Sequence[Unusable]) -> list[ClaimVerdict]:
    """One convention for all claims: those under which every claim that fits any holds."""
    names = [c.environment.name for c, _ in trials[0].findings]
    fits = {
        t.claim.id: {c.environment.name for c, f in t.findings if f.verdict == "proved"}
        for t in trials
    }
    common = [n for n in names if all(n in fit for fit in fits.values() if fit)]
    is_open = any(c.open for c, _ in trials[0].findings)
    return [_chosen(trial, common, fits, is_open, unusable) for trial in trials]


def _chosen(
    trial: Trial,
    common: list[str],
    fits: Mapping[str, set[str]],
    is_open: bool,
    unusable: Sequence[Unusable],
) -> ClaimVerdict:
    claim, findings = trial.claim, {c.environment.name: f for c, f in trial.findings}
    mine = fits[claim.id]
    if not findings:
        reasons = "; ".join(f"{u.name}: {u.reason}" for u in unusable)
        return _verdict(
            claim, Finding("undecided", f"no model could be solved: {reasons}"), None, trial.seconds
        )
    if not is_open:
        return _verdict(claim, next(iter(findings.values())), None, trial.seconds)
    if mine and common:
        best = [n for n in common if n in mine]
        finding = findings[best[0]]
        named = best[0] if len(best) == 1 else "any of: " + "; ".join(best)
        return _verdict(claim, finding, named, trial.seconds, _others(findings, best))
    if mine:
        clash = "; ".join(
            f"{other} under {', '.join(sorted(names))}" for other, names in fits.items() if names
        )
        reason = f"no single convention fits all claims of the setting: {clash}"
        fitting = next(n for n in findings if n in mine)
        finding = replace(findings[fitting], verdict="conditional", reason=reason)
        return _verdict(claim, finding, fitting, trial.seconds, _others(findings, sorted(mine)))
    return _verdict(
        claim,
        _none_fits(findings, common, fits, unusable),
        None,
        trial.seconds,
        _others(findings, []),
    )


def _none_fits(
    findings: Mapping[str, Finding],
    common: list[str],
    fits: Mapping[str, set[str]],
    unusable: Sequence[Unusable],
) -> Finding:
    """No convention makes the claim true: refuted if each was refuted, with the first witness
    shown.
    """
    open_ones = {
        n: f for n, f in findings.items() if f.verdict in ("undecided", "held", "undefined")
    }
    if open_ones or unusable:
        reasons = [f"{n}: {f.reason}" for n, f in open_ones.items()] + [
            f"{u.name}: {u.reason}" for u in unusable
        ]
        kinds = {f.verdict for f in open_ones.values()}
        verdict = "undefined" if kinds == {"undefined"} and not unusable else "undecided"
        return Finding(verdict, "; ".join(reasons))
    chosen = common[0] if any(fits.values()) and common else next(iter(findings))
    conditional = {n: f for n, f in findings.items() if f.verdict == "conditional"}
    first = findings[chosen]
    if conditional and chosen not in conditional and not any(fits.values()):
        chosen, first = next(iter(conditional.items()))
    reason = "; ".join(f"{n}: {f.reason}" for n, f in findings.items())
    return replace(first, reason=f"fits no convention: {reason}")


def _others(findings: Mapping[str, Finding], fitting: Sequence[str]) -> dict[str, Any]:
    """Witnesses against the conventions that do not fit."""
    return {
        n: f.witness.to_json() if f.witness is not None else f.reason
        for n, f in findings.items()
        if n not in fitting
    }


def _verdict(
    claim: Claim,
    finding: Finding,
    convention: str | None,
    seconds: float,
    others: Mapping[str, Any] | None = None,
) -> ClaimVerdict:
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
