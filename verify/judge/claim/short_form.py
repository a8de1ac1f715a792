"""What a claim file may leave out, and what a formula by itself says of how it is claimed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.claim.usual_letters import Meaning
from gainproof.verify.judge.formula import Formula

INEQUALITIES = frozenset({"<", "<=", ">", ">=", "!="})
REAL = "real number"
"""The meaning of a letter of which nothing is known."""
MARK = re.compile(r"\^(?:\{[-+]\}|[-+](?=\s*(?:[-+=/)},<>\\]|$)))")
"""A minus or plus above a name, for what is predicted or updated."""


def expanded(parsed: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """What TOML made of a claim file, with what a source has that only says its title; `name` is
    that of the file, from which the key comes.
    """
    source = parsed.get("source")
    if not isinstance(source, Mapping):
        return parsed
    return {**parsed, "source": {**_source(name), **source}}


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
