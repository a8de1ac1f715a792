"""First derivatives of the gains with respect to the index, in the manner of `forms`.

With e_i = d_i - Lambda d_i' >= 0 a product of powers of sums of the roots has a logarithmic
derivative without a subtraction: e0 = f0^2/d0, e2 = f2^2/d2 and
e1 = (f1^2 + (f0 d2 - f2 d0)^2/(d0 d2))/d1.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.forms import alpha, below_beta, couplings, far
from gainproof.derive.any_two_state.signed_values import Signed, total
from gainproof.derive.model import ModelError


def slopes(x: Basis) -> tuple[Any, Any, Any]:
    """The derivatives of d0, d1, d2; None where one is 0."""
    n0, n1 = x.shape.noise_ends
    first, middle, last = x.roots
    start, end = x.term(n0, x.index).over(first), x.term(n1, x.index).over(last)
    inner = x.term(n0 + n1, x.index) + start.times(last) + end.times(first)
    return start.plus, inner.over(middle).plus, end.plus


def rests(x: Basis) -> tuple[Any, Any, Any]:
    """d_i - Lambda d_i'; None where one is 0."""
    f0, f1, f2 = x.shape.open_loop
    n0, n1 = x.shape.noise_ends
    first, middle, last = x.roots
    start, end = x.signed(f0**2).over(first), x.signed(f2**2).over(last)
    both = _sized(x, f0, last) + _sized(x, f2, first)
    if x.shape.sign(f0 * f2) <= 0:
        cross = both * both
    else:
        square = sp.factor((f0**2 * n1 - f2**2 * n0) ** 2)
        cross = x.term(square, x.area * x.area).over(both.plus).over(both.plus)
    inner = x.signed(f1**2) + cross.over(first * last)
    return start.plus, inner.over(middle).plus, end.plus


def _sized(x: Basis, number: sp.Expr, value: Any) -> Signed:
    """|number| times a positive value."""
    return x.term(number if x.shape.sign(number) > 0 else -number, value)


def gains_slope(x: Basis) -> Any:
    """The derivative of the first gain, 32 N'/N^3: a sum without a minus sign."""
    n = x.sum_of_roots
    growth = total(*(Signed(entry) for entry in slopes(x))).plus
    return (growth / n) * ((32 / n) / n)


def gains(x: Basis) -> dict[str, Signed]:
    """The derivatives of both gains with respect to the index."""
    first = Signed(gains_slope(x))
    return {"alpha": first, "beta": _beta(x, first)}


def _beta(x: Basis, growth: Signed) -> Signed:
    """With Y = N W/16 + k3: beta' = (k1 alpha' + k2 Lambda (2 - Lambda Y'/Y))/Y - k1 alpha Y'/Y^2.

    2 - Lambda Y'/Y is (N - Lambda N')/N + (W - Lambda W')/W for k3 = 0.
    """
    one, two = couplings(x)
    below = below_beta(x)
    if below is None or x.shape.sign(-x.shape.entry(1, 2) * x.shape.entry(2, 1)) < 0:
        raise ModelError(
            f"model {x.shape.model.name}: the second gain's derivative has no form of two parts"
        )
    n, w = x.sum_of_roots, far(x)
    kept = rests(x)
    weights = x.far_weights
    left = total(*(Signed(entry) for entry in kept)).times(w) + x.weighed(weights, kept).times(n)
    cross = x.signed(sp.factor(-2 * x.shape.entry(1, 2) * x.shape.entry(2, 1)))
    inner = (cross + left.over(16)).plus
    found = x.term(two, x.index * (inner / below) / below)
    if x.shape.sign(one) == 0:
        return found
    rates = slopes(x)
    change = total(*(Signed(entry) for entry in rates)).times(w) + x.weighed(weights, rates).times(
        n
    )
    fall = x.term(one, alpha(x) * ((change.plus / 16) / below) / below)
    return found + (growth * x.signed(one)).over(below) - fall
