"""A claim file judged, as plain data. Of the derivations the judge gets models, nothing else."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from typing import Any

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.worker import Workers


def judge_text(
    path: str,
    text: str,
    models: Sequence[Mapping[str, Any]],
    judges: Workers,
    tell: Callable[[str], None],
    only: str | None = None,
) -> dict[str, Any]:
    """{"source": {...}, "claims": [...]} of a claim file of this text; `path` is for messages.
    `judges` judge claim by claim; `tell` hears how far that is. With `only` there is the claim of
    this id alone.

    Raises BadInputError, with line and column where known, for a file that is not accepted, or
    without the claim.
    """
    try:
        claim_file = read_claim_text(text, path, [str(model["name"]) for model in models])
    except ClaimFileError as error:
        raise BadInputError(str(error)) from None
    names = [claim.id for claim in claim_file.claims]
    if only is not None and only not in names:
        raise unknown_name(f"claim of {claim_file.source.key}", only, names)
    verdicts = judge_file(
        claim_file,
        models,
        progress=lambda tried, total: tell(_so_far(tried, total)),
        workers=judges,
        only=only,
    )
    return {
        "source": asdict(claim_file.source),
        "claims": [verdict.to_json() for verdict in verdicts],
    }


def _so_far(tried: int, total: int) -> str:
    """How far it is, in words."""
    return f"{tried} of {total} claims" if tried <= total else "nearest true formulas"
