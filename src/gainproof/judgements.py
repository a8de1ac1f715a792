"""Judgements of claim files, from worker processes or the cache."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from gainproof import claim_proofs, derivations, given_file, places, workers
from gainproof.bad_input import BadInputError, unknown_name
from gainproof.commands.time_limit import DEFAULT
from gainproof.workshop import Workshop


def judge(
    files: Sequence[Path], shop: Workshop, seconds: float = DEFAULT, *, keep_going: bool = False
) -> list[dict[str, Any]]:
    """{"source", "claims"} of every file; a claim that takes more than `seconds` is undecided.
    With `keep_going` also {"errors", "not_judged"}: a file with errors is judged as far as it can
    be.

    Raises BadInputError for a file that cannot be used.
    """
    asked = jobs(files, seconds)
    if keep_going:
        further = {"keep_going": True}
        asked = {
            file: replace(job, arguments={**job.arguments, **further})
            for file, job in asked.items()
        }
    found = dict(zip(asked, shop.results("judged", list(asked.values())), strict=True))
    return [found[file] for file in files]


def judge_claim(file: Path, name: str, shop: Workshop, seconds: float = DEFAULT) -> dict[str, Any]:
    """What `judge` says of one claim: taken from that of the file where
    it is known, else made for this claim alone.

    Raises BadInputError for a file that cannot be used, or that does not have the claim.
    """
    (job,) = jobs([file], seconds).values()
    known = shop.answered(job)
    if known is None:
        alone = replace(job, arguments={**job.arguments, "only": name})
        (known,) = shop.results("judged", [alone])
    claims = {claim["id"]: claim for claim in known["claims"]}
    if name not in claims:
        raise unknown_name(f"claim of {known['source']['key']}", name, claims)
    found: dict[str, Any] = claims[name]
    return found


def jobs(files: Sequence[Path], seconds: float = DEFAULT) -> dict[Path, workers.Job]:
    """The judgements of files, the longest first, so that the last to end is a short one.

    Raises BadInputError for a file that cannot be read.
    """
    texts = {file: read(file) for file in files}
    models = _models()
    shared = {"models": models, "seconds": seconds}
    # one file has all processors for its claims; many files share them
    also = {"processes": max(1, workers.processors() // max(1, len(files)))}
    return {
        file: workers.Job(
            file.stem, "judge", {"path": places.shown(file), "text": texts[file], **shared}, also
        )
        for file in sorted(files, key=lambda file: len(texts[file]), reverse=True)
    }


def _models() -> list[dict[str, Any]]:
    """The models of the subjects; one on which several rest is there once, or it would be judged
    as often and be taken for a choice.
    """
    found: list[dict[str, Any]] = []
    for entry in derivations.outlines():
        if entry["model"] and entry["model"] not in found:
            found.append(entry["model"])
    return found


def proofs_job(judgement: dict[str, Any]) -> workers.Job | None:
    """The check of the proofs on matrices in it, by the checker alone; None without any."""
    asked = claim_proofs.to_recheck(judgement)
    if asked is None:
        return None
    return workers.Job(asked["source"]["key"], "recheck_proofs", {"judgement": asked})


def recheck_proofs(judged: Sequence[dict[str, Any]], shop: Workshop) -> list[dict[str, Any]]:
    """Reports on the proofs on matrices of every size in judged claim files that have some."""
    found = [job for job in map(proofs_job, judged) if job is not None]
    return shop.results("proofs checked", found)


def read(file: Path) -> str:
    """The text of a claim file, within the judge's limit of size. Raises BadInputError."""
    from gainproof.verify.judge.claim.file import MOST_BYTES

    return given_file.text(file, MOST_BYTES)


def find(name: str) -> Path:
    """A claim file by its path, or one of gainproof's own by its key; keys have no dot in them."""
    own = {path.stem: path for path in places.claim_files()}
    if name in own:
        return own[name]
    if name.endswith(".tex"):
        raise BadInputError(
            f"{name} is LaTeX; a claim file is drafted from it by: "
            f"gainproof check --draft {name} --out {Path(name).stem}.toml"
        )
    if os.path.exists(name) or "." in name or Path(name).name != name:
        return Path(name)
    raise unknown_name("claim file", name, own)
