"""Polynomials and fractions of a tower as plain data."""

from __future__ import annotations

from typing import Any

from gainproof.derive.algebra.tower import Fraction, Parameter, Poly, Tower


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
            _generator(tower, number)
            for number in range(len(tower.generators))
            if number == 0 or not tower.starts_pair(number - 1)
        ],
        "elements": {name: fraction_data(value) for name, value in tower.elements.items()},
    }


def _parameter(entry: Parameter) -> dict[str, Any]:
    if entry.start is not None:
        return {"symbol": entry.symbol, "from": entry.start}
    return {"symbol": entry.symbol, "above": entry.above}


def _generator(tower: Tower, number: int) -> dict[str, Any]:
    entry = tower.generators[number]
    if not tower.starts_pair(number):
        radicand = poly_data(tower.radicands[number])
        return {"symbol": entry.symbol, "power": entry.power, "radicand": radicand}
    first, second = tower.couplings(number), tower.couplings(number + 1)
    return {
        "coupled": [entry.symbol, entry.partner],
        "free": [poly_data(first[0]), poly_data(second[0])],
        "slopes": [poly_data(first[1]), poly_data(second[1])],
    }
