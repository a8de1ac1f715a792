"""How far d0, ..., d3 lie above the coefficients g0, ..., g3 of the model, without a subtraction.

e_k = d_k - g_k is d_k + |g_k| where g_k <= 0, and q n_k/(d_k + g_k) at both ends. Where g0 <= 0 <=
g2, d1^2 - g1^2 = q n1 + 2 d0 d2 - 2 g0 g2 is a sum of positive terms, likewise d2^2 - g2^2 where
g3 <= 0 <= g1. The equations of
the coupled pair, less those of the model without noise, are
(d1 + g1) e1 - 2 g0 e2 = q n1 + 2 e0 d2 and (d2 + g2) e2 - 2 g3 e1 = q n2 + 2 e3 d1; where all g_k
are positive their determinant is d1 d2 - 4 d0 d3 + 4 (d0 d3 - g0 g3) + g1 d2 + g2 d1 + g1 g2 with
d1 d2 - 4 d0 d3 = (A1 A2 + 2 A1 d3 d1 + 2 A2 d0 d2)/(d1 d2).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.any_three_state.basis import Basis
from gainproof.derive.any_two_state.signed_values import Signed, total
from gainproof.derive.model import ModelError


def excesses(x: Basis) -> tuple[Signed, Signed, Signed, Signed]:
    """d_k - g_k; ModelError where a subtraction would be left."""
    g0, _, _, g3 = x.shape.open_loop
    below = [x.shape.sign(own) <= 0 for own in x.shape.open_loop]
    first, last = _end(x, 0), _end(x, 3)
    one = _alone(x, 1) if below[1] or (below[0] and not below[2]) else None
    two = _alone(x, 2) if below[2] or (below[3] and not below[1]) else None
    rise1, rise2 = _rise(x, 1, first), _rise(x, 2, last)
    if one is None and two is None:  # all g_k are positive
        determinant = _determinant(x, first, last)
        one = (rise1.times(_sum(x, 2)) + _scaled(x, 2 * g0, rise2)).over(determinant)
        two = (rise2.times(_sum(x, 1)) + _scaled(x, 2 * g3, rise1)).over(determinant)
    elif one is None and two is not None:
        one = (rise1 + _scaled(x, 2 * g0, two)).over(_sum(x, 1))
    elif two is None and one is not None:
        two = (rise2 + _scaled(x, 2 * g3, one)).over(_sum(x, 2))
    assert one is not None
    assert two is not None
    if any(entry.minus is not None for entry in (first, one, two, last)):
        raise ModelError(f"model {x.shape.model.name}: N - 8 has no form without a subtraction")
    return first, one, two, last


def _alone(x: Basis, number: int) -> Signed:
    """d1 - g1 or d2 - g2 where it does not need the other: g_k <= 0, or the end beyond it is."""
    own = x.shape.open_loop[number]
    if x.shape.sign(own) <= 0:
        return Signed(x.roots[number]) - x.term(own)
    end, other = (0, 2) if number == 1 else (3, 1)
    product = sp.factor(-2 * x.shape.open_loop[end] * x.shape.open_loop[other])
    rise = x.term(x.shape.shaken[number], x.area) + x.term(product)
    return (rise + Signed(2 * (x.roots[end] * x.roots[other]))).over(_sum(x, number))


def _rise(x: Basis, number: int, end: Signed) -> Signed:
    """q n1 + 2 e0 d2, or q n2 + 2 e3 d1."""
    other = x.roots[2 if number == 1 else 1]
    return x.term(x.shape.shaken[number], x.area) + end.times(other).times(2)


def excess(x: Basis) -> Any:
    """D = N - 8."""
    return total(*excesses(x)).plus


def _end(x: Basis, number: int) -> Signed:
    own, noise = x.shape.open_loop[number], x.shape.shaken[number]
    if x.shape.sign(own) <= 0:
        return Signed(x.roots[number]) - x.term(own)
    rise = x.term(noise, x.area)
    return rise if rise.is_zero else rise.over(_sum(x, number))


def _sum(x: Basis, number: int) -> Any:
    """d_k + g_k."""
    return (Signed(x.roots[number]) + x.term(x.shape.open_loop[number])).plus


def _scaled(x: Basis, number: sp.Expr, value: Signed) -> Signed:
    """A number times a value."""
    parts = [Signed() if part is None else x.term(number, part) for part in value.parts]
    return parts[0] - parts[1]


def _determinant(x: Basis, first: Signed, last: Signed) -> Any:
    """(d1 + g1)(d2 + g2) - 4 g0 g3."""
    g0, g1, g2, _ = x.shape.open_loop
    _, d1, d2, d3 = x.roots
    ends = first.times(d3) + _scaled(x, g0, last)
    return (
        x.apart + ends.times(4) + x.term(g1, d2) + x.term(g2, d1) + x.term(sp.factor(g1 * g2))
    ).plus
