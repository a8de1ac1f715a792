"""The whole proof or witness of one claim as text a reader can follow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.certificate import statement_from
from gainproof.verify.judge.exact.expression import symbol
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.graph import read_graph

Claim = Mapping[str, Any]


def explain(claim: Claim) -> str:
    """Text for a claim in the form of `check --json`: what was shown, on what ground, and where it
    fails.
    """
    evidence = claim["evidence"]
    certificate: Mapping[str, Any] = evidence["certificate"] or {}
    lines = [f"{claim['id']}: {claim['verdict']}", f"  {claim['latex'] or claim['kind']}", ""]
    for label, value in (
        ("place", claim["place"]),
        ("convention", claim["convention"]),
        ("reading", claim["reading"]),
        ("domain", claim["domain"]),
        ("method", evidence["method"]),
        ("result", claim["reason"]),
    ):
        if value:
            lines.append(f"{label + ':':<12}{value}")
    lines += _established(certificate)
    for title, part in _parts(certificate):
        lines += ["", *([title] if title else []), *_proof(part)]
    lines += _witness("Counterexample", evidence["witness"])
    for name, other in certificate.get("against other conventions", {}).items():
        lines += _witness(f"Against {name}", other)
    return "\n".join(lines) + "\n"


def _parts(certificate: Mapping[str, Any]) -> list[tuple[str, Mapping[str, Any]]]:
    """One proof, or several under names."""
    if "statement" in certificate or "leading coefficient" in certificate:
        return [("", certificate)]
    return [
        (f"{name}:", part)
        for name, part in certificate.items()
        if isinstance(part, Mapping) and "statement" in part
    ]


def _established(certificate: Mapping[str, Any]) -> list[str]:
    facts = certificate.get("established", [])
    if not facts:
        return []
    numbered = [f"  {n}. {fact}" for n, fact in enumerate(facts, start=1)]
    return ["", "Established about the setting, from its matrices alone:", *numbered]


def _proof(certificate: Mapping[str, Any]) -> list[str]:
    lines: list[str] = []
    if "statement" in certificate:
        lines += _statement(certificate["statement"], certificate.get("quantities", {}))
    variables = certificate.get("variables", {})
    if variables:
        lines.append("Variables: " + ", ".join(f"{k} = {v}" for k, v in variables.items()))
    if certificate.get("tower"):
        lines.append("Roots, each t the denominator of its radicand times the root:")
        lines += [f"  {relation}" for relation in certificate["tower"]]
    if "leading coefficient" in certificate:
        lines += [
            f"Finite limits are roots of {certificate['leading coefficient']} in u0.",
            f"They are separated by {', '.join(certificate['separating rationals'])}.",
            f"The value at {certificate['evaluated at']} says which is the limit.",
        ]
    if certificate.get("candidates"):
        joined = ", ".join(certificate["candidates"])
        lines.append(f"Where anything can change, one of these is zero: {joined}")
    for place in certificate.get("places", []):
        balls = f" [{'; '.join(place['balls'])}]" if place["balls"] else ""
        lines.append(f"  {place['place']}: {place['found']}{balls}")
    return lines


def _statement(data: Mapping[str, Any], quantities: Mapping[str, Any]) -> list[str]:
    """The relations in base variables; an identity without balls has remainder zero."""
    statement, boxes, _, labels = statement_from(data)
    names = {name: symbol(labels.get(name, name)) for name in boxes}
    statement = statement.mapped(lambda e: substituted(e, names))
    relations = [*statement.relations, *statement.conditions]
    meanings = {substituted(read_graph(g), names): token for token, g in quantities.items()}
    sides = [side for r in relations for side in (r.left, r.right)]
    shared, texts = written(*sides, names=meanings)
    pairs = zip(texts[::2], texts[1::2], strict=True)
    shown = [f"  {a} {r.operator} {b}" for r, (a, b) in zip(relations, pairs, strict=True)]
    count = len(statement.relations)
    lines = ["In base variables:", *shown[:count]]
    if statement.conditions:
        word = "exactly where" if statement.connective == "iff" else "where"
        lines += [word, *shown[count:]]
    if shared:
        lines += ["with", *[f"  {line}" for line in shared]]
    domains = [box.text(labels.get(name, name)) for name, box in boxes.items()]
    return [*lines, "for " + "; ".join(domains)] if domains else lines


def _witness(title: str, witness: Any) -> list[str]:
    if not witness:
        return []
    if isinstance(witness, str):
        return ["", f"{title}: {witness}"]
    where = ", ".join(f"{name} = {value}" for name, value in witness["point"].items()) or "always"
    lines = ["", f"{title}: {where}"]
    for side in ("left", "right"):
        value = witness[side]
        text = value.get("undefined") or f"{value['midpoint']} +/- {value['radius']}"
        lines.append(f"  {side:<6}{text}")
    for name, value in witness.get("values", {}).items():
        lines.append(f"  where {name} = {value['midpoint']} +/- {value['radius']}")
    if witness.get("note"):
        lines.append(f"  {witness['note']}")
    return lines
