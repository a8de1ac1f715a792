"""The two-state steady state in sums, products, quotients and roots of positive terms only.

Every function works on anything with the operators + * /: on SymPy symbols, where a certificate
proves the form equal to what it stands for, and on graph nodes, from which kernels are printed.
The order of operations is chosen so that nothing over- or underflows before the result does, and
so that few operations are needed.

kappa = sqrt(4/Lambda^2 + e/4) and rho = alpha/beta = sqrt(kappa + (1 + e)/4) carry everything:
beta = 2/(1/2 + kappa + rho), sigma = Lambda/beta is the root of the innovation variance; e =
noise(4)/noise(0), n = Q12/Q22. For e = 0 the sum is (rho + 1/2)^2, for e = 1 it is rho^2 + rho.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any


@dataclass(frozen=True)
class Basis:
    """Lambda with the positive quantities made from it, and the numbers e and n of the family.

    kappa, rho, twice = 2 rho and half_eta = Lambda kappa come multiplied by `unit` = `root`^2: 1
    for symbols, in kernels so small a power of two that kappa cannot overflow.
    """

    index: Any
    kappa: Any
    rho: Any
    twice: Any
    half_eta: Any
    e: Fraction
    n: Fraction
    unit: Fraction = Fraction(1)
    root: Fraction = Fraction(1)

    @property
    def wider(self) -> Any:
        """2 rho + 1, times the unit."""
        return self.twice + self.unit

    @property
    def shifted(self) -> Any:
        """rho + 1/2, times the unit."""
        return self.rho + self.unit / 2

    @property
    def total(self) -> Any:
        """1/2 + kappa + rho = 2 sigma/Lambda, times `total_unit`; a square for e = 0."""
        return self.wider * self.wider if self.e == 0 else self.kappa + self.shifted

    @property
    def total_unit(self) -> Fraction:
        """The number that comes with `total`."""
        return 4 * self.unit * self.unit if self.e == 0 else self.unit

    @property
    def raised(self) -> Any:
        """kappa + e/2, times the unit."""
        return self.kappa + self.unit * self.e / 2

    @property
    def share(self) -> Any:
        """beta over `share_unit`, which is so small that a small beta loses no digit."""
        return (2 * self.total_unit / self.share_unit) / self.total

    @property
    def share_unit(self) -> Fraction:
        """The unit that goes with rho, or with 2 rho for e = 0."""
        return 2 * self.unit if self.e == 0 else self.unit

    @property
    def deviation(self) -> Any:
        """sigma."""
        return (self.index * self.total) * (1 / (2 * self.total_unit))

    def inverse_deviation(self, factor: Fraction = Fraction(1)) -> Any:
        """1/sigma, times the factor."""
        return (2 * self.total_unit * factor) / (self.index * self.total)


def times(number: Fraction, value: Any) -> Any:
    """number * value; a quotient by the denominator where the number is one over an integer."""
    if number == 1:
        return value
    return value / number.denominator if number.numerator == 1 else value * number


def gains(x: Basis) -> dict[str, Any]:
    """Filter gain: position gain alpha, velocity gain beta (times 1/T in units)."""
    return {
        "alpha": x.share * (x.twice if x.e == 0 else x.rho),
        "beta": x.share * x.share_unit,
    }


def gain_derivatives(x: Basis) -> dict[str, Any]:
    """d alpha/d Lambda = (kappa + e/2)/(rho sigma^2 kappa Lambda), and
    d beta/d Lambda = (2 rho + 1)/(rho sigma^2 kappa Lambda).
    """
    if x.e == 1:
        small = x.inverse_deviation()
        square = (small * small) / x.half_eta
        return {
            "alpha": square * x.rho,
            "beta": square * (x.unit * x.unit / x.rho + 2 * x.unit),
        }
    if x.e == 0:
        small = x.inverse_deviation()
        square = (small * small) / x.twice
        return {"alpha": square * x.kappa, "beta": square * x.wider}
    small = x.inverse_deviation(x.root)
    square = ((small / x.half_eta) * small) / x.rho
    return {"alpha": square * x.raised, "beta": (square * 2) * x.shifted}


def predictor_gain_derivatives(x: Basis) -> dict[str, Any]:
    """Derivatives of the predictor gain with respect to Lambda."""
    derivative = gain_derivatives(x)
    return {
        "position": derivative["alpha"] + derivative["beta"],
        "velocity": derivative["beta"],
    }
