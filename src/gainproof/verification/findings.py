"""The whole round: derive, compare, check, judge."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gainproof.claims import judgements
from gainproof.claims.source_words import claim_words
from gainproof.files import places
from gainproof.jobs import code_digest
from gainproof.jobs.session import Session
from gainproof.jobs.workers import Job
from gainproof.subjects import bounds_ledger, derivations, drift, generated_files
from gainproof.verdicts import verdict_snapshot
from gainproof.verification.report import Findings

DONE = {
    "everything": "derived and printed",
    "recheck": "certificate checked",
    "judge": "judged",
    "recheck_proofs": "proofs checked",
}
"""What people are told of the jobs."""


def find(session: Session, *, accept: bool = False) -> Findings:
    """Look at everything. `accept`: verdicts that changed are written to the snapshots, unless the
    shipped models, under which claims are judged, are not those that were derived.
    """
    folder = places.generated_folder()
    claim_files = places.claim_files()
    names = derivations.catalogue()
    ahead(session, folder, claim_files)
    subjects = derivations.derive(names, session)
    files = generated_files.fresh((), session)
    worse = bounds_ledger.worse(folder, files.get(bounds_ledger.NAME, b"{}"))
    pairs = [(committed(folder, subject.name), subject) for subject in subjects]
    reports = derivations.recheck(pairs, session)
    judged = judgements.judge(claim_files, session)
    proofs = judgements.recheck_proofs(judged, session)
    changes = {
        file.name: tuple(verdict_snapshot.changes(judgement, file))
        for file, judgement in zip(claim_files, judged, strict=True)
    }
    differences = tuple(drift.compare(files, folder))
    accept = accept and derivations.OUTLINES not in {each.name for each in differences}
    if accept:
        for file, judgement in zip(claim_files, judged, strict=True):
            if changes[file.name]:
                verdict_snapshot.write_snapshot(judgement, file)
    return Findings(
        versions=code_digest.versions(),
        files=len(files),
        differences=differences,
        worse=tuple(worse),
        certificates=tuple(reports),
        judgements=tuple(judged),
        proofs=tuple(proofs),
        words=tuple(claim_words(judgements.read(file)) for file in claim_files),
        changes=changes,
        accepted=accept,
        bounds=_bounds(session, folder),
        taken=Counter(session.taken.values()),
        done=Counter(session.done.values()),
        trials=judgements.trials(claim_files, session),
    )


def ahead(session: Session, folder: Path, claim_files: Sequence[Path]) -> None:
    """Have all done that `find` asks for: every subject of the catalogue, after each the check of
    its committed certificate; and the claim files, after each the check of its proofs.
    """
    bounds = bounds_ledger.usable(folder, session.cache.fresh)

    def after(job: Job) -> list[Job]:
        if job.task == "judge":
            judged = session.answered(job)
            checking = None if judged is None else judgements.proofs_job(judged)
            return [] if checking is None else [checking]
        if job.task != "everything":
            return []
        name = job.arguments["name"]
        return [derivations.recheck_job(committed(folder, name), derivations.known(name, session))]

    # the longest last among the subjects: its check ends among the short ones of claim files
    names = sorted(derivations.catalogue(), key=lambda name: _size(_path(folder, name)))
    jobs = [derivations.everything_job(name, bounds) for name in names]
    session.ahead([*jobs, *judgements.jobs(claim_files, session.cache).values()], after, DONE)


def _bounds(session: Session, folder: Path) -> tuple[int, int]:
    """How many kernels have bounds that were known, and how many were proved now."""
    known = bounds_ledger.usable(folder, session.cache.fresh)
    taken = proved = 0
    for name in derivations.catalogue():
        job = derivations.print_job(name, known)
        counts = (session.answered(job) or {})["counts"]
        now = counts["proved"] if session.was_done(job) else 0
        proved += now
        taken += counts["taken"] + counts["proved"] - now
    return taken, proved


def committed(folder: Path, name: str) -> Any:
    """The committed certificate of a subject; None, which the checker rejects, if unreadable."""
    try:
        return json.loads(_path(folder, name).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None


def _path(folder: Path, name: str) -> Path:
    return folder / f"{derivations.module_of(name)}.json"


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0
