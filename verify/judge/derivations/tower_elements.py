"""Roots and named elements of a certificate's tower as expressions: definitions, not claims."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.expression import Expr, add, mul, number, power
from gainproof.verify.judge.exact.graph import rational
from gainproof.verify.judge.exact.limits import Malformed


def add_roots(values: dict[str, Expr], tower: Mapping[str, Any] | None) -> None:
    """Every root of the tower is the positive root of its radicand: a definition, not a claim."""
    if tower is None:
        return
    names = [p["symbol"] for p in tower["parameters"]] + [g["symbol"] for g in tower["generators"]]
    for generator in tower["generators"]:
        radicand = _polynomial(generator["radicand"], names, values)
        values[generator["symbol"]] = power(radicand, Fraction(1, generator["power"]))


def _polynomial(entries: Any, names: Sequence[str], values: Mapping[str, Expr]) -> Expr:
    terms = []
    for coefficient, exponents in entries:
        factors = [number(rational(coefficient))]
        for name, exponent in zip(names, exponents, strict=True):
            if exponent:
                if name not in values:
                    raise Malformed(f"{name} is used before it is defined")
                factors.append(power(values[name], exponent))
        terms.append(mul(*factors))
    return add(*terms) if terms else number(0)


def element_of(tower: Mapping[str, Any], name: str, values: Mapping[str, Expr]) -> Expr:
    """A named element of a tower in terms of its parameter and roots."""
    element = tower["elements"][name]
    names = [p["symbol"] for p in tower["parameters"]] + [g["symbol"] for g in tower["generators"]]
    top = _polynomial(element["num"], names, values)
    bottom = _polynomial(element["den"], names, values)
    return top / bottom
