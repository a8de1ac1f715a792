"""Covariances of the two-state steady state and their derivatives, in the forms of `forms`.

With y = rho - n: the updated velocity variance is Lambda^2 y, the innovation's deviation
sigma = Lambda (1/2 + kappa + rho)/2. For n = 1/2, y = (kappa + e/4)/(rho + 1/2).
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.steady_state.forms import Basis, gain_derivatives, gains, times


def _mixed(x: Basis, first: Any, second: Any) -> Any:
    """(1 - 2n) first + 2n second, the covariance being linear in n."""
    weight = 2 * x.n
    if weight == 0:
        return first(x)
    if weight == 1:
        return second(x)
    return times(1 - weight, first(x)) + times(weight, second(x))


def _position(x: Basis) -> Any:
    """Lambda rho = sigma - 1/sigma."""
    if x.e == 0:
        return (x.index * x.twice) * (1 / (2 * x.unit))
    return (x.index * x.rho) * (1 / x.unit)


def _half_step(x: Basis) -> Any:
    """Rho - 1/2, without a subtraction."""
    return (x.kappa + x.unit * x.e / 4) / x.shifted


def _with_independent_noise(x: Basis) -> Any:
    return x.index * _position(x)


def _with_interval_noise(x: Basis) -> Any:
    if x.e == 0:
        return x.index * ((4 * x.unit) / x.wider)
    return x.index * (x.index * _half_step(x))


def updated_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the updated covariance in units of sigma_v^2 and T."""
    gain = gains(x)
    rate = _mixed(x, _with_independent_noise, _with_interval_noise)
    return {"updated_11": gain["alpha"], "updated_12": gain["beta"], "updated_22": rate}


def predicted_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the predicted covariance in units of sigma_v^2 and T."""
    rate = _mixed(x, _with_independent_noise, _with_interval_noise)
    return {
        "predicted_11": x.deviation * _position(x),
        "predicted_12": x.index * x.deviation,
        "predicted_22": rate + x.index * x.index,
    }


def _growth(x: Basis) -> Any:
    """1 + e/(2 kappa); for e = 0, where it is 1, kappa could be 0 in both."""
    return x.raised / x.kappa


def _rate_with_independent_noise(x: Basis) -> Any:
    """Lambda (rho + (1 + e/(2 kappa)) (1/2 + kappa)/(2 rho))."""
    part = (x.kappa + x.unit / 2) / x.rho
    if x.e != 0:
        part = part * _growth(x)
    return x.index * (x.rho * (1 / x.unit) + part / 2)


def _rate_with_interval_noise(x: Basis) -> Any:
    """Lambda (y + (y^2 + e/4 + e/(4 kappa))/(2 rho)) with y = rho - 1/2."""
    if x.e == 0:
        return ((4 * x.unit) / x.wider) * (1 + (x.kappa / x.wider) * ((2 * x.unit) / x.twice))
    step = _half_step(x)
    first = (x.index * step) * (1 + (step * (x.unit / 2)) / x.rho)
    second = ((x.kappa + x.unit) / x.kappa) * ((x.unit * x.e / 8) / x.rho)
    return first + x.index * second


def updated_covariance_derivatives(x: Basis) -> dict[str, Any]:
    """Derivatives of the updated covariance with respect to Lambda."""
    derivative = gain_derivatives(x)
    rate = _mixed(x, _rate_with_independent_noise, _rate_with_interval_noise)
    return {
        "updated_11": derivative["alpha"],
        "updated_12": derivative["beta"],
        "updated_22": rate,
    }


def predicted_covariance_derivatives(x: Basis) -> dict[str, Any]:
    """Derivatives of the predicted covariance with respect to Lambda."""
    rate = _mixed(x, _rate_with_independent_noise, _rate_with_interval_noise)
    if x.e == 0:
        second = x.deviation * (x.wider / x.twice)
        first = second * (x.wider * (1 / (4 * x.unit)))
    else:
        growth = _growth(x)
        first = x.deviation * (growth * ((x.total / x.rho) / 2))
        second = x.deviation * (1 + growth * ((x.unit / 2) / x.rho))
    return {
        "predicted_11": first,
        "predicted_12": second,
        "predicted_22": rate + x.index * 2,
    }
