"""Claim files in short form, as what they stand for: a source with a title only, claims that are
formulas alone, symbols as the field uses them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gainproof.verify.judge.claim.symbols_met import Met, symbols_met
from gainproof.verify.judge.claim.usual_letters import (
    Meaning,
    about_filter,
    filter_meanings,
)
from gainproof.verify.judge.formula import Formula

USUAL = "usual"
"""What `symbols` of a setting says where they mean what the field means by them."""
FILTER, NUMBERS = "filter", "numbers"
"""Settings that are made where a file of formulas alone names none."""
MADE: Mapping[str, Mapping[str, str]] = {
    FILTER: {
        "title": "a Kalman filter in its steady state",
        "kind": "steady_state",
        "model": "search",
    },
    NUMBERS: {"title": "real numbers", "kind": "algebra"},
}
INEQUALITIES = frozenset({"<", "<=", ">", ">=", "!="})
REAL = "real number"
"""The meaning of a letter of which nothing is known."""
MARK = re.compile(r"\^(?:\{[-+]\}|[-+](?=\s*(?:[-+=/)},]|$)))")
"""A minus or plus above a name, for what is predicted or updated."""
_FORMULAS = ("latex", "plain", "domain")


def expanded(parsed: Mapping[str, Any], name: str = "claims") -> Mapping[str, Any]:
    """What TOML made of a claim file, written out where it is short; `name` is that of the file,
    from which the key of its source comes. What is of another form stays for the reader to refuse.
    """
    file = dict(parsed)
    if isinstance(file.get("source"), Mapping):
        file["source"] = {**_source(name), **file["source"]}
    file |= _formulas_alone(file)
    settings, claims = file.get("settings"), file.get("claims")
    if isinstance(settings, Mapping) and isinstance(claims, list):
        shared = file.get("symbols")
        known = set(shared) if isinstance(shared, Mapping) else set()
        file["settings"] = {
            key: _with_symbols(key, setting, claims, known) for key, setting in settings.items()
        }
    return file


def is_plain(formula: str) -> bool:
    """Whether a formula is typed as plain text: it has no commands of LaTeX and no marks of names
    such as `P^-`.
    """
    return "\\" not in formula and MARK.search(formula) is None


def kind_of(formula: Formula) -> str:
    """The kind of claim that a formula is, as far as its relations say it."""
    reading = formula.readings[0]
    operators = {relation.operator for relation in reading.relations}
    if reading.connective in ("iff", "implies"):
        return "equivalence" if reading.connective == "iff" else "implication"
    if "->" in operators or any(each.operator == "->" for each in reading.conditions):
        orders = any(
            node[:2] == ["call", "order"]
            for relation in reading.relations
            for node in relation.right["nodes"]
        )
        return "asymptotics" if orders or "sim" in operators else "limit"
    if "approx" in operators:
        return "value"
    return "inequality" if operators & INEQUALITIES else "identity"


def entry_of(meaning: Meaning) -> dict[str, Any]:
    """The declaration of a symbol with this meaning."""
    entry: dict[str, Any] = {"meaning": meaning.meaning}
    if meaning.definition:
        return entry | {"definition": meaning.definition}
    if meaning.role == "quantity":
        return entry | {"quantity": meaning.quantity}
    entry["unit"] = meaning.unit
    if meaning.domain:
        entry["domain"] = meaning.domain
    return entry | ({"integer": True} if meaning.integer else {})


def _source(name: str) -> dict[str, Any]:
    """What a source has that only says its title."""
    stem = re.sub(r"\.toml$", "", name.replace("\\", "/").rpartition("/")[2])
    key = re.sub(r"[^\w.:+-]", "-", stem, flags=re.ASCII).lstrip("_.:+-")[:80]
    return {"key": key or "source", "authors": ["unknown"], "publication": "unpublished"}


def _formulas_alone(file: Mapping[str, Any]) -> dict[str, Any]:
    """`claims` as tables where they are formulas alone, with the settings that these need."""
    claims = file.get("claims")
    if not isinstance(claims, list) or not claims or not all(isinstance(c, str) for c in claims):
        return {}
    settings = file.get("settings")
    if settings is not None and not (isinstance(settings, Mapping) and len(settings) == 1):
        return {}
    made: dict[str, Any] = {}
    tables = []
    for number, formula in enumerate(claims, 1):
        met = symbols_met(formula, plain=is_plain(formula))
        if settings is not None:
            (setting,) = settings
        else:
            setting = FILTER if about_filter(met.symbols) else NUMBERS
            made[setting] = {**MADE[setting], "symbols": USUAL}
        tables.append(
            {
                "id": str(number),
                "place": f"formula {number}",
                "kind": "identity" if met.formula is None else kind_of(met.formula),
                "setting": setting,
                "plain" if is_plain(formula) else "latex": formula,
            }
        )
    return {"claims": tables} if settings is not None else {"claims": tables, "settings": made}


def _with_symbols(name: str, setting: Any, claims: Sequence[Any], known: set[str]) -> Any:
    """A setting whose symbols are the usual ones, with a declaration of each in its claims."""
    if not isinstance(setting, Mapping) or setting.get("symbols") != USUAL:
        return setting
    tokens: dict[str, None] = {}
    for claim in claims:
        if isinstance(claim, Mapping) and claim.get("setting") == name:
            for met in _met(claim):
                tokens |= dict.fromkeys(met.symbols)
    new = [token for token in tokens if token not in known]
    meanings = filter_meanings(new) if setting.get("kind") != "algebra" else {}
    free = Meaning("free", REAL)
    return {**setting, "symbols": {token: entry_of(meanings.get(token, free)) for token in new}}


def _met(claim: Mapping[str, Any]) -> Iterator[Met]:
    """What the formulas of a claim hold."""
    given = claim.get("given")
    texts = [(field, claim[field]) for field in _FORMULAS if isinstance(claim.get(field), str)]
    texts += [("given", each) for each in given or () if isinstance(given, list)]
    for field, text in texts:
        if isinstance(text, str):
            yield symbols_met(text, plain=field == "plain")
