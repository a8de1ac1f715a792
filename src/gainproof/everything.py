"""The whole round: derive, compare, check, judge."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gainproof import (
    code_digest,
    derivations,
    drift,
    generated_files,
    judgements,
    places,
    verdicts,
)
from gainproof.claim_words import claim_words
from gainproof.derived import Derived
from gainproof.report import Findings
from gainproof.workshop import Workshop


def find(shop: Workshop, *, accept: bool = False) -> Findings:
    """Look at everything. `accept`: verdicts that changed are written to the snapshots."""
    derivations.ahead(shop)
    subjects = derivations.derive(derivations.catalogue(shop), shop)
    files = generated_files.fresh(None, shop)
    folder = places.generated_folder()
    pairs = [(committed(folder, subject), subject) for subject in subjects]
    reports = derivations.recheck(pairs, shop)
    claim_files = places.claim_files()
    judged = judgements.judge(claim_files, shop)
    changes = {
        file.name: tuple(verdicts.changes(judgement, file))
        for file, judgement in zip(claim_files, judged, strict=True)
    }
    if accept:
        for file, judgement in zip(claim_files, judged, strict=True):
            if changes[file.name]:
                verdicts.write_snapshot(judgement, file)
    return Findings(
        versions=code_digest.versions(),
        files=len(files),
        differences=tuple(drift.compare(files, folder)),
        certificates=tuple(reports),
        judgements=tuple(judged),
        words=tuple(claim_words(judgements.read(file)) for file in claim_files),
        changes=changes,
        accepted=accept,
    )


def committed(folder: Path, subject: Derived) -> Any:
    """The committed certificate of a subject; None, which the checker rejects, if unreadable."""
    path = folder / f"{subject.name.replace('-', '_')}.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
