"""Fractions that show a sign, as plain data, and the divisors that need one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from gainproof.derive.algebra.plain_data import fraction_data
from gainproof.derive.algebra.positive_forms import NoPlainSign, is_positive_fraction, positive_form
from gainproof.derive.algebra.tower import Fraction, Tower, is_manifestly_positive


def shown(tower: Tower, expression: Any) -> dict[str, Any]:
    """A manifestly positive fraction equal to the expression, as data."""
    return fraction_data(positive_form(tower, sp.sympify(expression)))


def divisors_shown(tower: Tower, *expressions: Any) -> list[dict[str, Any]]:
    """Positive forms of those divisors whose numerator does not show its sign by itself."""
    found: list[dict[str, Any]] = []
    for base in _divisors(expressions):
        if tower.free and any(str(name) in tower.free for name in base.free_symbols):
            continue
        value = tower.fraction(base)
        plain = is_manifestly_positive(value.num, tower.parameters) or is_manifestly_positive(
            -value.num, tower.parameters
        )
        if plain:
            continue
        form = _either_sign(tower, base)
        data = fraction_data(form)
        if is_positive_fraction(tower, form) and data not in found:
            found.append(data)
    return found


def _either_sign(tower: Tower, base: Any) -> Fraction:
    try:
        return positive_form(tower, base)
    except NoPlainSign:
        return positive_form(tower, -base)


def _divisors(expressions: tuple[Any, ...]) -> Iterator[sp.Expr]:
    for expression in expressions:
        entries = expression.flat() if isinstance(expression, sp.MatrixBase) else [expression]
        for entry in entries:
            for part in sp.preorder_traversal(entry):
                if isinstance(part, sp.MatrixBase) and part is not entry:
                    yield from _divisors((part,))
                if isinstance(part, sp.Pow) and part.exp.is_negative:
                    yield part.base
