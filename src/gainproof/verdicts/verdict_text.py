"""Verdicts for people: a table with a line or a few for each claim."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import groupby
from types import MappingProxyType
from typing import Any

from gainproof.claims.source_words import Words
from gainproof.terminal_text import WIDTH, filled
from gainproof.verdicts.verdict_reason import is_contradicted, reasons
from gainproof.verdicts.verdict_snapshot import Judgement, tally

Claim = Mapping[str, Any]
_WIDEST_ID = 26
BARE = re.compile(r"\\log(?![a-zA-Z]|\s*_)")
"""A logarithm that is printed without its base."""
BY_ACCIDENT = "this is an accident, and not kept: check it again"
NATURAL = (
    "\\log without a base is read as the natural logarithm: say `logarithm = 10` in [source] if "
    "another is meant."
)


def overview(
    judgement: Judgement, columns: int = WIDTH, words: Words = MappingProxyType({})
) -> str:
    """The source and, by the places where they stand, all claims with verdict, formula and why;
    `words` are those of claims without a formula, by id.
    """
    source, claims = judgement["source"], judgement["claims"]
    lines = [*filled(f"{source['key']}: {source['title']}", "", "  ", columns), ""]
    names = min(_WIDEST_ID, max((len(claim["id"]) for claim in claims), default=0))
    verdicts = max((len(claim["verdict"]) for claim in claims), default=0)
    for place, group in groupby(claims, lambda claim: claim["place"]):
        lines += filled(place, "  ", "    ", columns)
        for claim in group:
            head = f"    {claim['id']:<{names}}  {claim['verdict']:<{verdicts}}  "
            said = claim["latex"] or words.get(claim["id"], "")
            lines += _claim(claim, said, head, " " * (names + verdicts + 8), columns)
    lines += _conventions(claims, columns)
    if source.get("logarithm") is None and any(BARE.search(claim["latex"]) for claim in claims):
        lines += ["", *filled(NATURAL, "  ", "    ", columns)]
    lines += ["", f"  {counts([judgement])}"]
    if judgement.get("not_judged"):
        names_left = ", ".join(judgement["not_judged"])
        lines += filled(f"not judged, for errors: {names_left}", "  ", "    ", columns)
    return "\n".join(lines) + "\n"


def counts(judgements: list[Judgement]) -> str:
    """`53 claims: 40 proved, 2 refuted`."""
    found = tally(judgements)
    shown = ", ".join(f"{number} {verdict}" for verdict, number in found.items())
    total = sum(found.values())
    return f"{total} claim{'s' if total > 1 else ''}: {shown}" if total else "no claims"


def _claim(claim: Claim, said: str, head: str, indent: str, columns: int) -> list[str]:
    """Formula or words beside the verdict, reasons below."""
    texts = [*([" ".join(said.split())] if said else []), *reasons(claim)]
    if claim.get("accident"):
        why = "" if claim["accident"] == claim["reason"] else f"{claim['accident']}; "
        texts.append(f"{why}{BY_ACCIDENT}")
    if not texts:
        return [head.rstrip()]
    lines = filled(texts[0], head, indent, columns)
    for text in texts[1:]:
        lines += filled(text, indent, indent, columns)
    return lines


def _conventions(claims: Sequence[Claim], columns: int) -> list[str]:
    """What the source leaves open, as it was filled in, once for all claims alike; and what it says
    otherwise than its claims have it.
    """
    lines: list[str] = []
    for contradicted, head in (
        (False, "Left open by the source, filled in so that its claims hold:"),
        (True, "Otherwise than the source states it, all claims of its setting would hold with:"),
    ):
        found: dict[str, list[str]] = {}
        for claim in claims:
            if claim["convention"] and is_contradicted(claim) == contradicted:
                found.setdefault(claim["convention"], []).append(claim["id"])
        lines += ["", f"  {head}"] if found else []
        for convention, names in found.items():
            lines += filled(f"{convention}: {', '.join(names)}", "    ", "      ", columns)
    return lines
