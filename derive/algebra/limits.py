"""Evidence for limits at the ends of one parameter of a tower, the others held."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from gainproof.derive.algebra.plain import poly_data
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real


@dataclass(frozen=True)
class End:
    """How a tower behaves where one parameter tends to 0 or to infinity and the others are held.

    weights: growth of each generator in powers of the parameter (falling to 0: negative, or none).
    constants: radicands of square roots by symbol, over the other parameters and earlier constants.
    boundary: the rescaled generator's value there, a polynomial over these.
    """

    weights: Mapping[str, int] = field(default_factory=dict)
    constants: Mapping[str, int | sp.Expr] = field(default_factory=dict)
    boundary: Mapping[str, sp.Expr] = field(default_factory=dict)


def end_evidence(tower: Tower, end: End, variable: str) -> dict[str, Any]:
    """Weights, constants and boundary values of one end of the parameter behind a variable."""
    tending = tower.parameter_of(variable)
    held = [entry.symbol for entry in tower.parameters if entry.symbol != tending]
    names = [*held, *end.constants]
    ring = PolyRing([real(name) for name in names], sp.QQ, sp.lex)
    return {
        "weights": {entry.symbol: end.weights.get(entry.symbol, 0) for entry in tower.generators},
        "constants": [
            {
                # A name of its own: a root of the same integer may be a generator of the tower.
                "symbol": name.replace("root", "constant"),
                "power": 2,
                "radicand": poly_data(ring.from_expr(sp.expand(radicand))),
            }
            for name, radicand in end.constants.items()
        ],
        "boundary": {
            entry.symbol: poly_data(ring.from_expr(sp.expand(end.boundary[entry.symbol])))
            for entry in tower.generators
        },
    }
