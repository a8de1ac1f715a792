"""Evidence for limits at the ends of one parameter of a tower, the others held."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from gainproof.derive.algebra.plain_data import poly_data
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real


@dataclass(frozen=True)
class ConstantPair:
    """x^2 = a + b y and y^2 = c + e x: y's symbol, a and c, b and e."""

    second: str
    free: tuple[sp.Expr, sp.Expr]
    slopes: tuple[sp.Expr, sp.Expr]


@dataclass(frozen=True)
class End:
    """How a tower behaves where one parameter tends to 0 or to infinity and the others are held.

    weights: growth of each generator in powers of the parameter (falling to 0: negative, or none).
    constants: radicands of square roots by symbol, over the other parameters and earlier constants;
    for two that are coupled a `ConstantPair` under the first one's symbol.
    boundary: the rescaled generator's value there, a polynomial over these.
    """

    weights: Mapping[str, int] = field(default_factory=dict)
    constants: Mapping[str, int | sp.Expr | ConstantPair] = field(default_factory=dict)
    boundary: Mapping[str, sp.Expr] = field(default_factory=dict)


def end_evidence(tower: Tower, end: End, variable: str) -> dict[str, Any]:
    """Weights, constants and boundary values of one end of the parameter behind a variable."""
    tending = tower.parameter_of(variable)
    held = [entry.symbol for entry in tower.parameters if entry.symbol != tending]
    names = [*held, *constant_names(end.constants)]
    ring = PolyRing([real(name) for name in names], sp.QQ, sp.lex)
    return {
        "weights": {entry.symbol: end.weights.get(entry.symbol, 0) for entry in tower.generators},
        "constants": [_constant(ring, name, radicand) for name, radicand in end.constants.items()],
        "boundary": {
            entry.symbol: poly_data(ring.from_expr(sp.expand(end.boundary[entry.symbol])))
            for entry in tower.generators
        },
    }


def constant_names(constants: Mapping[str, Any]) -> list[str]:
    """The symbols of all constants in order."""
    names: list[str] = []
    for name, entry in constants.items():
        names += [name, entry.second] if isinstance(entry, ConstantPair) else [name]
    return names


def _constant(ring: PolyRing, name: str, entry: Any) -> dict[str, Any]:
    """As the certificate has it; a name of its own: a root of the same integer may be a generator
    of the tower.
    """

    def written(value: Any) -> Any:
        return poly_data(ring.from_expr(sp.expand(value)))

    if isinstance(entry, ConstantPair):
        return {
            "coupled": [each.replace("root", "constant") for each in (name, entry.second)],
            "free": [written(value) for value in entry.free],
            "slopes": [written(value) for value in entry.slopes],
        }
    return {
        "symbol": name.replace("root", "constant"),
        "power": 2,
        "radicand": written(entry),
    }
