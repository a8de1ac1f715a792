"""One claim in one environment."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace

from gainproof.verify.judge.charted import judge_in
from gainproof.verify.judge.cited import cited
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.dimensions.claim import claim_readings
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.pruning import seen_to_fail
from gainproof.verify.judge.scope import UndefinedSymbol
from gainproof.verify.judge.setting.environment import (
    INDEX,
    SAMPLE,
    Environment,
    NotEstablished,
)
from gainproof.verify.judge.verdict import Finding


def judge_claim(claim: Claim, setting: Setting, environment: Environment) -> Finding:
    """One claim in one environment; of several readings the one that is proved, else the first."""
    findings = []
    for label, attempt in _attempts(claim, setting, environment):
        finding = replace(_attempt(attempt), reading=label)
        finding = replace(finding, domain=_in_index(finding.domain, setting, environment))
        told = {
            "established": [fact.sentence for fact in environment.facts],
            "cited": cited(claim, setting),
        }
        if finding.certificate:
            more = {name: sentences for name, sentences in told.items() if sentences}
            finding = replace(finding, certificate={**finding.certificate, **more})
        if finding.verdict == "proved":
            return finding
        findings.append(finding)
    if len({f.verdict for f in findings}) > 1 and any(f.verdict == "undecided" for f in findings):
        return next(f for f in findings if f.verdict == "undecided")
    return findings[0]


def _in_index(domain: str | None, setting: Setting, environment: Environment) -> str | None:
    """All values of a parameter that is no tracking index, told as those of the index: each belongs
    to one of its values.
    """
    name = environment.parameter
    if domain is None or name in (None, INDEX, SAMPLE):
        return domain
    whole = environment.boxes[name].text(name)
    tokens = (token for token, entry in setting.symbols.items() if entry.quantity == INDEX)
    told = f"{next(tokens, INDEX)} > 0"
    # a number that goes on is another one
    return re.sub(re.escape(whole) + r"(?![\d./^])", lambda _: told, domain)


def _attempts(
    claim: Claim, setting: Setting, environment: Environment
) -> Iterator[tuple[str | None, Callable[[], Finding]]]:
    readings, fault = claim_readings(claim, setting)
    if fault is not None:
        yield None, lambda: _of_dimensions(claim, fault, setting, environment)
    elif claim.formula is None:
        yield None, lambda: judge_in(claim, None, setting, environment)
    for reading in readings:
        yield (
            reading.text,
            lambda r=reading: judge_in(claim, r, setting, environment),  # type: ignore[misc]
        )


def _of_dimensions(claim: Claim, fault: str, setting: Setting, environment: Environment) -> Finding:
    """Refuted for its dimensions, with a point at which it fails in units of its own, if one is
    seen.
    """
    readings = () if claim.formula is None else claim.formula.readings
    failing = [seen_to_fail(claim, r, setting, environment) for r in readings]
    witness = failing[0].witness if failing and failing[0] and all(failing) else None
    return Finding("refuted", fault, method="dimensions", witness=witness)


def _attempt(work: Callable[[], Finding]) -> Finding:
    try:
        return work()
    except UndefinedSymbol as reason:
        return Finding("undefined", str(reason), certificate={"symbol": reason.token})
    except (Undecided, Malformed, NotEstablished) as reason:
        return Finding("undecided", str(reason))
    except (RecursionError, MemoryError, ArithmeticError, ValueError) as reason:
        return Finding("undecided", f"the arithmetic stopped: {type(reason).__name__}: {reason}")
