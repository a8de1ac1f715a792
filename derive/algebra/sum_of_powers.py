"""Long sums of products of powers read at once: term by term a tower takes many times as long."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from gainproof.derive.algebra.variables import Poly


def sum_of_powers(value: sp.Expr, places: Mapping[sp.Symbol, int], ring: PolyRing) -> Poly | None:
    """A sum of rational numbers times powers of variables; None for anything else.

    `places` are the positions of the variables in the ring's monomials.
    """
    found: dict[tuple[int, ...], Any] = {}
    for term in sp.Add.make_args(value):
        exponents, number = [0] * len(ring.symbols), sp.QQ(1)
        for factor in sp.Mul.make_args(term):
            base, power = factor.as_base_exp()
            if isinstance(factor, sp.Rational):
                number *= sp.QQ(int(factor.p), int(factor.q))
            elif base in places and isinstance(power, sp.Integer) and power > 0:
                exponents[places[base]] += int(power)
            else:
                return None
        key = tuple(exponents)
        found[key] = found.get(key, sp.QQ(0)) + number
    return ring.from_dict(found)
