"""Verdicts of a claim file as plain data: what is settled, the snapshot, and what changed.

A judgement is {"source": {...}, "claims": [...]}, the data that `gainproof check --json` prints.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.files import atomic_file, places
from gainproof.verify.judge.verdict_words import SETTLED, VERDICTS

Judgement = Mapping[str, Any]
Plain = dict[str, Any]

_KEPT = ("id", "verdict", "domain", "repair", "convention", "reading", "undefined")


def unsettled(judgement: Judgement) -> list[str]:
    """Ids of the claims that are neither decided nor beyond deciding, or are so by accident."""
    by_chance = accidents(judgement)
    return [
        claim["id"]
        for claim in judgement["claims"]
        if claim["verdict"] not in SETTLED or claim["id"] in by_chance
    ]


def accidents(judgement: Judgement) -> dict[str, str]:
    """By id of the claims whose verdicts say nothing: what happened to the work."""
    found = {claim["id"]: claim.get("accident") for claim in judgement["claims"]}
    return {name: str(why) for name, why in found.items() if why}


def tally(judgements: list[Judgement]) -> dict[str, int]:
    """How many claims have each verdict, in the order of `VERDICTS`, those without any left out."""
    verdicts = [claim["verdict"] for judgement in judgements for claim in judgement["claims"]]
    return {name: verdicts.count(name) for name in VERDICTS if name in verdicts}


def snapshot(judgement: Judgement, before: Mapping[str, Any] = MappingProxyType({})) -> Plain:
    """What has to stay as it is unless somebody accepts a change: verdicts, without times. That of
    a claim that met with an accident is the one `before`, by id, if there is one.
    """
    by_chance = accidents(judgement)
    claims = [
        before[claim["id"]]
        if claim["id"] in by_chance
        else {field: claim[field] for field in _KEPT} | {"method": claim["evidence"]["method"]}
        for claim in judgement["claims"]
        if claim["id"] not in by_chance or claim["id"] in before
    ]
    return {"source": judgement["source"]["key"], "claims": claims}


def write_snapshot(judgement: Judgement, claim_file: Path) -> None:
    """Put the snapshot beside its claim file. Raises BadInputError for one that lies there and
    cannot be read.
    """
    new = snapshot(judgement, _claims(_read(claim_file), claim_file))
    text = json.dumps(new, ensure_ascii=False, indent=1) + "\n"
    atomic_file.write_text(places.snapshot_of(claim_file), text)


def changes(judgement: Judgement, claim_file: Path) -> list[str]:
    """One line for each difference from the committed snapshot; empty if all is as it was. What met
    with an accident is no difference.

    Raises BadInputError for a snapshot that cannot be read.
    """
    path = places.snapshot_of(claim_file)
    old = _read(claim_file)
    if old is None:
        return [f"{path.name}: there is no snapshot yet"]
    before = _claims(old, claim_file)
    new = snapshot(judgement, before)
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


def _read(claim_file: Path) -> Any | None:
    """The snapshot that lies there, if one does."""
    path = places.snapshot_of(claim_file)
    if not path.is_file():
        return None
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise _no_snapshot(path, error) from None


def _claims(old: Any | None, claim_file: Path) -> dict[str, Any]:
    """The entries of a snapshot by id; none without one."""
    try:
        return {} if old is None else {claim["id"]: claim for claim in old["claims"]}
    except (KeyError, TypeError) as error:
        raise _no_snapshot(places.snapshot_of(claim_file), error) from None


def _no_snapshot(path: Path, error: Exception) -> BadInputError:
    return BadInputError(f"{places.shown(path)}: not a snapshot of verdicts: {error}")


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
