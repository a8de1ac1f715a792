"""Verdicts with their evidence, and their form as plain data."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.statement import Outcome, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.verdict_words import DECIDES, SETTLED


@dataclass(frozen=True)
class Finding:
    """The verdict on one statement under one convention; `reach` counts the points tried before a
    witness, `region` is the part of one parameter of which `domain` tells. `any_filter` says that
    it follows from the file's own definitions.
    """

    verdict: str
    reason: str
    domain: str | None = None
    method: str | None = None
    witness: Witness | None = None
    certificate: Mapping[str, Any] = field(default_factory=dict)
    reading: str | None = None
    reach: int = 0
    region: tuple[Place, ...] = ()
    any_filter: bool = False

    def told_as(self, verdict: str, reason: str, domain: str | None = None) -> Finding:
        """The same under another verdict; the certificate says what its own statement comes to,
        unless it says so already.
        """
        certificate = {DECIDES: self.verdict, **self.certificate}
        return replace(self, verdict=verdict, reason=reason, domain=domain, certificate=certificate)


@dataclass(frozen=True)
class ClaimVerdict:
    """The verdict on one claim of a file.

    `repairs` are all nearest true formulas, the likeliest first: "latex", its "verdict", "changes"
    in words, and "under", the convention under which it is true where the source leaves one open.
    Empty: none looked for, or none found. `truth` is what the formula should say then, if known.
    `any_filter`: it follows from the file's own definitions, whatever the filter is. An `accident`
    is why another run may come to another verdict: a process was killed, paused or short of memory.
    """

    id: str
    place: str
    kind: str
    latex: str
    verdict: str
    domain: str | None
    method: str | None
    certificate: Mapping[str, Any]
    witness: Mapping[str, Any] | None
    convention: str | None
    reading: str | None
    undefined: tuple[Mapping[str, Any], ...]
    reason: str
    seconds: float
    any_filter: bool = False
    repairs: tuple[Mapping[str, Any], ...] = ()
    truth: str | None = None
    accident: str | None = None

    @property
    def repair(self) -> Mapping[str, str] | None:
        """The likeliest of the nearest true formulas, and its verdict."""
        if not self.repairs:
            return None
        return {name: self.repairs[0][name] for name in ("latex", "verdict")}

    @property
    def settled(self) -> bool:
        """Whether the claim is decided, one way or the other."""
        return self.verdict in SETTLED

    @property
    def only_lacks_values(self) -> bool:
        """Whether the claim is true wherever both sides have a value, and no more."""
        sides = [(self.witness or {}).get(side, {}) for side in ("left", "right")]
        return self.verdict == "conditional" and any("undefined" in side for side in sides)

    def __str__(self) -> str:
        """`16a: refuted (why)`, readable where `repr` holds the whole certificate."""
        return f"{self.id}: {self.verdict}{f' ({self.reason})' if self.reason else ''}"

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "id": self.id,
            "place": self.place,
            "kind": self.kind,
            "latex": self.latex,
            "verdict": self.verdict,
            "domain": self.domain,
            "evidence": {
                "method": self.method,
                "certificate": dict(self.certificate) or None,
                "witness": None if self.witness is None else dict(self.witness),
            },
            "repair": None if self.repair is None else dict(self.repair),
            "repairs": [dict(repair) for repair in self.repairs],
            "truth": self.truth,
            "convention": self.convention,
            "reading": self.reading,
            "undefined": [dict(entry) for entry in self.undefined],
            "any_filter": self.any_filter,
            "reason": self.reason,
            "accident": self.accident,
            "seconds": round(self.seconds, 3),
        }


def of_parts(parts: Iterable[Finding]) -> Finding | None:
    """What stands against a claim that says all of these: a refutation, else a part that is not
    proved; None if all are. Raises Undecided where several hold on parts of the domain, and what
    the parts raise.

    That one part is `conditional` says nothing of the claim before all others are known.
    """
    held: Finding | None = None
    some: Finding | None = None
    for found in parts:
        if found.verdict == "conditional":
            if some is not None and some.domain != found.domain:
                raise Undecided(f"parts of it hold in different places: {found.reason}")
            some = some or found
        elif found.verdict == "held":
            held = held or found
        elif found.verdict != "proved":
            return found
    return held or some


def finding_of(outcome: Outcome) -> Finding:
    """An outcome as a finding."""
    return Finding(
        outcome.verdict,
        outcome.reason,
        outcome.domain or None,
        outcome.method,
        outcome.witness,
        outcome.certificate,
        reach=outcome.reach,
        region=outcome.region,
    )
