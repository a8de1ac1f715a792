"""The covariances of two states in the manner of `forms`."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.forms import (
    alpha,
    beta,
    far,
    second_inside,
    variance_excess,
)
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.model import ModelError


def updated_22(x: Basis) -> Signed:
    """The updated variance of the second state."""
    if x.shape.sign(x.shape.entry(2, 1)) == 0 and second_inside(x):
        return _triangular_22(x)
    f11, f12, f21, f22 = (x.shape.entry(i, j) for i in (1, 2) for j in (1, 2))
    if x.shape.sign(f22) == 0:
        top = (
            Signed(variance_excess(x))
            - x.term(f11**2, alpha(x))
            - beta(x) * x.signed(2 * f11 * f12)
            - x.term(x.shape.noise(1, 1), x.area)
        )
        return top * x.signed(sp.factor(1 / f12**2))
    second = beta(x)
    top = (
        second.times(variance_excess(x))
        + second * x.signed(sp.factor(1 - f11 * f22 - f12 * f21))
        - x.term(f11 * f21, alpha(x))
        - x.term(x.shape.noise(1, 2), x.area)
    )
    return top * x.signed(sp.factor(1 / (f12 * f22)))


def _triangular_22(x: Basis) -> Signed:
    """For F21 = 0: 2 q Q22 d1/W, less q Q12 N beta/W; if both are positive as one quotient."""
    q12, q22 = x.shape.noise(1, 2), x.shape.noise(2, 2)
    _, middle, _ = x.roots
    below = far(x)
    own = x.term(2 * q22, x.area * middle)
    if x.shape.sign(q12) == 0:
        return own.over(below)
    plain = own - (beta(x) * x.signed(q12)).times(x.area * x.sum_of_roots)
    if not plain.cancels:
        return plain.over(below)
    joined = _difference_of_squares(x)
    return plain.over(below) if joined is None else joined.times(x.area).over(below)


def _difference_of_squares(x: Basis) -> Signed | None:
    """(k d1 - Q12 G)/(F12 F22), G = g^2 d0 + h^2 d2, as (k^2 d1^2 - Q12^2 G^2) over the sum."""
    f12, f22 = x.shape.entry(1, 2), x.shape.entry(2, 2)
    q12, q22 = x.shape.noise(1, 2), x.shape.noise(2, 2)
    if f22 == 0:
        return None
    (f0, f1, f2), (n0, n1) = x.shape.open_loop, x.shape.noise_ends
    square, mixed, other = x.far_weights
    weight = 2 * f12 * f22 * q22 + q12 * mixed
    first, middle, last = x.roots
    both = sp.factor(weight**2 - q12**2 * square * other)
    top = (
        x.signed(
            sp.factor(
                weight**2 * (f1**2 - 2 * f0 * f2) - q12**2 * (square**2 * f0**2 + other**2 * f2**2)
            )
        )
        + x.term(
            sp.factor(weight**2 * (n0 + n1) - q12**2 * (square**2 * n0 + other**2 * n1)), x.area
        )
        + x.term(2 * both, first * last)
    )
    own = x.weighed((q12 * square, sp.Integer(0), q12 * other), x.roots)
    sum_of_both = x.term(weight, middle) + own
    if top.cancels or sum_of_both.cancels or sum_of_both.minus is not None:
        return None
    return (top * x.signed(sp.factor(1 / (f12 * f22)))).over(sum_of_both.plus)


def updated_covariance(x: Basis) -> dict[str, Signed]:
    """Entries of the updated covariance."""
    return {"updated_11": Signed(alpha(x)), "updated_12": beta(x), "updated_22": updated_22(x)}


def predicted_covariance(x: Basis) -> dict[str, Signed]:
    """Entries of the predicted covariance: M12 = beta S and M22 = X22 + beta^2 S."""
    second, n = beta(x), x.sum_of_roots
    cross = second.times(n).times(n).over(16)
    return {
        "predicted_11": Signed(variance_excess(x)),
        "predicted_12": cross,
        "predicted_22": updated_22(x) + second * cross,
    }


def updated_determinant(x: Basis) -> Any:
    """det X = q (tr(adj(X) A) + q det Q0)/(S - det^2 F), A = adj(F) Q0 adj(F)'.

    It follows from det M = S det X and M = F X F' + q Q0. Raises ModelError where a subtraction is
    left.
    """
    matrix, noise = x.shape.model.transition, x.shape.model.process_noise
    adjugate = matrix.adjugate()
    inner = (adjugate * noise * adjugate.T).applyfunc(sp.factor)
    found = (
        (updated_22(x) * x.signed(inner[0, 0]) if inner[0, 0] != 0 else Signed())
        + beta(x) * x.signed(sp.factor(-2 * inner[0, 1]))
        + x.term(inner[1, 1], alpha(x))
        + x.term(sp.factor(noise.det()), x.area)
    )
    below = Signed(variance_excess(x)) + x.signed(sp.factor(1 - x.shape.determinant**2))
    if not found.is_positive or not below.is_positive:
        raise ModelError(f"model {x.shape.model.name}: det X has no form without a subtraction")
    return x.area * found.plus / below.plus
