"""Relations: what a derivation asserts, as SymPy expressions and as plain data.

The kinds are those of certificates (see `gainproof.verify.certificate`): equal, positive,
same_sign, limit, increasing_onto, monotone, riccati, stable, positive_definite, program, sum,
definition and cited; those on matrices of every size are made in `gainproof.derive.words`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from gainproof.derive.expression import graph_of

INFINITY = "infinity"


@dataclass(frozen=True)
class Relation:
    """One assertion; `parts` holds the claim: SymPy expressions, matrices, text, plain data."""

    kind: str
    parts: Mapping[str, Any] = field(default_factory=dict)

    def claim(self) -> dict[str, Any]:
        """The claim as plain data."""
        return {name: _plain(value) for name, value in self.parts.items()}


def _plain(value: Any) -> Any:
    if isinstance(value, (sp.Basic, sp.MatrixBase)):
        return graph_of(value)
    if isinstance(value, Mapping):
        return {name: _plain(entry) for name, entry in value.items()}
    if isinstance(value, tuple):
        return [_plain(entry) for entry in value]
    return value


def equal(left: Any, right: Any, free: tuple[str, ...] = ()) -> Relation:
    """left = right on the whole domain; an identity of rational functions in the `free` symbols."""
    return Relation("equal", {"left": left, "right": right, "free": free})


def positive(expression: Any) -> Relation:
    """expression > 0 on the whole domain."""
    return Relation("positive", {"expression": expression})


def same_sign(left: Any, right: Any) -> Relation:
    """left is positive, zero or negative exactly where right is."""
    return Relation("same_sign", {"left": left, "right": right})


def limit(expression: Any, point: str, value: Any, variable: str = "tracking_index") -> Relation:
    """The limit as `variable` falls to "0" or grows to "infinity"; value may be "infinity".

    Every other parameter of the tower is held; the value is an expression over those.
    """
    return Relation(
        "limit",
        {"expression": expression, "variable": variable, "point": point, "value": value},
    )


def increasing_onto(
    expression: Any, start: Any, end: Any, variable: str = "tracking_index"
) -> Relation:
    """expression increases strictly from `start` to `end` and takes every value between them."""
    return Relation(
        "increasing_onto",
        {"expression": expression, "variable": variable, "from": start, "to": end},
    )


def monotone(expression: Any, trend: str, variable: str = "tracking_index") -> Relation:
    """expression is strictly "increasing" or "decreasing" in `variable`, all else held."""
    return Relation("monotone", {"expression": expression, "variable": variable, "trend": trend})


def definition(left: Any, right: Any) -> Relation:
    """left stands for right; there is nothing to decide."""
    return Relation("definition", {"left": left, "right": right})


def described(text: str) -> Relation:
    """A definition in words."""
    return Relation("definition", {"text": text})


def cited(theorem: str, reference: str) -> Relation:
    """A theorem of the literature, used and not proved here."""
    return Relation("cited", {"theorem": theorem, "reference": reference})
