"""One claim under every convention that its setting admits."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_decision import judge_claim
from gainproof.verify.judge.claim_symbols import reached
from gainproof.verify.judge.convention import Convention, Unusable, conventions
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.kinds.catalogue import kind_named
from gainproof.verify.judge.matrices.decision import decide
from gainproof.verify.judge.matrices.layered_proof import Proofs
from gainproof.verify.judge.quick_refutation import seen_false
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.verdict import Finding

FEW = 4
"""So many conventions are judged in full; of more, only those that two points do not rule out."""


@dataclass(frozen=True)
class Trial:
    """What one claim came to: finding by convention, and models that could not be solved.

    `is_open` says whether the source left the convention open. `failure` is why there is no
    finding. `repair` is what a search for true formulas nearby came to, where there was one.

    An `accident` is why this says nothing of the claim: the work was broken off by something else.
    `timed`: a limit of processor time broke it off, or its search; another machine may come
    further.
    """

    claim: Claim
    findings: Mapping[str, Finding]
    unusable: tuple[Unusable, ...]
    is_open: bool
    seconds: float
    failure: str | None = None
    repair: Mapping[str, Any] | None = None
    accident: str | None = None
    timed: bool = False


PROOFS = "proofs of claims on matrices"


def proofs_in(solved: dict[Any, Any]) -> Proofs:
    """Those of claims on matrices, in what is kept for other tasks."""
    return solved.setdefault(PROOFS, {})  # type: ignore[no-any-return]


def try_claim(
    claim: Claim,
    setting: Setting,
    models: Sequence[Mapping[str, Any]],
    solved: dict[Any, Any],
) -> Trial:
    """The claim under every convention of its setting; `solved` keeps environments and
    proofs of claims on matrices for others."""
    start = time.perf_counter()
    if claim.matrices is not None and setting.matrices is not None:
        finding = decide(claim.matrices, setting.matrices, proofs_in(solved))
        return Trial(claim, {"": finding}, (), False, time.perf_counter() - start)
    findings: dict[str, Finding] = {}
    found: list[Convention | Unusable] = []
    failure = None
    try:
        found = list(conventions(setting, models, solved))
        findings = findings_of(claim, [c for c in found if isinstance(c, Convention)])
    except (Undecided, Malformed, NotEstablished) as reason:
        failure = str(reason)
    unusable = tuple(c for c in found if isinstance(c, Unusable))
    is_open = any(isinstance(c, Convention) and c.open for c in found)
    seconds = time.perf_counter() - start
    return Trial(claim, findings, unusable, is_open, seconds, failure)


def findings_of(claim: Claim, found: Sequence[Convention]) -> dict[str, Finding]:
    """By name of the convention; those alike in all that the claim uses are judged once."""
    groups: dict[object, list[Convention]] = {}
    for convention in found:
        groups.setdefault(_seen_by(claim, convention), []).append(convention)
    firsts = [same[0] for same in groups.values()]
    by_first: dict[str, Finding] = {}
    if len(firsts) > FEW:
        by_first = {c.name: f for c in firsts if (f := seen_false(claim, c)) is not None}
    rest = [c for c in firsts if c.name not in by_first]
    if not rest:
        # false under all of them: on which part of its domain it may hold is said for the first
        rest = firsts[:FEW]
    by_first |= {c.name: _judged(claim, c) for c in rest}
    return {c.name: by_first[same[0].name] for same in groups.values() for c in same}


def _judged(claim: Claim, convention: Convention) -> Finding:
    finding = judge_claim(claim, convention.setting, convention.environment)
    if convention.reading is None or not _has_choice(claim, convention):
        return finding
    names = [name for name in (finding.reading, convention.reading) if name]
    return replace(finding, reading="; ".join(names))


def _has_choice(claim: Claim, convention: Convention) -> bool:
    """Whether the claim uses a definition that was given one of several readings."""
    words = convention.reading or ""
    tokens = {part.partition(": ")[0] for part in words.split("; ")}
    return bool(tokens & reached(claim, convention.setting))


def _seen_by(claim: Claim, convention: Convention) -> object:
    """All of a convention that a claim can depend on."""
    environment, setting = convention.environment, convention.setting
    tokens = sorted(reached(claim, setting))
    used: list[object] = [tuple(sorted(environment.boxes.items(), key=lambda item: item[0]))]
    for token in tokens:
        entry = setting.symbols[token]
        quantity = environment.quantities.get(entry.quantity or "")
        readings = entry.definition.readings if entry.definition is not None else ()
        texts = tuple(reading.text for reading in readings)
        assigned = environment.assigned.get(token)
        own = assigned and assigned.key
        used.append((token, entry.unit, quantity and quantity.key, own, texts))
    if kind_named(claim.kind).of_setting or not any(setting.symbols[t].quantity for t in tokens):
        used.append(environment.name)
    return tuple(used)
