"""Evidence for limits at the ends of a tower's parameter."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from gainproof.derive.algebra.plain import poly_data
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real


def end_evidence(tower: Tower, end: Any) -> dict[str, Any]:
    """Weights, constants and boundary values of one end of a tower."""
    names = list(end.constants)
    ring = PolyRing([real(name) for name in names], sp.QQ, sp.lex)
    return {
        "weights": {entry.symbol: end.weights.get(entry.symbol, 0) for entry in tower.generators},
        "constants": [
            {
                # A name of its own: a root of the same integer may be a generator of the tower.
                "symbol": name.replace("root", "constant"),
                "power": 2,
                "radicand": [[str(end.constants[name]), [0] * len(names)]],
            }
            for name in names
        ],
        "boundary": {
            entry.symbol: poly_data(ring.from_expr(sp.sympify(end.boundary[entry.symbol])))
            for entry in tower.generators
        },
    }
