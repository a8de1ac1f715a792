"""Statements on matrices of every size as lines of text or LaTeX, each with its hypotheses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # it imports this module
    from gainproof.relation_text import Writer

Claim = Mapping[str, Any]


def _matrix_equal(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.value(claim['left'])} = {w.value(claim['right'])}", *_given(claim, w)]


def _matrix_order(claim: Claim, w: Writer) -> list[str]:
    sign = w.at_least if claim["relation"] == ">=" else ">"
    return [f"{w.value(claim['larger'])} {sign} {w.value(claim['smaller'])}", *_given(claim, w)]


def _matrix_invertible(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.name(claim['matrix'])}{w.words(' is invertible')}", *_given(claim, w)]


def _matrix_trace(claim: Claim, w: Writer) -> list[str]:
    left, right = (f"{w.words('tr ')}({w.value(claim[side])})" for side in ("left", "right"))
    return [f"{left} = {right}", *_given(claim, w)]


def _given(claim: Claim, w: Writer) -> list[str]:
    """The hypotheses of an implication on a line below it."""
    said = [_hypothesis(entry, w) for entry in claim["given"]]
    return [f"{w.words('    if ')}{', '.join(said)}"] if said else []


def _hypothesis(entry: Claim, w: Writer) -> str:
    if entry["kind"] == "equal":
        return f"{w.value(entry['left'])} = {w.value(entry['right'])}"
    name = w.name(entry["matrix"])
    said = {
        "symmetric": f"{name} = {name}'",
        "definite": f"{name} > 0",
        "semidefinite": f"{name} {w.at_least} 0",
        "invertible": f"{name}{w.words(' is invertible')}",
        "full_column_rank": f"{name}{w.words(' has full column rank')}",
    }
    return said[entry["kind"]]


MATRIX_KINDS: Mapping[str, Callable[[Claim, Writer], list[str]]] = {
    "matrix_equal": _matrix_equal,
    "matrix_order": _matrix_order,
    "matrix_invertible": _matrix_invertible,
    "matrix_trace": _matrix_trace,
}
