"""A certificate as statements with goals: read off the claims, and off the evidence what helps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from gainproof.certify import models
from gainproof.certify.expression import NotExportedError, fraction, graph, one, polynomial
from gainproof.certify.goals import Goal, Relation, Statement, Tower

UNRELATED = "_unrelated"
"""Added to a tower's name: its letters are any positive numbers, no root obeys anything."""
KINDS = ("equal", "positive", "same_sign", "riccati", "stable", "positive_definite")


def towers(certificate: Mapping[str, Any]) -> dict[str, Tower]:
    """The towers by name whose statements are exported."""
    found = {}
    for name, entry in certificate["towers"].items():
        with suppress(NotExportedError):
            found[name] = tower = _tower(entry)
            found[name + UNRELATED] = Tower(tower.names, {}, (), {})
    return found


def _tower(entry: Mapping[str, Any]) -> Tower:
    if "matrices" in entry:
        raise NotExportedError("matrices of any size")
    parameters = tuple(record["symbol"] for record in entry["parameters"])
    if any("coupled" in record for record in entry["generators"]):
        raise NotExportedError("coupled roots")
    names = (*parameters, *(record["symbol"] for record in entry["generators"]))
    relations = [
        Relation(record["symbol"], record["power"], polynomial(record["radicand"], names))
        for record in entry["generators"]
    ]
    return Tower(
        parameters,
        {record["symbol"]: record["from"] for record in entry["parameters"] if "from" in record},
        tuple(relations),
        {name: fraction(value, names) for name, value in entry["elements"].items()},
    )


def statements(certificate: Mapping[str, Any]) -> Iterator[Statement]:
    """Every statement that is proved in it (not what is cited or defined)."""
    for record in certificate["statements"]:
        kind = record["kind"]
        if kind in ("definition", "cited"):
            continue
        statement = Statement(record["id"], kind, record["tower"])
        try:
            if kind not in KINDS:
                raise NotExportedError(kind)
            entry = certificate["towers"][record["tower"]]
            goals = _goals(kind, record["claim"], record["evidence"], _tower(entry))
            yield replace(statement, goals=tuple(goals))
            if kind == "riccati":
                goals = models.cofactors(record["claim"], record["evidence"], entry, _tower(entry))
                tower = record["tower"] + UNRELATED
                yield Statement(f"{record['id']}: cofactors", "cofactors", tower, tuple(goals))
        except NotExportedError as reason:
            yield replace(statement, left_out=str(reason))


def _goals(
    kind: str, claim: Mapping[str, Any], evidence: Mapping[str, Any], tower: Tower
) -> Iterator[Goal]:
    names = tower.names
    listed = tuple(fraction(value, names) for value in evidence.get("nonzero", ()))
    match kind:
        case "equal":
            free = tuple(claim.get("free", ()))
            sides = graph(claim["left"]), graph(claim["right"])
            for rows in zip(*sides, strict=True):
                for left, right in zip(*rows, strict=True):
                    yield Goal(left, right, free=free, nonzero=listed)
        case "positive":
            left = one(graph(claim["expression"]))
            yield Goal(left, fraction(evidence["value"], names), True, nonzero=listed)
        case "same_sign":
            factor = fraction(evidence["factor"], names)
            yield Goal(factor, factor, True)
            left, right = one(graph(claim["left"])), one(graph(claim["right"]))
            yield Goal(left, factor * right, nonzero=listed)
        case "riccati":
            yield from models.riccati(claim, evidence, names)
        case "stable":
            yield from models.stable(claim, evidence, names)
        case "positive_definite":
            matrix = models.symbols(claim["matrix"])
            for size, value in enumerate(evidence["minors"], 1):
                minor = models.determinant(tuple(row[:size] for row in matrix[:size]))
                yield Goal(minor, fraction(value, names), True)
