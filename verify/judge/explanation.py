"""A certificate as sections that a reader can follow: what was decided, and how.

Auxiliary variables of the arithmetic are shown under the names of the source; roots that have no
name there are introduced before they are used.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.certificate import statement_from
from gainproof.verify.judge.exact.expression import symbol
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.readable_expression import readable

Certificate = Mapping[str, Any]
_LIMIT, _VARIABLE = "L", "variable"
_PARTS = {"there": "First direction", "back": "Second direction"}
_TOLD = {
    "Shown about the setting before, from its matrices alone": "established",
    "Cited: used and not proved here": "cited",
}
_NEGATIVE = re.compile(r"\+ \(-(\d+)\)")
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


@dataclass(frozen=True)
class Section:
    """A title and lines below it; a line is one statement, however long."""

    title: str
    lines: tuple[str, ...]


def sections(certificate: Certificate) -> list[Section]:
    """What a certificate holds, in the order in which one reads it."""
    found: list[Section] = []
    for name, part in _proofs(certificate):
        prefix = f"{_PARTS.get(name, name)}: " if name else ""
        decided, how = _decided(part), _steps(part)
        if decided:
            found.append(Section(f"{prefix}what was decided", tuple(decided)))
        if how:
            found.append(Section(f"{prefix}how", tuple(how)))
    for title, name in _TOLD.items():
        facts = certificate.get(name, [])
        numbered = tuple(f"{n}. {fact}" for n, fact in enumerate(facts, start=1))
        if numbered:
            found.append(Section(title, numbered))
    return found


def _proofs(certificate: Certificate) -> list[tuple[str, Certificate]]:
    """One proof, or several under names."""
    if not {"statement", "leading coefficient", "places"}.isdisjoint(certificate):
        return [("", certificate)]
    return [
        (name, part)
        for name, part in certificate.items()
        if isinstance(part, Mapping) and "statement" in part
    ]


def _decided(certificate: Certificate) -> list[str]:
    """The relations in base variables."""
    # over a chart a relation fills pages with variables that no source has
    if "statement" not in certificate or certificate.get("engine") == "chart":
        return []
    statement, boxes, _, labels = statement_from(certificate["statement"])
    names = {name: symbol(labels.get(name, name)) for name in boxes}
    statement = statement.mapped(lambda e: readable(substituted(e, names)))
    relations = [*statement.relations, *statement.conditions, *statement.given]
    quantities = certificate.get("quantities", {})
    meanings = {
        readable(substituted(read_graph(graph), names)): token
        for token, graph in quantities.items()
    }
    sides = [side for r in relations for side in (r.left, r.right)]
    shared, texts = written(*sides, names=meanings)
    pairs = zip(texts[::2], texts[1::2], strict=True)
    shown = [_relation(a, r.operator, b) for r, (a, b) in zip(relations, pairs, strict=True)]
    count, end = len(statement.relations), len(shown) - len(statement.given)
    lines = list(dict.fromkeys(shown[:count]))
    if statement.conditions:
        word = "exactly where" if statement.connective == "iff" else "where"
        lines += [word, *dict.fromkeys(shown[count:end])]
    if statement.given:
        lines += ["under the condition", *dict.fromkeys(shown[end:])]
    if shared:
        lines += ["with", *[line for line in shared if line not in shown]]
    domains = [box.text(labels.get(name, name)) for name, box in boxes.items()]
    return [*lines, "for " + "; ".join(domains)] if domains else lines


def _relation(left: str, operator: str, right: str) -> str:
    """A relation in text; `a <= a` is how the judge says that a has a value."""
    if left == right and operator in ("<=", ">="):
        return f"{left} has a value"
    return f"{left} {operator} {right}"


def _steps(certificate: Certificate) -> list[str]:
    names = {"x": _VARIABLE, **certificate.get("variables", {})}
    lines: list[str] = []
    tower = certificate.get("tower") or []
    if tower:
        lines.append("with roots, each brought to the form root^n = polynomial:")
        lines += [f"  {_named(relation, names)}" for relation in tower]
    if "leading coefficient" in certificate:
        edge = _named(certificate["leading coefficient"], {"x": _LIMIT})
        fences = ", ".join(certificate["separating rationals"])
        lines += [
            f"a finite limit {_LIMIT} has {edge} = 0",
            f"the numbers with that are separated by {fences}",
            f"the value at {certificate['evaluated at']} says which of them it is",
        ]
    lines += certificate.get("slopes", [])
    candidates = certificate.get("candidates") or []
    if candidates:
        shown = ", ".join(_named(candidate, names) for candidate in candidates)
        lines.append(f"anything can change only where one of these is zero: {shown}")
    for place in certificate.get("places", []):
        balls = f" ({'; '.join(place['balls'])})" if place["balls"] else ""
        lines.append(f"{place['place']}: {place['found']}{balls}")
    return lines


def _named(polynomial: str, names: Mapping[str, str]) -> str:
    """A polynomial with the source's names, products without a sign."""
    text = _WORD.sub(lambda word: names.get(word[0], word[0]), polynomial).replace("*", " ")
    return _NEGATIVE.sub(r"- \1", text)
