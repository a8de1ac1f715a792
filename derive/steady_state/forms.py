"""The two-state steady state in sums, products, quotients and roots of positive terms only.

Every function works on anything with the operators + * /: on SymPy symbols, where a certificate
proves the form equal to what it stands for, and on graph nodes, from which kernels are printed.
The order of operations is chosen so that nothing over- or underflows before the result does.

p = sqrt(Lambda), h = sqrt(16/Lambda + e Lambda), s = sqrt(p((1 + e)p + 2h))/2, m = (p + h)/2 + s,
sigma = p m/2 is the root of the innovation variance; e = noise(4)/noise(0), n = Q12/Q22.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any


@dataclass(frozen=True)
class Basis:
    """Lambda with the positive quantities made from it, and the numbers e and n of the family."""

    index: Any
    p: Any
    h: Any
    s: Any
    m: Any
    e: Fraction
    n: Fraction

    @property
    def deviation(self) -> Any:
        """sigma, the standard deviation of the innovation over that of the measurement."""
        return (self.p / 2) * self.m

    @property
    def growth(self) -> Any:
        """1 + e p/h, which every derivative contains."""
        return 1 if self.e == 0 else 1 + times(self.e, self.p / self.h)


def times(number: Fraction, value: Any) -> Any:
    """number * value with one rounding: a product by the numerator, a quotient by the rest."""
    top = value if number.numerator == 1 else value * number.numerator
    return top if number.denominator == 1 else top / number.denominator


def gains(x: Basis) -> dict[str, Any]:
    """Filter gain: position gain alpha, velocity gain beta (times 1/T in units)."""
    return {"alpha": (2 * x.s) / x.m, "beta": (2 * x.p) / x.m}


def predictor_gains(x: Basis) -> dict[str, Any]:
    """Predictor gain F K."""
    return {"position": (2 * (x.s + x.p)) / x.m, "velocity": (2 * x.p) / x.m}


def _with_independent_noise(x: Basis) -> Any:
    return x.index * (x.p * x.s)


def _with_interval_noise(x: Basis) -> Any:
    inner = (2 * (x.p * x.h)) / 2 if x.e == 0 else (times(x.e, x.p * x.p) + 2 * (x.p * x.h)) / 2
    return x.index * ((x.p / (2 * x.s + x.p)) * inner)


def _mixed(x: Basis, first: Any, second: Any) -> Any:
    """(1 - 2n) first + 2n second, the covariance being linear in n."""
    weight = 2 * x.n
    if weight == 0:
        return first(x)
    if weight == 1:
        return second(x)
    return times(1 - weight, first(x)) + times(weight, second(x))


def updated_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the updated covariance in units of sigma_v^2 and T."""
    gain = gains(x)
    rate = _mixed(x, _with_independent_noise, _with_interval_noise)
    return {"updated_11": gain["alpha"], "updated_12": gain["beta"], "updated_22": rate}


def predicted_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the predicted covariance in units of sigma_v^2 and T."""
    rate = _mixed(x, _with_independent_noise, _with_interval_noise)
    return {
        "predicted_11": (x.index * x.m) * (x.s / 2),
        "predicted_12": x.index * x.deviation,
        "predicted_22": rate + x.index * x.index,
    }


def gain_derivatives(x: Basis) -> dict[str, Any]:
    """d alpha/d Lambda and d beta/d Lambda."""
    square = x.deviation * x.deviation
    return {
        "alpha": (x.growth / (x.p * x.s)) / square,
        "beta": (2 * (2 + x.p / x.s) / (x.h * x.p)) / square,
    }


def predictor_gain_derivatives(x: Basis) -> dict[str, Any]:
    """Derivatives of the predictor gain with respect to Lambda."""
    derivative = gain_derivatives(x)
    return {
        "position": derivative["alpha"] + derivative["beta"],
        "velocity": derivative["beta"],
    }


def _rate_with_independent_noise(x: Basis) -> Any:
    return x.index * (x.s / x.p) + x.growth * (x.index * ((x.p + x.h) / (4 * x.s)))


def _rate_with_interval_noise(x: Basis) -> Any:
    start = (4 / x.m) / x.s
    if x.e == 0:
        return start + (x.index * (x.h / x.s)) / 4
    end = x.growth * ((x.h + times(x.e, x.p)) / x.s)
    if x.e != 1:
        end = end + times(x.e * (1 - x.e), (x.p / x.h) * (x.p / x.s))
    return start + x.index * (end / 4)


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
    return {
        "predicted_11": x.growth * ((x.m / 2) * (x.deviation / x.s)),
        "predicted_12": x.deviation * (1 + (x.growth * (x.p / x.s)) / 2),
        "predicted_22": rate + 2 * x.index,
    }
