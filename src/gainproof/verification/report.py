"""What `gainproof run` found, as data and as text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from gainproof.claims.source_words import Words
from gainproof.files import named_files
from gainproof.files.json_lines import in_lines
from gainproof.pages.lecture import count
from gainproof.subjects.derivations import OUTLINES
from gainproof.subjects.drift import CURE, Difference
from gainproof.verdicts import verdict_text
from gainproof.verdicts.verdict_snapshot import Judgement, accidents

Plain = Mapping[str, Any]


@dataclass(frozen=True)
class Findings:
    """Everything that one run looked at.

    `worse`: what proved bounds have lost beside those committed; `certificates`: reports of
    `rechecking.recheck`; `proofs`: those of `claim_proofs.recheck`; `words`: those of claims
    without a formula, for each judgement; `changes`: differences from the snapshot of each claim
    file, by name; `accepted`: they have been taken over; `bounds`: of how many kernels they were
    known, and of how many proved now; `taken`, `done`: how many answers of each task came from the
    cache, and were worked for; `trials`: the same of what the judge asks of its claims.
    """

    versions: Mapping[str, str]
    files: int
    differences: tuple[Difference, ...]
    worse: tuple[str, ...]
    certificates: tuple[Plain, ...]
    judgements: tuple[Judgement, ...]
    proofs: tuple[Plain, ...]
    words: tuple[Words, ...]
    changes: Mapping[str, tuple[str, ...]]
    accepted: bool
    bounds: tuple[int, int]
    taken: Mapping[str, int]
    done: Mapping[str, int]
    trials: tuple[int, int]

    @property
    def rejected(self) -> list[Plain]:
        """Certificates that were not accepted."""
        return [report for report in self.certificates if not report["accepted"]]

    @property
    def good(self) -> bool:
        """No drift, no rejected certificate or proof, no verdict changed or missing by accident."""
        changed = any(self.changes.values()) and not self.accepted
        unproved = any(report["rejected"] for report in self.proofs)
        missing = any(map(accidents, self.judgements))
        return not (self.differences or self.rejected or unproved or changed or missing)


def write(findings: Findings, folder: Path) -> None:
    """Write report.json and report.txt. Raises BadInputError where they cannot be written."""
    texts = {"report.json": as_json(findings), "report.txt": as_text(findings)}
    named_files.write({folder / name: text.encode("utf-8") for name, text in texts.items()})


def as_json(findings: Findings) -> str:
    """The findings as one JSON object."""
    data = {
        "good": findings.good,
        "versions": dict(findings.versions),
        "generated": {
            "files": findings.files,
            "differences": [asdict(difference) for difference in findings.differences],
            "worse": list(findings.worse),
        },
        "certificates": list(findings.certificates),
        "claims": list(findings.judgements),
        "proofs": list(findings.proofs),
        "snapshot": {
            "accepted": findings.accepted,
            "changes": {name: list(lines) for name, lines in findings.changes.items()},
        },
    }
    return in_lines(data, 4) + "\n"


def as_text(findings: Findings) -> str:
    """The findings for people: summary, certificates, verdicts."""
    versions = ", ".join(f"{name} {version}" for name, version in findings.versions.items())
    parts = [summary(findings), f"Made with {versions}.\n", certificates_text(findings)]
    parts += [
        verdict_text.overview(judgement, words=words)
        for judgement, words in zip(findings.judgements, findings.words, strict=True)
    ]
    return "\n".join(parts)


def summary(findings: Findings) -> str:
    """A few lines: what was looked at, what came of it, and the cure of what is wrong."""
    lines = [
        _line("derivations", f"{len(findings.certificates)} derived{_kept(findings, 'derive')}"),
        _line("generated files", _files(findings)),
        *(f"{'':18}{difference.text()}" for difference in findings.differences),
        *(f"{'':18}{sentence}" for sentence in findings.worse),
        _line("certificates", _certificates(findings)),
        *(f"{'':18}{report['subject']}: {report['reason']}" for report in findings.rejected),
        _line("claims", verdict_text.counts(list(findings.judgements)) + _trials(findings)),
        *_accidents(findings),
        *_proofs(findings),
        _line("snapshot", _snapshot(findings)),
        *_changes(findings),
    ]
    return "\n".join(lines) + "\n"


def _accidents(findings: Findings) -> list[str]:
    """The claims of which this run knows nothing, where there are some."""
    found = [
        f"{'':18}{judgement['source']['key']}, {name}: {why}"
        for judgement in findings.judgements
        for name, why in accidents(judgement).items()
    ]
    told = f"{len(found)}, by accident; the snapshot stays as it was there: run again"
    return [_line("not judged", told), *found] if found else []


def _proofs(findings: Findings) -> list[str]:
    """What the checker says of proofs on matrices of every size, where there are some."""
    if not findings.proofs:
        return []
    wrong = [(report["source"], each) for report in findings.proofs for each in report["rejected"]]
    claims = sum(report["claims"] for report in findings.proofs)
    statements = sum(report["statements"] for report in findings.proofs)
    return [
        _line(
            "matrix proofs",
            f"{claims - len(wrong)} of {claims} accepted again by the checker; "
            f"{statements} statements",
        ),
        *(f"{'':18}{key}, {each['id']}: {each['reason']}" for key, each in wrong),
    ]


def _changes(findings: Findings) -> list[str]:
    """Each change under its claim file: claims of two sources may have one name."""
    lines = []
    for file, changes in findings.changes.items():
        if changes:
            lines += [f"{'':18}{file}", *(f"{'':20}{change}" for change in changes)]
    return lines


def certificates_text(findings: Findings) -> str:
    """One line for each certificate."""
    lines = ["Certificates, checked exactly without computer algebra", ""]
    width = max((len(report["subject"]) for report in findings.certificates), default=0)
    for report in findings.certificates:
        statements = report["statements"]
        seconds = sum(statement["seconds"] for statement in statements)
        tally = count(statement["status"] for statement in statements) or report["reason"]
        word = "accepted" if report["accepted"] else "REJECTED"
        lines.append(f"  {report['subject']:<{width}}  {word}  {tally} ({seconds:.2f} s)")
    return "\n".join(lines) + "\n"


def _line(label: str, text: str) -> str:
    return f"{label + ':':<18}{text}"


def _files(findings: Findings) -> str:
    if not findings.differences:
        taken, proved = findings.bounds
        said = f"; bounds of {taken} kernels known, of {proved} proved now" if taken else ""
        return f"{findings.files}, each byte as derived{said}"
    return f"{len(findings.differences)} of {findings.files} not as derived; {CURE}"


def _certificates(findings: Findings) -> str:
    total = len(findings.certificates)
    statements = [s["status"] for report in findings.certificates for s in report["statements"]]
    good = total - len(findings.rejected)
    said = f"{good} of {total} accepted; {len(statements)} statements: {count(statements)}"
    return said + _kept(findings, "recheck")


def _kept(findings: Findings, task: str) -> str:
    """What was taken from the cache, if anything was."""
    taken, done = findings.taken.get(task, 0), findings.done.get(task, 0)
    return f"; {taken} from the cache, {done} now" if taken else ""


def _trials(findings: Findings) -> str:
    """The same of the judge: each claim is tried, and repairs are looked for."""
    taken, done = findings.trials
    return f"; {taken} trials from the cache, {done} now" if taken else ""


def _snapshot(findings: Findings) -> str:
    changed = sum(map(len, findings.changes.values()))
    if not changed:
        return "unchanged"
    if findings.accepted:
        return f"{changed} changes accepted"
    if OUTLINES in {each.name for each in findings.differences}:
        return f"{changed} changes, under models that are not those derived: {CURE} first"
    return f"{changed} changes; if they are right, `gainproof run --accept` takes them over"
