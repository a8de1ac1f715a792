"""What a matrix statement takes for granted, as certificates have it."""

from __future__ import annotations

from typing import Any

from gainproof.derive.words.expression import Expression

Hypothesis = dict[str, Any]


def symmetric(name: str) -> Hypothesis:
    """A' = A."""
    return {"kind": "symmetric", "matrix": name}


def definite(name: str) -> Hypothesis:
    """A is symmetric and positive definite."""
    return {"kind": "definite", "matrix": name}


def semidefinite(name: str) -> Hypothesis:
    """A is symmetric and positive semidefinite."""
    return {"kind": "semidefinite", "matrix": name}


def invertible(name: str) -> Hypothesis:
    """A is square and has an inverse."""
    return {"kind": "invertible", "matrix": name}


def full_column_rank(name: str) -> Hypothesis:
    """A x = 0 only for x = 0."""
    return {"kind": "full_column_rank", "matrix": name}


def equation(left: Expression, right: Expression) -> Hypothesis:
    """left = right."""
    return {"kind": "equal", "left": left.graph, "right": right.graph}
