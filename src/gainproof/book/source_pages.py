"""A page for each source: its claims in order with verdict, proof or witness, and its errata."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from markupsafe import Markup

from gainproof.book.mathematics import displayed
from gainproof.book.page import Finding, Page
from gainproof.book.quoted_symbols import with_symbols
from gainproof.book.words import LANGUAGES, in_language
from gainproof.claim_words import Said
from gainproof.errata_entries import entries
from gainproof.explanation import parts
from gainproof.verdict_reason import reason, repairs_of, solutions, truth
from gainproof.verdicts import Judgement, tally

Claim = Mapping[str, Any]


@dataclass(frozen=True)
class ShownRepair:
    """A nearest true formula, its verdict, under which convention it is true, what was changed."""

    formula: Markup
    verdict: str
    under: str
    changes: tuple[str, ...]


@dataclass(frozen=True)
class ShownClaim:
    """A claim: where it comes from, the words or the excerpt of the source, the formula or the
    words as which it is judged, and under what; why it has its verdict, notes, the nearest true
    formulas, and the parts of its proof or witness, each a title with lines, true for those that
    are set in.
    """

    id: str
    verdict: str
    origin: str
    text: Markup
    quoted: str
    formula: Markup | None
    words: str
    under: tuple[Markup, ...]
    note: Markup
    facts: tuple[tuple[str, Markup], ...]
    reason: Markup
    repairs: tuple[ShownRepair, ...]
    parts: tuple[tuple[str, tuple[tuple[bool, Markup], ...]], ...]
    checked: str


def address(key: str, language: str = "en") -> str:
    """Where the page of a source lies."""
    return f"sources/{key}.html" if language == "en" else f"sources/{key}.{language}.html"


def source_pages(
    judgement: Judgement, said: Mapping[str, Said], checked: Mapping[str, str]
) -> list[Page]:
    """The page of a judged source in each language; `said` is what its file says of each claim
    beside the formula, `checked` what came of its certificate when it was gone through again.
    """
    source = judgement["source"]
    claims = [
        _shown(claim, said[claim["id"]], checked.get(claim["id"], ""))
        for claim in judgement["claims"]
    ]
    by_id = {claim.id: claim for claim in claims}
    places = [
        (place, [by_id[claim["id"]] for claim in group])
        for place, group in groupby(judgement["claims"], lambda claim: claim["place"])
    ]
    versions = {language: address(source["key"], language) for language in LANGUAGES}
    return [
        Page(
            path=versions[language],
            title=source["title"],
            kind="source",
            template="source.html",
            data={
                "source": source,
                "places": places,
                "errata": [
                    (
                        entry.title,
                        [
                            (by_id[member.claim["id"]], member in entry.readings)
                            for member in entry.members
                        ],
                    )
                    for entry in entries(judgement, said)
                ],
                "tally": tally([judgement]),
                "total": len(claims),
                "w": in_language(language),
            },
            # found once, on the page in English
            findings=_findings(source, judgement["claims"], said) if language == "en" else (),
            language=language,
            versions=versions,
        )
        for language in LANGUAGES
    ]


def _findings(
    source: Mapping[str, Any], claims: Sequence[Claim], said: Mapping[str, Said]
) -> tuple[Finding, ...]:
    authors = " ".join(source["authors"])
    return (
        Finding(source["title"], f"{source['key']} {authors} {source['publication']}"),
        *(
            Finding(
                f"{source['key']} {claim['id']}: {claim['verdict']}",
                f"{claim['place']} {claim['latex'] or _words(said[claim['id']])}",
                f"claim-{claim['id']}",
            )
            for claim in claims
        ),
    )


def _words(said: Said) -> str:
    return said.text or said.reading


def _shown(claim: Claim, said: Said, checked: str) -> ShownClaim:
    facts = (
        ("reading", claim["reading"]),
        ("convention", claim["convention"]),
        ("domain", claim["domain"] if claim["domain"] != "nowhere" else None),
        ("method", claim["evidence"]["method"]),
        *(("undefined", text) for text in solutions(claim)),
    )
    return ShownClaim(
        id=claim["id"],
        verdict=claim["verdict"],
        origin=said.origin,
        text=with_symbols(said.text),
        quoted=said.quoted,
        formula=displayed(claim["latex"]) if claim["latex"] else None,
        words="" if claim["kind"] == "remark" else said.reading,
        under=tuple(map(displayed, said.under)),
        note=with_symbols(said.note),
        facts=tuple((label, with_symbols(str(value))) for label, value in facts if value),
        reason=with_symbols("; ".join(filter(None, (reason(claim), *truth(claim))))),
        repairs=tuple(
            ShownRepair(displayed(r["latex"]), r["verdict"], r["under"], tuple(r["changes"]))
            for r in repairs_of(claim)
        ),
        parts=tuple((title, tuple(map(_line, lines))) for title, lines in parts(claim)),
        checked=checked,
    )


def _line(line: str) -> tuple[bool, Markup]:
    return line.startswith(" "), with_symbols(line.strip())
