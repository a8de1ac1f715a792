"""Second derivatives of the two-state gains by Lambda, in the forms of `forms`; see `curvature`."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.derive.steady_state.curvature import Curvature
from gainproof.derive.steady_state.forms import Basis


def falling_gain_slopes(x: Basis) -> dict[str, Any]:
    """The negatives of the second derivatives of alpha and beta."""
    c = Curvature(x)
    small = x.inverse_deviation()
    share = small / x.index
    if x.e == 0:
        second = (small * (x.kappa / x.twice)) * (small * (_beta_bend(c) / 16))
    else:
        other = (small * x.unit) / x.half_eta
        second = other * (other * _beta_bend(c))
    if x.e in (0, 1):
        first = (c.growth * share) * ((c.growth + c.bend) * share)
    else:
        own = (share * x.unit) / x.rho
        first = own * (own * _alpha_bend(c))
    return {"alpha": first, "beta": second}


def _alpha_bend(c: Curvature) -> Any:
    """rho^2 psi (psi + chi), for 0 < e < 1."""
    return c.gain * c.gain + c.inverse_ratio * (c.bend_sum * (1 / (2 * c.x.unit)))


def _beta_bend(c: Curvature) -> Any:
    """-beta'' (kappa sigma Lambda)^2, for e = 0 times 16 rho^2/kappa; it is E/rho with
    E = (2 rho + 1) e/(4 kappa)
    + (3 kappa^2 + (1 + 3e) kappa + e (3 + 2e)/4 + 2 rho (kappa + e/2))/(2 rho^2).
    """
    x, e, unit = c.x, c.x.e, c.x.unit
    v, k = c.inverse_ratio, c.inverse_kappa
    if e == 0:
        return (2 + v) * (6 + v)
    if e == 1:
        return (c.ratio * 3 + v) / 2 + (1 + (1 + v / 2) * (k / 2))
    lead = (x.kappa + (k * (e * (3 + 2 * e) / 12) + (1 + 3 * e) / 3) * unit) / x.rho
    inner = (lead * Fraction(3, 2) + c.gain) / (1 + k * ((1 + e) / 4))
    return inner + (2 + v) * (k * (e / 4))


def _falling_predictor_slope(x: Basis) -> Any:
    """The sum of both; for 0 < e < 1 with one factor before it, as one of them may be subnormal."""
    falling = falling_gain_slopes(x)
    if x.e in (0, 1):
        return falling["alpha"] + falling["beta"]
    c = Curvature(x)
    share = x.inverse_deviation() / x.index
    k, v = c.inverse_kappa, c.inverse_ratio
    inner = v * (v * _alpha_bend(c)) + k * (k * _beta_bend(c))
    return share * (share * inner)


def gain_second_derivatives(x: Basis) -> dict[str, Any]:
    """Second derivatives of the filter gain with respect to Lambda, both negative."""
    return {name: -value for name, value in falling_gain_slopes(x).items()}


def predictor_gain_second_derivatives(x: Basis) -> dict[str, Any]:
    """Second derivatives of the predictor gain, both negative."""
    falling = falling_gain_slopes(x)
    return {"position": -_falling_predictor_slope(x), "velocity": -falling["beta"]}
