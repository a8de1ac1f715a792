"""What goes into an errata sheet: claims that cannot stand as printed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.claim_words import Words
from gainproof.verdict_reason import reason, repairs_of, solutions, verdict_of_repair
from gainproof.verdicts import Judgement

CANNOT_STAND = frozenset({"refuted", "conditional", "undefined"})


@dataclass(frozen=True)
class Entry:
    """One claim: `title` is its place, with the id where that says more; `printed` is LaTeX, or
    empty for a claim in `words`; `remarks` are labelled sentences; `repairs` are LaTeX, each with
    its verdict and the convention that it needs; none where none was found.
    """

    title: str
    verdict: str
    printed: str
    words: str
    remarks: tuple[tuple[str, str], ...]
    repairs: tuple[tuple[str, str], ...] = ()


def entries(judgement: Judgement, words: Words) -> list[Entry]:
    """The claims that are refuted, conditional or undefined, in the order of the source."""
    found = []
    for claim in judgement["claims"]:
        if claim["verdict"] not in CANNOT_STAND:
            continue
        remarks = []
        if claim["verdict"] == "conditional" and claim["domain"]:
            remarks.append(("True", claim["domain"]))
        why = reason(claim)
        if why:
            remarks.append(("Why", why))
        remarks += [("Fixed by the other claims", text) for text in solutions(claim)]
        if claim["convention"]:
            remarks.append(("Convention", claim["convention"]))
        remarks += [("What is true", claim["truth"])] if claim.get("truth") else []
        named = claim["id"] in claim["place"]
        title = claim["place"] if named else f"{claim['place']}, {claim['id']}"
        found.append(
            Entry(
                title,
                claim["verdict"],
                claim["latex"],
                words.get(claim["id"], "in words"),
                tuple(remarks),
                tuple((repair["latex"], verdict_of_repair(repair)) for repair in repairs_of(claim)),
            )
        )
    return found


@dataclass(frozen=True)
class Part:
    """One source and its entries."""

    source: Mapping[str, Any]
    entries: tuple[Entry, ...]


def source_line(source: Mapping[str, Any]) -> str:
    """Authors, publication and year."""
    year = f", {source['year']}" if source["year"] else ""
    return f"{', '.join(source['authors'])}. {source['publication']}{year}."
