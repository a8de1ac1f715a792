"""The two-state steady state in sums, products, quotients and roots of positive terms only.

Every function works on anything with the operators + * /: on SymPy symbols, where a certificate
proves the form equal to what it stands for, and on graph nodes, from which kernels are printed.
The order of operations is chosen so that nothing over- or underflows before the result does, and
so that few operations are needed, divisions least of all.

p = sqrt(Lambda), h = sqrt(4/Lambda + e Lambda/4), s = sqrt(p((1 + e)p + 4h))/2, m = p/2 + h + s,
sigma = p m/2 is the root of the innovation variance; e = noise(4)/noise(0), n = Q12/Q22.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

QUARTER = Fraction(1, 4)


@dataclass(frozen=True)
class Basis:
    """Lambda with the positive quantities made from it, and the numbers e and n of the family."""

    index: Any
    p: Any
    half: Any
    h: Any
    s: Any
    e: Fraction
    n: Fraction

    @property
    def twice(self) -> Any:
        """2 s."""
        return self.s * 2

    @property
    def ends(self) -> Any:
        """p/2 + h."""
        return self.half + self.h

    @property
    def m(self) -> Any:
        """p/2 + h + s."""
        return self.ends + self.s

    @property
    def deviation(self) -> Any:
        """sigma, the standard deviation of the innovation over that of the measurement."""
        return self.half * self.m

    @property
    def inverse_deviation(self) -> Any:
        """1/sigma."""
        return (2 / self.m) / self.p

    @property
    def raised(self) -> Any:
        """h + e p/2, the numerator of 1 + e p/(2 h), which every derivative contains."""
        if self.e == 1:
            return self.ends
        return self.h if self.e == 0 else self.h + times(self.e / 2, self.p)


def times(number: Fraction, value: Any) -> Any:
    """number * value; a quotient by the denominator where the number is one over an integer."""
    if number == 1:
        return value
    return value / number.denominator if number.numerator == 1 else value * number


def gains(x: Basis) -> dict[str, Any]:
    """Filter gain: position gain alpha, velocity gain beta (times 1/T in units)."""
    share = 2 / x.m
    return {"alpha": x.s * share, "beta": x.p * share}


def predictor_gains(x: Basis) -> dict[str, Any]:
    """Predictor gain F K."""
    return {"position": (x.s + x.p) * (2 / x.m), "velocity": x.p * (2 / x.m)}


def _with_independent_noise(x: Basis) -> Any:
    return x.index * (x.p * x.s)


def _with_interval_noise(x: Basis) -> Any:
    if x.e == 0:
        return x.index * ((x.p * 4) / (x.twice + x.p))
    inner = x.p * (x.raised + x.h)
    return x.index * ((x.p / (x.twice + x.p)) * inner)


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
        "predicted_11": x.deviation * (x.p * x.s),
        "predicted_12": x.index * x.deviation,
        "predicted_22": rate + x.index * x.index,
    }


def gain_derivatives(x: Basis) -> dict[str, Any]:
    """d alpha/d Lambda and d beta/d Lambda."""
    if x.e == 0:  # h = 2/p saves divisions
        doubled = x.h * (2 / x.m)  # 2/sigma
        square, share = doubled * doubled, Fraction(1, 8) / x.s
        return {"alpha": (x.h * share) * square, "beta": (x.p * share + QUARTER) * square}
    square = x.inverse_deviation * x.inverse_deviation
    share = 1 / ((x.p * x.s) * x.h)
    return {"alpha": (share * x.raised) * square, "beta": (share * (x.twice + x.p)) * square}


def predictor_gain_derivatives(x: Basis) -> dict[str, Any]:
    """Derivatives of the predictor gain with respect to Lambda."""
    derivative = gain_derivatives(x)
    return {
        "position": derivative["alpha"] + derivative["beta"],
        "velocity": derivative["beta"],
    }


def _rate_with_independent_noise(x: Basis) -> Any:
    return x.index * (x.s / x.p) + (x.raised / x.h) * (x.index * (x.ends / x.twice))


def _rate_with_interval_noise(x: Basis) -> Any:
    start = (4 / x.m) / x.s
    if x.e == 0:
        return start + (x.index * (x.h / x.s)) / 2
    end = (x.raised / x.h) * (x.raised / x.twice)
    if x.e != 1:
        end = end + times(x.e * (1 - x.e) / 8, (x.p / x.h) * (x.p / x.s))
    return start + x.index * end


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
    first = (x.m / 2) * (x.deviation / x.s)
    second = 1 + x.p / x.twice
    if x.e != 0:
        growth = x.raised / x.h
        first, second = growth * first, 1 + growth * (x.p / x.twice)
    return {
        "predicted_11": first,
        "predicted_12": x.deviation * second,
        "predicted_22": rate + x.index * 2,
    }
