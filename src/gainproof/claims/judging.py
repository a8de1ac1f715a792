"""A claim file judged, as plain data. Of the derivations the judge gets models, nothing else."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError, listed, unknown_name
from gainproof.jobs import code_digest
from gainproof.jobs.cache import Cache, key_of
from gainproof.jobs.worker_state import WorkerState
from gainproof.verify.judge import worker_process
from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.worker import Judges, Workers

PACKAGES = ("python", "python-flint", "lark", "mpmath")
"""What the judge is made with."""


@dataclass(frozen=True)
class KeptTrials:
    """What the judge's tasks came to, one by one in the cache, by the code that they run: that of
    their own module and of the child process, with all that these import.
    """

    cache: Cache
    code: Callable[..., str] = code_digest.of_modules
    _digests: dict[str, str] = field(default_factory=dict)

    def load(self, module: str, key: str) -> str | None:
        """The text kept for a task of this module, None if there is none."""
        found = self.cache.load(self._key(module, key))
        return found if isinstance(found, str) else None

    def store(self, module: str, key: str, text: str) -> None:
        """Keep a text, unless the code was edited since its digest was taken."""
        if code_digest.is_as_read(module, worker_process.__name__):
            self.cache.store(self._key(module, key), text)

    def _key(self, module: str, key: str) -> str:
        if module not in self._digests:
            self._digests[module] = self.code(module, worker_process.__name__)
        versions = [f"{name} {code_digest.versions()[name]}" for name in PACKAGES]
        return key_of("trial", module, key, self._digests[module], *versions)


def judge(
    state: WorkerState,
    path: str,
    text: str,
    models: Sequence[Mapping[str, Any]],
    seconds: float,
    processes: int,
    only: str | None = None,
    keep_going: bool = False,
    cache: str | None = None,
    fresh: bool = False,
) -> dict[str, Any]:
    """What `judge_text` says of a claim file, each claim within so many seconds of processor time,
    so many of them at once. What is judged is kept in the folder `cache`, claim by claim, and taken
    from there unless `fresh`.
    """
    # children that judge stay for the next file: what they keep they keep by its whole content
    key = ("workers", json.dumps(models, sort_keys=True), seconds, processes, cache, fresh)
    known = None if cache is None else KeptTrials(Cache(Path(cache), fresh))
    judges = state.opened(key, lambda: Workers(models, seconds, processes, known))
    return judge_text(path, text, models, judges, state.report, only, keep_going=keep_going)


def judge_text(
    path: str,
    text: str,
    models: Sequence[Mapping[str, Any]],
    judges: Judges,
    tell: Callable[[str], None],
    only: str | None = None,
    *,
    keep_going: bool = False,
) -> dict[str, Any]:
    """{"source": {...}, "claims": [...], "tasks": {...}} of a claim file of this text; `path` is
    for messages. `judges` judge claim by claim; `tell` hears how far that is; "tasks" says how many
    of the judge's tasks were "taken" from what was known and how many "judged". With `only` there
    is the claim of this id alone. With `keep_going` a file with errors is judged as far as it can
    be: "errors" and the ids of claims that are `not_judged` come along.

    Raises BadInputError, with line and column of each error where known, for a file that is not
    accepted, or without the claim.
    """
    known_models = tuple(str(model["name"]) for model in models)
    try:
        claim_file = read_claim_text(text, path, known_models, keep_going=keep_going)
    except ClaimFileError as error:
        every = [one.to_json() for one in (error, *error.others)]
        raise BadInputError(listed(every), every) from None
    names = [claim.id for claim in claim_file.claims]
    if only is not None and only not in names:
        raise unknown_name(f"claim of {claim_file.source.key}", only, names)
    taken, done = judges.taken, judges.judged
    verdicts = judge_file(
        claim_file,
        models,
        progress=lambda tried, total: tell(_so_far(tried, total)),
        workers=judges,
        only=only,
    )
    judged = {
        "source": asdict(claim_file.source),
        "claims": [verdict.to_json() for verdict in verdicts],
        "tasks": {"taken": judges.taken - taken, "judged": judges.judged - done},
    }
    if not keep_going:
        return judged
    errors = [error.to_json() for error in claim_file.errors]
    return judged | {"errors": errors, "not_judged": list(claim_file.unread)}


def _so_far(tried: int, total: int) -> str:
    """How far it is, in words."""
    return f"{tried} of {total} claims" if tried <= total else "nearest true formulas"
