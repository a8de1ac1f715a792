"""Second derivatives of the two-state covariances by Lambda, in the forms of `covariance_forms`.

See `curvature`. Those of M12, M22 and X22 are positive; that of M11 changes its sign once.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.derive.steady_state.curvature import Curvature
from gainproof.derive.steady_state.forms import Basis, times


def _rate_with_independent_noise(c: Curvature) -> Any:
    """X22'' for n = 0: (3 rho + 5 d/rho + d q/rho^3)/4 + e q/(8 rho kappa^2) with
    d = rho^2 - q = (1 + e)/4 + e/(4 kappa).
    """
    x, e, v, k = c.x, c.x.e, c.inverse_ratio, c.inverse_kappa
    share = c.fall / c.square
    if e == 0:
        return c.ratio * Fraction(3, 4) + v * ((5 + share) / 16)
    rest = (1 + e) / 4 + k * (e / 4)
    inner = rest * (5 + share) + (c.fall / x.kappa) * (k * (e / 2))
    return c.ratio * Fraction(3, 4) + v * (inner / 4)


def _rate_with_interval_noise(c: Curvature) -> Any:
    """X22'' for n = 1/2: (w (2q + w)/(4 rho^2) + e (1 + 1/kappa + q/(2 kappa^2))/4)/rho with
    w = y^2 + e (1 + 1/kappa)/4; for e = 0: y^3 (3y + 2)/(4 rho^3).
    """
    x, e, v, k = c.x, c.x.e, c.inverse_ratio, c.inverse_kappa
    y = c.half_step
    if e == 0:
        share = x.kappa / (c.square + x.rho / 2)
        return (share * share) * (share * ((y * 3 + 2) / 4))
    w = (y * x.unit) * y + (1 + k) * (x.unit * e / 4)
    first = (w / c.square) * ((c.fall + w / 2) / x.rho) / 2
    return first + v * ((1 + k + (c.fall / x.kappa) * (k / 2)) * (e / 4))


def rate_second_derivative(x: Basis) -> Any:
    """The second derivative of X22, which is linear in n."""
    c, weight = Curvature(x), 2 * x.n
    if weight == 0:
        return _rate_with_independent_noise(c)
    if weight == 1:
        return _rate_with_interval_noise(c)
    return times(1 - weight, _rate_with_independent_noise(c)) + times(
        weight, _rate_with_interval_noise(c)
    )


def cross_second_derivative(x: Basis) -> Any:
    """The second derivative of M12: (sigma/Lambda) (psi/2) (1 + psi/2 + 1 - chi)."""
    c = Curvature(x)
    inner = 1 + c.growth / 2 + c.unbent
    if x.e == 0:
        return ((2 + c.inverse_ratio) * (x.wider * (1 / (16 * x.unit)))) * inner
    if x.e == 1:
        return ((x.total / x.kappa) * (c.ratio / 4)) * inner
    return ((x.total / x.rho) * c.gain) * (inner / 4)


def first_second_derivative_parts(x: Basis) -> tuple[Any, Any]:
    """The rising and the falling part of M11'', (sigma psi/Lambda)^2 and
    (sigma/Lambda)^2 psi chi, both times `first_unit`.
    """
    c, v, k, unit = Curvature(x), Curvature(x).inverse_ratio, Curvature(x).inverse_kappa, x.unit
    if x.e == 1:
        rising = (x.total / x.kappa) * (x.total * (1 + k / 2))
        inner = (x.total * (1 / unit)) * (1 + (1 + k) * (k * k / 4))
        return rising / 4, ((x.total * v) * inner) / 8
    if x.e == 0:
        lead = other = (2 + v) * (x.wider * (1 / (8 * unit)))
    else:
        other = (x.total / x.rho) / 2
        lead = other * c.gain
    return (lead * unit) * lead, (other * unit) * (c.half_total * c.bend)


def first_unit(x: Basis) -> Fraction:
    """So small that the rising part of M11'' is finite wherever the falling one is."""
    return x.unit


def turning_index(root_3: Any) -> Any:
    """The index 4/(3 + 2 sqrt(3)) at which M11 stops bending down where e = 0."""
    return 4 / (root_3 * 2 + 3)


def first_second_derivative_round_turn(x: Basis, root_3: Any) -> Any:
    """M11'' for e = 0 as a product with Lambda - 4/(3 + 2 sqrt(3)), which keeps its digits there.

    With y = rho - 1/2 it has the sign of 1 + 2y - 2y^2 = 2 (y0 - y) (y + 1/(1 + sqrt(3))), where
    y0 = (1 + sqrt(3))/2, and y (y + 1) = 2/Lambda ties y0 - y to the difference of the indices.
    """
    c = Curvature(x)
    y, v = c.half_step, c.inverse_ratio
    lead = ((x.index - turning_index(root_3)) * ((root_3 * 2 + 3) / 32)) / x.index
    wide = (2 + v) * (2 + v) * ((2 + v) / 8)
    share = (y + 1 / (1 + root_3)) / (y + (3 + root_3) / 2)
    return (lead * (x.wider * (1 / x.unit))) * (wide * share)
