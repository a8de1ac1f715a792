"""Verdicts for people: a line or a few for each claim."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from typing import Any

from gainproof.verdicts import Judgement, tally

WIDTH = 92

Claim = Mapping[str, Any]


def overview(judgement: Judgement) -> str:
    """The source and every claim with its verdict."""
    source = judgement["source"]
    lines = [f"{source['key']}: {source['title']}", ""]
    width = max((len(claim["id"]) for claim in judgement["claims"]), default=0)
    for claim in judgement["claims"]:
        lines.append(f"  {claim['id']:<{width}}  {claim['verdict']}")
        for text in remarks(claim):
            lines += filled(text, " " * (width + 4))
    lines += ["", f"  {counts([judgement])}"]
    return "\n".join(lines) + "\n"


def counts(judgements: list[Judgement]) -> str:
    """`53 claims: 40 proved, 2 refuted`."""
    found = tally(judgements)
    shown = ", ".join(f"{number} {verdict}" for verdict, number in found.items())
    total = sum(found.values())
    return f"{total} claims: {shown}" if total else "no claims"


def remarks(claim: Claim) -> list[str]:
    """What a reader has to know besides the verdict; nothing for a claim that is simply proved."""
    found = []
    if claim["domain"] and claim["verdict"] == "conditional":
        found.append(f"holds {claim['domain']}")
    found += [f"{name}: {claim[name]}" for name in ("convention", "reading") if claim[name]]
    if claim["repair"]:
        repair = claim["repair"]
        found.append(f"nearest true formula: {repair['latex']} ({repair['verdict']})")
    found += [
        f"{entry['symbol']} = {entry['solution']}, fixed by {_ids(entry['consumed'])}"
        for entry in claim["undefined"]
        if entry["solution"] is not None
    ]
    if claim["verdict"] not in {"proved", "definition"} and claim["reason"]:
        found.append(claim["reason"])
    return found


def filled(text: str, indent: str) -> list[str]:
    """Text filled to the width of the page, long words kept whole."""
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _ids(value: Any) -> str:
    return ", ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
