"""Polynomials and fractions of a tower as plain data."""

from __future__ import annotations

from typing import Any

from gainproof.derive.algebra.tower import Fraction, Generator, Parameter, Poly, Tower


def poly_data(poly: Poly) -> list[list[Any]]:
    """[["coefficient", [exponents]], ...] sorted by exponents, highest first."""
    ordered = sorted(poly.terms(), key=lambda term: term[0], reverse=True)
    return [[str(coefficient), list(exponents)] for exponents, coefficient in ordered]


def fraction_data(value: Fraction) -> dict[str, Any]:
    """{"num": polynomial, "den": polynomial}."""
    return {"num": poly_data(value.num), "den": poly_data(value.den)}


def tower_data(tower: Tower) -> dict[str, Any]:
    """The tower with its generators' radicands and its named elements."""
    return {
        "parameters": [_parameter(entry) for entry in tower.parameters],
        "generators": [
            _generator(entry, radicand)
            for entry, radicand in zip(tower.generators, tower.radicands, strict=True)
        ],
        "elements": {name: fraction_data(value) for name, value in tower.elements.items()},
    }


def _parameter(entry: Parameter) -> dict[str, Any]:
    if entry.start is not None:
        return {"symbol": entry.symbol, "from": entry.start}
    return {"symbol": entry.symbol, "above": entry.above}


def _generator(entry: Generator, radicand: Poly) -> dict[str, Any]:
    return {"symbol": entry.symbol, "power": entry.power, "radicand": poly_data(radicand)}
