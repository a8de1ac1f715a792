"""What goes into an errata sheet: claims that cannot stand, apart by what is printed and what is
only read out of words or reconstructed, as blocks that are set in Markdown or LaTeX.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.claim_words import Said
from gainproof.verdict_reason import reason, repairs_of, solutions, verdict_of_repair, where_true
from gainproof.verdicts import Judgement

CANNOT_STAND = frozenset({"refuted", "conditional", "undefined"})
HEADINGS: Mapping[str, str] = {
    "printed": "As printed",
    "words": "In words, read as formulas by us",
    "reconstructed": "Reconstructed by us",
}
"""A part of the sheet for each origin of claims; what is `ours` is no erratum of the source."""
OURS = "ours"
FAIR = (
    "Only what stands under “As printed” is printed in the source. Its words are paraphrased. "
    "The formulas as which words are read, what is reconstructed, and the notes are ours."
)
Claim = Mapping[str, Any]
Block = tuple[str, str]
"""How something is set (`source`, `part`, `entry`, `text`, `quote`, `formula`), and what it is:
LaTeX for a formula, plain text for the others.
"""


@dataclass(frozen=True)
class Member:
    """One claim of an entry with what its file says beside the formula."""

    claim: Claim
    said: Said

    @property
    def formula(self) -> str:
        """LaTeX on one line; empty for a claim without a formula."""
        return " ".join(self.claim["latex"].split())

    @property
    def read(self) -> tuple[Hashable, ...]:
        """As what it was read, under what, and the verdict: members that differ in it are shown
        each by itself.
        """
        return self.formula, self.said.reading, self.said.under, _verdict(self.claim)


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
    for claim in judgement["claims"]:
        member = Member(claim, said.get(claim["id"], Said()))
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
    keys: set[Hashable] = {(said.origin, formula, said.under, _verdict(claim), claim["kind"])}
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
    yield "source", f"Errata: {source['title']}"
    yield "text", source_line(source)
    found = entries(judgement, said)
    if any(entry.origin != "printed" for entry in found):
        yield "text", FAIR
        if source.get("note"):
            yield "text", f"Note on the source: {' '.join(source['note'].split())}"
    if not found:
        yield "text", "No errata were found."
    for origin, heading in HEADINGS.items():
        part = [entry for entry in found if entry.origin == origin]
        if part:
            yield "part", heading
        for entry in part:
            yield from entry_blocks(entry)
    beyond = sum(
        claim["verdict"] in CANNOT_STAND and said.get(claim["id"], Said()).origin == OURS
        for claim in judgement["claims"]
    )
    if beyond:
        one = beyond == 1
        which = "statement of ours that goes" if one else "statements of ours that go"
        hold = "does not hold" if one else "do not hold"
        yield "text", f"No errata of the source: {beyond} {which} beyond it {hold} everywhere."


def entry_blocks(entry: Entry) -> Iterator[Block]:
    """One entry: what is printed or said, as what it was read, the verdict, why, what is true."""
    yield "entry", entry.title
    printed = entry.origin == "printed"
    sentences = {} if printed else {m.said.text: m.claim["place"] for m in entry.members}
    for text, place in sentences.items():
        where = f" ({place})" if len(sentences) > 1 else ""
        if text:
            yield "text", f"{'In words' if entry.origin == 'words' else 'About'}{where}: {text}"
    changes = {_one_change(member.claim) for member in entry.members}
    if len(changes) == 1 and len({m.formula for m in entry.members}) > 1 and (one := changes.pop()):
        yield "text", f"One change repairs all of these: {'; '.join(one)}"
    for member in entry.readings:
        yield from _reading_blocks(member, more=len(entry.readings) > 1 and printed)
    for note in _notes(entry):
        yield "text", f"Note: {note}"


def _notes(entry: Entry) -> list[str]:
    """Notes of its claims, each once; beside a printed formula the words are such."""
    words = [m.said.text for m in entry.members if entry.origin == "printed"]
    return list(dict.fromkeys(filter(None, [*words, *(m.said.note for m in entry.members)])))


def _reading_blocks(member: Member, *, more: bool) -> Iterator[Block]:
    claim, said = member.claim, member.said
    label = {"printed": "As printed", "words": "Read as"}.get(said.origin, "Reconstructed")
    where = f", {claim['place']}" if more else ""
    if said.origin == "printed" and said.quoted:
        yield "text", f"As printed{where}:"
        yield "quote", said.quoted
        label, where = "Read as", ""
    yield "text", f"{label}{where} ({_verdict(claim)}):"
    if member.formula:
        yield "formula", member.formula
    else:
        yield "text", said.reading or "in words"
    for condition in said.under:
        yield "text", "Where:"
        yield "formula", condition
    if said.symbols and said.origin != "printed":
        meanings = "; ".join(f"{symbol}: {meaning}" for symbol, meaning in said.symbols)
        yield "text", f"Symbols: {meanings}"
    why = reason(claim)
    if why:
        yield "text", f"Why: {why}"
    for text in solutions(claim):
        yield "text", f"Fixed by the other claims: {text}"
    if claim["convention"]:
        yield "text", f"Convention: {claim['convention']}"
    if claim.get("truth"):
        yield "text", f"What is true: {claim['truth']}"
    for repair in repairs_of(claim):
        lead = "Read instead" if said.origin == "printed" else "What is true"
        yield "text", f"{lead} ({verdict_of_repair(repair)}):"
        yield "formula", " ".join(repair["latex"].split())


def _verdict(claim: Claim) -> str:
    """The verdict, and on what part a conditional claim is true."""
    where = where_true(claim)
    return f"{claim['verdict']}: {where}" if where else str(claim["verdict"])


def source_line(source: Mapping[str, Any]) -> str:
    """Authors, publication and year."""
    year = f", {source['year']}" if source["year"] else ""
    return f"{', '.join(source['authors'])}. {source['publication']}{year}."


def blocks(judgements: Sequence[Judgement], said: Sequence[Mapping[str, Said]]) -> Iterator[Block]:
    """The sheets of all sources one after the other."""
    for judgement, claims in zip(judgements, said, strict=True):
        yield from sheet_blocks(judgement, claims)
