"""How far d0, d1, d2 lie above the coefficients f0, f1, f2 of the model, without a subtraction.

d_i^2 - f_i^2 is a sum of positive terms, hence d_i - f_i is one or a quotient of such; D below is
their sum, N = d0 + d1 + d2 = 4 + D.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.signed_values import Signed


def gap(x: Basis) -> Signed:
    """d0 d2 - f0 f2 without a subtraction."""
    (f0, _, f2), (n0, n1) = x.shape.open_loop, x.shape.noise_ends
    first, _, last = x.roots
    own = f0 * f2
    if x.shape.sign(own) <= 0:
        return Signed(first * last) + x.signed(-own)
    inner = x.term(f0**2 * n1 + f2**2 * n0, x.area) + x.term(n0 * n1, x.area * x.area)
    return inner.over((Signed(first * last) + x.signed(own)).plus)


def rises(x: Basis) -> tuple[Signed, Signed, Signed]:
    """d_i^2 - f_i^2."""
    n0, n1 = x.shape.noise_ends
    middle = x.term(n0 + n1, x.area) + gap(x).times(2)
    return x.term(n0, x.area), middle, x.term(n1, x.area)


def excesses(x: Basis) -> tuple[Any, Any, Any]:
    """d_i - f_i without a subtraction; None where it is 0."""
    found: list[Any] = []
    for own, root, rise in zip(x.shape.open_loop, x.roots, rises(x), strict=True):
        if x.shape.sign(own) <= 0:
            found.append((Signed(root) + x.signed(-own)).plus)
        elif rise.is_zero:
            found.append(None)
        else:
            found.append(rise.over((Signed(root) + x.signed(own)).plus).plus)
    return found[0], found[1], found[2]


def excess(x: Basis) -> Any:
    """D = N - 4."""
    first, *rest = (entry for entry in excesses(x) if entry is not None)
    for entry in rest:
        first = first + entry
    return first
