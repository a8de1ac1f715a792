"""A page for each source: its claims in order with verdict, proof or witness, and its errata."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from markupsafe import Markup, escape

from gainproof.book.mathematics import displayed, inline
from gainproof.book.page import Finding, Page
from gainproof.claims.source_words import Said
from gainproof.errata.errata_entries import Block, Entry, Member, entries, entry_blocks, source_line
from gainproof.formulas.sentence_formulas import written
from gainproof.interface_words import LANGUAGES, in_language
from gainproof.verdicts.explanation import parts
from gainproof.verdicts.verdict_reason import domain
from gainproof.verdicts.verdict_snapshot import Judgement, tally

Claim = Mapping[str, Any]


@dataclass(frozen=True)
class ShownClaim:
    """A claim: what its file and the judge say of it, as on a sheet of errata, facts of the method,
    and the parts of its proof or witness, each a title with lines, true for those that are set in.
    """

    id: str
    blocks: tuple[Block, ...]
    facts: tuple[tuple[str, Markup], ...]
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
    members = [
        Member(claim, said[claim["id"]], {c["id"]: c["place"] for c in judgement["claims"]})
        for claim in judgement["claims"]
    ]
    claims = [_shown(member, checked.get(member.claim["id"], "")) for member in members]
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
                "byline": source_line(source),
                "errata": [
                    (entry.title, entry.members[0].claim["id"], _blocks(entry))
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


def _shown(member: Member, checked: str) -> ShownClaim:
    claim = member.claim
    facts = (
        ("domain", domain(claim)),
        ("method", claim["evidence"]["method"]),
    )
    known = member.said.known
    return ShownClaim(
        id=claim["id"],
        blocks=_blocks(Entry((member,))),
        facts=tuple((label, _sentence(str(value), known)) for label, value in facts if value),
        parts=tuple(
            (title, tuple((line.startswith(" "), _sentence(line.strip(), known)) for line in lines))
            for title, lines in parts(claim)
        ),
        checked=checked,
    )


def _blocks(entry: Entry) -> tuple[Block, ...]:
    """What is said of an entry, its texts and formulas set."""
    return tuple(
        block
        if block.how == "quote"
        else replace(
            block,
            text=displayed(block.text)
            if block.how == "formula"
            else _sentence(block.text, block.symbols),
            more=_sentence(block.more, block.symbols),
        )
        for block in entry_blocks(entry)
    )


def _sentence(text: str, symbols: Collection[str]) -> Markup:
    return Markup(written(text, symbols, escape, inline))
