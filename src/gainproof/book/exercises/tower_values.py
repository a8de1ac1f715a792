"""Formulas of a certificate's tower as expressions of its parameters, to be enclosed at points."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, rebuilt, substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    number,
    power,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.expression_graph import rational
from gainproof.verify.judge.exact.witness import inside
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided

_PATTERNS = tuple(
    tuple(Fraction(text) for text in pattern.split())
    for pattern in (
        "1 2 3 5 7 11 13 17 19 23 29 31",
        "2 3 1 4 1/2 5 7 3/2 1/3 6 9 8",
        "1/2 3 2 1/3 5 3/2 1/4 7 2/3 4 11 1/5",
        "3 1/2 4 7 2 1/3 6 5 9 8 10 12",
        "1/5 7/3 5 1/2 9 2/7 3 13 1/9 4 6 3/8",
    )
)
"""Values that are tried, the simplest first; unlike ones, since what is alike hides slips."""


@dataclass(frozen=True)
class TowerValues:
    """What the names of a tower stand for: roots are the positive roots of their radicands and
    elements are as the tower defines them, so that all are expressions of the parameters.
    """

    values: Mapping[str, Expr]
    boxes: Mapping[str, Box]

    def resolved(self, expr: Expr, free: Sequence[str] = ()) -> Expr:
        """The expression in parameters and free symbols. Raises Undecided for what it cannot."""

        def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
            match node.kind:
                case "symbol":
                    return self._value(node.name, free)
                case "derivative":
                    return self._derivative(parts[0], self._value(node.name, free))
                case "at":
                    target = self._value(node.name, free)
                    if target.kind != "symbol":
                        raise Undecided(f"another value of {node.name}, which is no variable")
                    return substituted(parts[0], {target.name: parts[1]})
                case _:
                    return None

        return rebuilt(expr, change)

    def slope(self, expr: Expr, name: str, free: Sequence[str] = ()) -> Expr:
        """The derivative of a formula by a name of the tower."""
        return self._derivative(self.resolved(expr, free), self._value(name, free))

    def points(self, free: Sequence[str], names: set[str]) -> Iterator[dict[str, Fraction]]:
        """Rational points of the domain, for the names that are wanted."""
        boxes = {**self.boxes, **{name: Box() for name in free}}
        wanted = [name for name in boxes if name in names]
        for pattern in _PATTERNS:
            found = {
                name: inside(boxes[name], pattern[k % len(pattern)])
                for k, name in enumerate(wanted)
            }
            point = {name: value for name, value in found.items() if value is not None}
            if len(point) == len(wanted):
                yield point

    def _value(self, name: str, free: Sequence[str]) -> Expr:
        if name in free:
            return symbol(name)
        if name not in self.values:
            raise Undecided(f"{name} is no name of the tower")
        return self.values[name]

    def _derivative(self, expr: Expr, target: Expr) -> Expr:
        if target.kind == "symbol":
            return differentiated(expr, target.name)
        inner = symbols_of(target)
        if len(inner) != 1:
            raise Undecided("a derivative by what holds several parameters")
        (name,) = inner
        return differentiated(expr, name) / differentiated(target, name)


def tower_values(tower: Mapping[str, Any]) -> TowerValues | None:
    """None for a tower that is not of this kind: matrices of every size, coupled roots."""
    if "matrices" in tower or any("coupled" in entry for entry in tower["generators"]):
        return None
    values = {entry["symbol"]: symbol(entry["symbol"]) for entry in tower["parameters"]}
    boxes = {entry["symbol"]: _box(entry) for entry in tower["parameters"]}
    add_roots(values, tower)
    for name in tower["elements"]:
        values[name] = element_of(tower, name, values)
    return TowerValues(values, boxes)


def _box(parameter: Mapping[str, str]) -> Box:
    if "from" in parameter:
        # reals from there on: whole numbers are among them and are what is counted with
        return Box(lower=rational(parameter["from"]), lower_open=False, integer=True)
    if parameter.get("above") == "0":
        return Box(lower=Fraction(0))
    raise Undecided(f"a domain of another kind: {parameter}")


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
