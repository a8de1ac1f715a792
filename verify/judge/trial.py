"""One claim under every convention that its setting admits."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.convention import Unusable, conventions
from gainproof.verify.judge.dimension import fitting_readings
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.kinds import judge_determines, judge_reading
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.verdict import Finding

MOST_CHOICES = 8


@dataclass(frozen=True)
class Trial:
    """What one claim came to: finding by convention, and models that could not be solved.

    `is_open` says whether the source left the convention open. `failure` is why there is no
    finding. `repair` is what a search for true formulas nearby came to, where there was one.
    """

    claim: Claim
    findings: Mapping[str, Finding]
    unusable: tuple[Unusable, ...]
    is_open: bool
    seconds: float
    failure: str | None = None
    repair: Mapping[str, Any] | None = None


def try_claim(
    claim: Claim,
    setting: Setting,
    models: Sequence[Mapping[str, Any]],
    solved: dict[Any, Environment],
) -> Trial:
    """The claim in every environment of its setting; `solved` keeps these for others."""
    start = time.perf_counter()
    findings: dict[str, Finding] = {}
    unusable: list[Unusable] = []
    is_open, failure = False, None
    try:
        for convention in conventions(setting, models, solved):
            if isinstance(convention, Unusable):
                unusable.append(convention)
            else:
                is_open = is_open or convention.open
                environment = convention.environment
                findings[environment.name] = judge_claim(claim, setting, environment)
    except (Undecided, Malformed, NotEstablished) as reason:
        failure = str(reason)
    seconds = time.perf_counter() - start
    return Trial(claim, findings, tuple(unusable), is_open, seconds, failure)


def judge_claim(claim: Claim, setting: Setting, environment: Environment) -> Finding:
    """One claim in one environment; of several readings the one that is proved, else the first."""
    findings = []
    for label, attempt in _attempts(claim, setting, environment):
        finding = replace(_attempt(attempt), reading=label)
        if environment.facts and finding.certificate:
            established = [fact.sentence for fact in environment.facts]
            finding = replace(
                finding, certificate={**finding.certificate, "established": established}
            )
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
    readings, fault = fitting_readings(claim.formula, setting)
    if fault is not None:
        yield None, lambda: Finding("refuted", fault, method="dimensions")
    for reading in readings:
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
    except (RecursionError, MemoryError, ArithmeticError, ValueError) as reason:
        return Finding("undecided", f"the arithmetic stopped: {type(reason).__name__}: {reason}")
