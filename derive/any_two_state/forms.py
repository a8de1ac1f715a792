"""The gains of two states in sums, products, quotients and roots of positive terms.

Every function works on SymPy symbols, where a certificate proves the form equal to what it stands
for, and on graph nodes, from which kernels are printed. A value is `Signed`: where a difference of
computed values is left, both of its parts are known.

With N = 4 sigma, g = 1 + F22, h = 1 - F22 and W = g^2 d0 + g h d1 + h^2 d2 the second gain follows
from the spectrum at z = F22, where only the noise is left of a triangular model.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.root_excess import excess, excesses
from gainproof.derive.any_two_state.signed_values import Signed


def second_inside(x: Basis) -> bool:
    """Whether F22 lies between -1 and 1."""
    last = x.shape.entry(2, 2)
    return x.shape.sign(1 - last) >= 0 and x.shape.sign(1 + last) >= 0


def far(x: Basis) -> Any:
    """W, for F22 between -1 and 1."""
    return x.weighed(x.far_weights, x.roots).plus


def alpha(x: Basis) -> Any:
    """The first gain, 1 - 1/S = D (N + 4)/N^2."""
    n = x.sum_of_roots
    return (excess(x) / n) * ((n + 4) / n)


def variance_excess(x: Basis) -> Any:
    """M11 = S - 1 = D (N + 4)/16."""
    return excess(x) * (x.sum_of_roots + 4) / 16


def couplings(x: Basis) -> tuple[sp.Expr, sp.Expr]:
    """The numbers k1 and k2 with beta (N W/16 - F12 F21) = k1 alpha + k2 q."""
    f11, f12, f21, f22 = (x.shape.entry(i, j) for i in (1, 2) for j in (1, 2))
    q12, q22 = x.shape.noise(1, 2), x.shape.noise(2, 2)
    first = f21 * (f11 - x.shape.determinant * f22)
    return sp.factor(first), sp.factor((1 - f22**2) * q12 + f12 * f22 * q22)


def below_beta(x: Basis) -> Any | None:
    """N W/16 - F12 F21; None where a subtraction would be left."""
    if not second_inside(x):
        return None
    cross = sp.factor(-x.shape.entry(1, 2) * x.shape.entry(2, 1))
    if x.shape.sign(cross) >= 0:
        return (Signed(x.sum_of_roots * far(x) / 16) + x.signed(cross)).plus
    weights = x.far_weights
    own = sp.factor(sum(w * f for w, f in zip(weights, x.shape.open_loop, strict=True)))
    rest = x.weighed(weights, excesses(x))
    more = excess(x)
    whole = (
        x.signed(sp.factor(own / 4 + cross))
        + rest.over(4)
        + x.term(own, more).over(16)
        + rest.times(more).over(16)
    )
    return whole.plus if whole.is_positive else None


def beta(x: Basis) -> Signed:
    """The second gain; where no better form is found by both parts of its numerator.

    F12 N^2 beta = F22 D^2 + 4 (F22 - F11) D + 2 N (d0 - f0) - 2 N (d2 - f2).
    """
    below = below_beta(x)
    if below is not None:
        first, second = couplings(x)
        return (x.term(first, alpha(x)) + x.term(second, x.area)).over(below)
    f11, f12, f22 = (x.shape.entry(i, j) for i, j in ((1, 1), (1, 2), (2, 2)))
    start, _, end = excesses(x)
    more, n = excess(x), x.sum_of_roots
    top = (
        x.term(f22, (more / n) * (more / n))
        + x.term(4 * (f22 - f11), (more / n) / n)
        + (Signed() if start is None else Signed(2 * (start / n)))
        - (Signed() if end is None else Signed(2 * (end / n)))
    )
    return top * x.signed(sp.factor(1 / f12))


def gains(x: Basis) -> dict[str, Signed]:
    """Filter gain."""
    return {"alpha": Signed(alpha(x)), "beta": beta(x)}
