"""Judgements of claim files, from worker processes. What is kept of them is what the judge says of
each claim (`judging`): files are put together anew.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.claims import claim_proofs
from gainproof.claims.time_limit import DEFAULT
from gainproof.files import input_file, places
from gainproof.jobs import workers
from gainproof.jobs.cache import Cache
from gainproof.jobs.session import Session
from gainproof.subjects import derivations


def judge(
    files: Sequence[Path], session: Session, seconds: float = DEFAULT, *, keep_going: bool = False
) -> list[dict[str, Any]]:
    """{"source", "claims"} of every file; a claim that takes more processor time than `seconds` is
    undecided.
    With `keep_going` also {"errors", "not_judged"}: a file with errors is judged as far as it can
    be.

    Raises BadInputError for a file that cannot be used.
    """
    asked = jobs(files, session.cache, seconds)
    if keep_going:
        further = {"keep_going": True}
        asked = {
            file: replace(job, arguments={**job.arguments, **further})
            for file, job in asked.items()
        }
    found = dict(zip(asked, session.results("judged", list(asked.values())), strict=True))
    taken, done = _counted(found.values())
    session.progress.say(f"trials of claims and repairs: {taken} known, {done} done now")
    return [_without_tasks(found[file]) for file in files]


def trials(files: Sequence[Path], session: Session) -> tuple[int, int]:
    """How many tasks of the judge were known when these files were judged, and how many done."""
    return _counted(session.answered(job) or {} for job in jobs(files, session.cache).values())


def _counted(judged: Iterable[Mapping[str, Any]]) -> tuple[int, int]:
    counts = [each["tasks"] for each in judged if "tasks" in each]
    return sum(count["taken"] for count in counts), sum(count["judged"] for count in counts)


def judge_claim(
    file: Path, name: str, session: Session, seconds: float = DEFAULT
) -> dict[str, Any]:
    """What `judge` says of one claim, of which no more is judged than that takes.

    Raises BadInputError for a file that cannot be used, or that does not have the claim.
    """
    (job,) = jobs([file], session.cache, seconds).values()
    alone = replace(job, arguments={**job.arguments, "only": name})
    (judged,) = session.results("judged", [alone])
    (found,) = judged["claims"]
    return dict(found)


def _without_tasks(judged: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in judged.items() if name != "tasks"}


def jobs(files: Sequence[Path], cache: Cache, seconds: float = DEFAULT) -> dict[Path, workers.Job]:
    """The judgements of files, the longest first, so that the last to end is a short one; claims
    are kept in the cache.

    Raises BadInputError for a file that cannot be read.
    """
    texts = {file: read(file) for file in files}
    models = shipped_models()
    shared = {"models": models, "seconds": seconds}
    # one file has all processors for its claims; many files share them
    also = {
        "processes": max(1, workers.processors() // max(1, len(files))),
        "cache": str(cache.folder.absolute()),
        "fresh": cache.fresh,
    }
    return {
        file: workers.Job(
            file.stem,
            "judge",
            {"path": places.shown(file), "text": texts[file], **shared},
            also,
            kept=False,
        )
        for file in sorted(files, key=lambda file: len(texts[file]), reverse=True)
    }


def shipped_models() -> list[dict[str, Any]]:
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


def recheck_proofs(judged: Sequence[dict[str, Any]], session: Session) -> list[dict[str, Any]]:
    """Reports on the proofs on matrices of every size in judged claim files that have some."""
    found = [job for job in map(proofs_job, judged) if job is not None]
    return session.results("proofs checked", found)


def read(file: Path) -> str:
    """The text of a claim file, within the judge's limit of size. Raises BadInputError."""
    from gainproof.verify.judge.claim.file import MOST_BYTES

    return input_file.text(file, MOST_BYTES)


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
