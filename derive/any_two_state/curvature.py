"""Second derivatives of the gains with respect to the index, by their positive parts.

From d_i d_i' over the index: d0'' = n0 f0^2/d0^3, d2'' = n1 f2^2/d2^3 and
d1'' = (n0 + n1 + (d0 d2)'' - d1'^2)/d1. With N the sum of the roots alpha'' is
32 N''/N^3 - 96 N'^2/N^4; beta is a quotient T/Y.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.derivatives import gains_slope, slopes
from gainproof.derive.any_two_state.forms import alpha, below_beta, couplings, far
from gainproof.derive.any_two_state.signed_values import Signed, total
from gainproof.derive.model import ModelError


def bends(x: Basis) -> tuple[Signed, Signed, Signed]:
    """The second derivatives of d0, d1, d2."""
    (f0, _, f2), (n0, n1) = x.shape.open_loop, x.shape.noise_ends
    first, middle, last = x.roots
    rates = [Signed(entry) for entry in slopes(x)]
    start = x.signed(n0 * f0**2).over(first).over(first).over(first)
    end = x.signed(n1 * f2**2).over(last).over(last).over(last)
    product = start.times(last) + end.times(first) + (rates[0] * rates[2]).times(2)
    inner = (x.signed(n0 + n1) + product).over(middle) - (rates[1] * rates[1]).over(middle)
    return start, inner, end


def gains(x: Basis) -> dict[str, Signed]:
    """The second derivatives of both gains."""
    n = x.sum_of_roots
    growth = total(*(Signed(entry) for entry in slopes(x))).over(n)
    bend = total(*bends(x)).over(n)
    size = (32 / n) / n
    first = bend.times(size) - (growth * growth).times(3 * size)
    return {"alpha": first, "beta": _beta(x, first)}


def _beta(x: Basis, bend: Signed) -> Signed:
    """T''/Y - 2 T' Y'/Y^2 - T Y''/Y^2 + 2 T Y'^2/Y^3 with T = k1 alpha + k2 q, Y = N W/16 + k3."""
    below = below_beta(x)
    if below is None or x.shape.sign(-x.shape.entry(1, 2) * x.shape.entry(2, 1)) < 0:
        raise ModelError(
            f"model {x.shape.model.name}: the second gain's derivatives have no form of two parts"
        )
    one, two = couplings(x)
    top = (x.term(one, alpha(x)) + x.term(two, x.area)).over(below)
    change = (x.term(one, gains_slope(x)) + x.term(2 * two, x.index)).over(below)
    curve = (x.scaled(one, bend) + x.signed(sp.factor(2 * two))).over(below)
    (n, n1, n2), (w, w1, w2) = _sums(x), _far_sums(x)
    first = (n1.times(w) + w1.times(n)).over(16).over(below)
    second = (n2.times(w) + w2.times(n) + (n1 * w1).times(2)).over(16).over(below)
    return curve - (change * first).times(2) - top * second + (top * first * first).times(2)


def _sums(x: Basis) -> tuple[Any, Signed, Signed]:
    """N, N' and N''."""
    rates = total(*(Signed(entry) for entry in slopes(x)))
    return x.sum_of_roots, rates, total(*bends(x))


def _far_sums(x: Basis) -> tuple[Any, Signed, Signed]:
    """W, W' and W''."""
    rates = [Signed(entry) for entry in slopes(x)]
    return (
        far(x),
        total(*(x.scaled(w, rate) for w, rate in zip(x.far_weights, rates, strict=True))),
        total(*(x.scaled(w, bend) for w, bend in zip(x.far_weights, bends(x), strict=True))),
    )
