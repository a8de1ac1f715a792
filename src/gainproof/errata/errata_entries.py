"""What goes into an errata sheet: claims that cannot stand, apart by what is printed and what is
only read out of words or reconstructed, as blocks that are set in Markdown or LaTeX.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.claims.source_words import Said
from gainproof.formulas.sentence_formulas import is_formula
from gainproof.interface_words import in_language
from gainproof.verdicts.verdict_reason import (
    reason,
    repairs_of,
    solutions,
    verdict_of_repair,
    where_true,
)
from gainproof.verdicts.verdict_snapshot import Judgement

CANNOT_STAND = frozenset({"refuted", "conditional", "undefined"})
HEADINGS: Mapping[str, str] = {
    "printed": "As printed",
    "words": "In words, read as formulas by us",
    "reconstructed": "Reconstructed by us",
}
"""A part of the sheet for each origin of claims; what is `ours` is no erratum of the source."""
OURS = "ours"
_ENGLISH = in_language("en")
FAIR = (
    "Only what stands under “As printed” is printed in the source. Its words are paraphrased. "
    "The formulas as which words are read, what is reconstructed, and the notes are ours."
)
Claim = Mapping[str, Any]


@dataclass(frozen=True)
class Block:
    """Something that is set by itself. `how`: a `source`, `part` or `entry` with its title; the
    `line` of authors and year; a `quote`, as it stands; a `formula` in LaTeX; else a `text`, in
    which formulas may stand, of `symbols` that are known. Before a text come its label, by its key
    in `book.words`, the place of which it speaks, and a verdict with where and how that holds.
    """

    how: str
    text: str = ""
    label: str = ""
    place: str = ""
    verdict: str = ""
    more: str = ""
    symbols: frozenset[str] = frozenset()

    @property
    def sentence(self) -> str:
        """All of it in English."""
        verdict = f"{self.verdict}{self.more}"
        place = self.place and (f", {self.place}" if verdict else f" ({self.place})")
        label = f"{_ENGLISH[self.label]}{place}" if self.label else ""
        lead = f"{label} ({verdict})" if label and verdict else label + verdict
        return f"{lead}: {self.text}".rstrip() if lead else self.text


@dataclass(frozen=True)
class Member:
    """One claim of an entry with what its file says beside the formula, and the place of each
    claim of the source.
    """

    claim: Claim
    said: Said
    places: Mapping[str, str]

    @property
    def formula(self) -> str:
        """LaTeX on one line; empty for a claim without a formula."""
        return " ".join(self.claim["latex"].split())

    @property
    def read(self) -> tuple[Hashable, ...]:
        """As what it was read, under what, and the verdict: members that differ in it are shown
        each by itself.
        """
        claim = self.claim
        where = where_true(claim)
        return self.formula, self.said.reading, self.said.under, claim["verdict"], where


@dataclass(frozen=True)
class Entry:
    """Claims that are one: about one sentence, read alike, or repaired by one change."""

    members: tuple[Member, ...]

    @property
    def origin(self) -> str:
        return self.members[0].said.origin

    @property
    def readings(self) -> tuple[Member, ...]:
        """Of members that are read alike the first."""
        first = {member.read: member for member in reversed(self.members)}
        return tuple(reversed(first.values()))

    @property
    def title(self) -> str:
        """Where it stands, each place once, with the id of a claim where that says more."""
        places: dict[str, None] = {}
        for member in self.members:
            place, name = member.claim["place"], member.claim["id"]
            same = name.lower() in place.lower().replace(" ", "")
            places[place if same or name in place else f"{place}, {name}"] = None
        return "; ".join(places)


def entries(judgement: Judgement, said: Mapping[str, Said]) -> list[Entry]:
    """The claims of a source that are refuted, conditional or undefined, in their order; those
    that are ours are left out.
    """
    groups: list[tuple[set[Hashable], list[Member]]] = []
    places = {claim["id"]: claim["place"] for claim in judgement["claims"]}
    for claim in judgement["claims"]:
        member = Member(claim, said.get(claim["id"], Said()), places)
        if claim["verdict"] not in CANNOT_STAND or member.said.origin == OURS:
            continue
        keys, members = _keys(member), [member]
        for group in [group for group in groups if group[0] & keys]:
            groups.remove(group)
            keys |= group[0]
            members = [*group[1], *members]
        groups.append((keys, members))
    order = {claim["id"]: number for number, claim in enumerate(judgement["claims"])}
    found = [
        Entry(tuple(sorted(members, key=lambda member: order[member.claim["id"]])))
        for _, members in groups
    ]
    return sorted(found, key=lambda entry: order[entry.members[0].claim["id"]])


def _keys(member: Member) -> set[Hashable]:
    """What a claim shares with those of its entry."""
    claim, said = member.claim, member.said
    formula = member.formula or said.reading
    verdict = claim["verdict"], where_true(claim)
    keys: set[Hashable] = {(said.origin, formula, said.under, verdict, claim["kind"])}
    if not formula:
        keys = {claim["id"]}
    if said.text and said.origin != "printed":
        keys.add((said.origin, claim["place"], said.text))
    change = _one_change(claim)
    if change and said.origin == "printed":
        keys.add(change)
    return keys


def _one_change(claim: Claim) -> tuple[str, ...]:
    """The changes of the repair if they say of something what it becomes, wherever it stands."""
    changes = tuple(next((repair["changes"] for repair in repairs_of(claim)), ()))
    names = all(" becomes " in change and "number" not in change for change in changes)
    return changes if names else ()


def sheet_blocks(judgement: Judgement, said: Mapping[str, Said]) -> Iterator[Block]:
    """The sheet of one source."""
    source = judgement["source"]
    yield Block("source", f"Errata: {source['title']}")
    yield Block("line", source_line(source))
    found = entries(judgement, said)
    if any(entry.origin != "printed" for entry in found):
        yield Block("text", FAIR)
        if source.get("note"):
            yield Block("text", f"Note on the source: {' '.join(source['note'].split())}")
    if not found:
        yield Block("text", "No errata were found.")
    for origin, heading in HEADINGS.items():
        part = [entry for entry in found if entry.origin == origin]
        if part:
            yield Block("part", heading)
        for entry in part:
            yield Block("entry", entry.title)
            yield from entry_blocks(entry)
    beyond = sum(
        claim["verdict"] in CANNOT_STAND and said.get(claim["id"], Said()).origin == OURS
        for claim in judgement["claims"]
    )
    if beyond:
        one = beyond == 1
        which = "statement of ours that goes" if one else "statements of ours that go"
        hold = "does not hold" if one else "do not hold"
        more = f"{beyond} {which} beyond it {hold} everywhere"
        yield Block("text", f"No errata of the source: {more}.")


def entry_blocks(entry: Entry) -> Iterator[Block]:
    """One entry, or a claim by itself, below its title: what is printed or said, as what it was
    read, the verdict, why, what is true.
    """
    members = entry.members
    symbols = frozenset(symbol for member in members for symbol in member.said.known)
    printed = entry.origin == "printed"
    sentences = {} if printed else {m.said.text: m.claim["place"] for m in members}
    about = "about" if entry.origin == "reconstructed" else f"origin-{entry.origin}"
    for text, place in sentences.items():
        if text or about == "origin-ours":
            where = place if len(sentences) > 1 else ""
            yield Block("text", text, about, where, symbols=symbols)
    changes = {_one_change(member.claim) for member in members}
    if len(changes) == 1 and len({m.formula for m in members}) > 1 and (one := changes.pop()):
        yield Block("text", "; ".join(one), "one-change", symbols=symbols)
    for member in entry.readings:
        yield from _reading_blocks(member, more=len(entry.readings) > 1 and printed)
    words = [("about", m.said.text) for m in members if printed]
    notes = [*words, *(("note", m.said.note) for m in members)]
    for label, text in dict.fromkeys(notes):
        if text:
            yield Block("text", text, label, symbols=symbols)


def _reading_blocks(member: Member, *, more: bool) -> Iterator[Block]:
    claim, said, symbols = member.claim, member.said, member.said.known
    label = f"origin-{said.origin}" if said.origin in ("printed", "reconstructed") else "read-as"
    place = claim["place"] if more else ""
    if said.origin == "printed" and said.quoted:
        yield Block("text", "", label, place)
        yield Block("formula" if is_formula(said.quoted) else "quote", said.quoted)
        label, place = "read-as", ""
    where = where_true(claim)
    verdict = Block("text", "", label, place, claim["verdict"], where and f": {where}", symbols)
    if member.formula:
        yield verdict
        yield Block("formula", member.formula)
    elif claim["kind"] == "remark":
        yield replace(verdict, label="")
    else:
        yield replace(verdict, text=said.reading or "in words")
    for condition in said.under:
        yield Block("text", "", "where-condition")
        yield Block("formula", condition)
    if said.symbols and said.origin != "printed":
        meanings = "; ".join(f"{symbol}: {meaning}" for symbol, meaning in said.symbols)
        yield Block("text", meanings, "symbols", symbols=symbols)
    sentences = [
        ("reading", claim["reading"]),
        ("why", reason(claim)),
        *(("undefined", text) for text in solutions(claim, member.places)),
        ("convention", claim["convention"]),
        ("what-is-true", claim.get("truth")),
    ]
    for key, text in sentences:
        if text:
            yield Block("text", text, key, symbols=symbols)
    for repair in repairs_of(claim):
        lead = "read-instead" if said.origin == "printed" else "what-is-true"
        under = verdict_of_repair(repair).removeprefix(repair["verdict"])
        how = "; ".join([under, *repair["changes"]])
        yield Block("text", "", lead, "", repair["verdict"], how, symbols)
        yield Block("formula", " ".join(repair["latex"].split()))


def source_line(source: Mapping[str, Any]) -> str:
    """Authors, publication and year."""
    year = f", {source['year']}" if source["year"] else ""
    return f"{', '.join(source['authors'])}. {source['publication']}{year}."


def blocks(judgements: Sequence[Judgement], said: Sequence[Mapping[str, Said]]) -> Iterator[Block]:
    """The sheets of all sources one after the other."""
    for judgement, claims in zip(judgements, said, strict=True):
        yield from sheet_blocks(judgement, claims)
