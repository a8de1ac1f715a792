"""Entries of a model's plain data as expressions over the names of a tower."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from gainproof.derive.expression import ExpressionError, real

_OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": sp.Add,
    "mul": sp.Mul,
    "div": operator.truediv,
    "neg": operator.neg,
}


def matrix_of(rows: list[list[Any]]) -> sp.ImmutableDenseMatrix:
    """The rows of plain data: numbers as text, or graphs of one expression."""
    return sp.ImmutableDenseMatrix([[_entry(entry) for entry in row] for row in rows])


def _entry(entry: Any) -> sp.Expr:
    if isinstance(entry, str):
        return sp.Rational(entry)
    values: list[sp.Expr] = []
    for kind, *rest in entry["nodes"]:
        if kind == "number":
            values.append(sp.Rational(rest[0]))
        elif kind == "symbol":
            values.append(real(rest[0]))
        elif kind == "pow":
            values.append(values[rest[0]] ** sp.Rational(rest[1]))
        elif kind in _OPERATIONS:
            values.append(_OPERATIONS[kind](*(values[number] for number in rest)))
        else:
            raise ExpressionError(f"a model's entry is made of arithmetic, {kind} came")
    return values[entry["outputs"]["value"]]
