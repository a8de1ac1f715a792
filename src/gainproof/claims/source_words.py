"""What a claim file says beside its formulas: words, excerpts, notes, and whether a formula is
printed in the source at all. Verdicts hold formulas only.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.claim.usual_meanings import table_of, usual_origin, whole_claims
from gainproof.verify.judge.reader.plain_names import plain_name

Words = Mapping[str, str]


@dataclass(frozen=True)
class Said:
    """One claim as its file has it. `origin` is one of `ORIGINS`; `text` are the words of the
    source, or about the formula; `reading` says the fields of a claim without a formula in words;
    `under` are the domain and the hypotheses that its formula does not print; `quoted` is the
    excerpt as seen; `symbols` are those that it has with their meanings, `known` all of its setting
    as they are written. Empty where nothing is said.
    """

    origin: str = "printed"
    text: str = ""
    reading: str = ""
    under: tuple[str, ...] = ()
    note: str = ""
    quoted: str = ""
    symbols: tuple[tuple[str, str], ...] = ()
    known: frozenset[str] = frozenset()


def claims_said(text: str) -> dict[str, Said]:
    """What is said of every claim, by id. `text` is that of a claim file that was accepted."""
    file = tomllib.loads(text)
    shared = file.get("symbols", {})
    tables = {
        name: {**table_of(setting, shared), **table_of(setting, setting.get("symbols", {}))}
        for name, setting in file["settings"].items()
    }
    return {claim["id"]: _said(claim, tables[claim["setting"]]) for claim in _claims(file)}


def _claims(file: Mapping[str, Any]) -> list[Any]:
    kinds = {name: str(setting.get("kind")) for name, setting in file["settings"].items()}
    return whole_claims(file["claims"], kinds)


def claim_words(text: str, only: Collection[str] | None = None) -> dict[str, str]:
    """The words of every claim that has no formula, by id: its paraphrase, or what its fields say.
    `text` is that of a claim file that was accepted; with `only`, for the claims of these ids.
    """
    claims = _claims(tomllib.loads(text))
    if only is not None:
        claims = [one for one in claims if isinstance(one, Mapping) and one.get("id") in only]
    return {
        claim["id"]: " ".join(str(claim.get("text") or _fields(claim)).split())
        for claim in claims
        if "latex" not in claim and "plain" not in claim
    }


def _said(claim: Mapping[str, Any], table: Mapping[str, Any]) -> Said:
    formula = claim.get("latex", "") or claim.get("plain", "")
    reading = "" if formula else _fields(claim)
    under = (*([claim["domain"]] if "domain" in claim else []), *claim.get("given", []))
    whole = " ".join((formula, reading, *under))
    met = {
        symbol: place
        for symbol in table
        if (place := _place(symbol if "plain" not in claim else plain_name(symbol), whole)) >= 0
    }
    return Said(
        origin=claim.get("origin") or usual_origin(claim),
        text=" ".join(claim.get("text", "").split()),
        reading=reading,
        under=under,
        note=" ".join(claim.get("note", "").split()),
        quoted=claim.get("quoted", "").strip("\n"),
        symbols=tuple(
            (symbol, table[symbol]["meaning"]) for symbol in sorted(met, key=lambda name: met[name])
        ),
        known=frozenset(table),
    )


def _place(symbol: str, formula: str) -> int:
    """Where a symbol stands in a formula by itself, and not as part of another; -1 if nowhere."""
    found = re.search(rf"(?<![A-Za-z\\_]){re.escape(symbol)}(?![A-Za-z'_])", formula)
    return found.start() if found else -1


def _fields(claim: Mapping[str, Any]) -> str:
    match claim["kind"]:
        case "monotone":
            return f"{claim['about'][0]} is {claim['trend']} in {claim['about'][1]}"
        case "location":
            return f"roots of {claim['polynomial']} in {claim['variable']}: {claim['where']}"
        case kind:
            return str(kind)
