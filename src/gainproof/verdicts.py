"""Verdicts of a claim file as plain data: what is settled, the snapshot, and what changed.

A judgement is {"source": {...}, "claims": [...]}, the data that `gainproof check --json` prints.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gainproof import atomic_file, places
from gainproof.bad_input import BadInputError

Judgement = Mapping[str, Any]

UNSETTLED = frozenset({"held", "undecided"})
ORDER = (
    "proved",
    "refuted",
    "conditional",
    "undefined",
    "held",
    "undecided",
    "definition",
    "remark",
)
_KEPT = ("id", "verdict", "domain", "repair", "convention", "reading", "undefined")


def unsettled(judgement: Judgement) -> list[str]:
    """Ids of the claims that are neither decided nor beyond deciding."""
    return [claim["id"] for claim in judgement["claims"] if claim["verdict"] in UNSETTLED]


def tally(judgements: list[Judgement]) -> dict[str, int]:
    """How many claims have each verdict, in the order of `ORDER`, those without any left out."""
    verdicts = [claim["verdict"] for judgement in judgements for claim in judgement["claims"]]
    names = [*ORDER, *sorted(set(verdicts) - set(ORDER))]
    return {name: verdicts.count(name) for name in names if name in verdicts}


def snapshot(judgement: Judgement) -> dict[str, Any]:
    """What has to stay as it is unless somebody accepts a change: verdicts, without times."""
    claims = [
        {field: claim[field] for field in _KEPT} | {"method": claim["evidence"]["method"]}
        for claim in judgement["claims"]
    ]
    return {"source": judgement["source"]["key"], "claims": claims}


def write_snapshot(judgement: Judgement, claim_file: Path) -> None:
    """Put the snapshot beside its claim file."""
    text = json.dumps(snapshot(judgement), ensure_ascii=False, indent=1) + "\n"
    atomic_file.write_text(places.snapshot_of(claim_file), text)


def changes(judgement: Judgement, claim_file: Path) -> list[str]:
    """One line for each difference from the committed snapshot; empty if all is as it was.

    Raises BadInputError for a snapshot that cannot be read.
    """
    path = places.snapshot_of(claim_file)
    if not path.is_file():
        return [f"{path.name}: there is no snapshot yet"]
    try:
        old = json.loads(path.read_text(encoding="utf-8"))
        before = {claim["id"]: claim for claim in old["claims"]}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BadInputError(f"{places.shown(path)}: not a snapshot of verdicts: {error}") from None
    new = snapshot(judgement)
    after = {claim["id"]: claim for claim in new["claims"]}
    found = [f"{name}: no longer among the claims" for name in before if name not in after]
    for name, claim in after.items():
        if name not in before:
            found.append(f"{name}: new, {claim['verdict']}")
        elif before[name] != claim:
            found.append(f"{name}: {_difference(before[name], claim)}")
    if not found and old != new:
        found.append(f"{path.name}: the order of the claims or the source changed")
    return found


def _difference(before: Mapping[str, Any], after: Mapping[str, Any]) -> str:
    parts = [
        f"{field} was {_short(before.get(field))}, is {_short(after.get(field))}"
        for field in sorted({*before, *after})
        if before.get(field) != after.get(field)
    ]
    return "; ".join(parts)


def _short(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 80 else text[:77] + "..."
