"""Evidence for limits at the ends of a tower's parameter."""

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
    """How a tower behaves where its parameter tends to 0 or to infinity.

    weights: growth of each generator in powers of the parameter (infinity only). constants: square
    roots of numbers by symbol. boundary: the rescaled generator's value there.
    """

    weights: Mapping[str, int] = field(default_factory=dict)
    constants: Mapping[str, int] = field(default_factory=dict)
    boundary: Mapping[str, sp.Expr] = field(default_factory=dict)


def end_evidence(tower: Tower, end: End) -> dict[str, Any]:
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
