"""What second derivatives of the two-state steady state by Lambda have in common.

psi = Lambda (d sigma^2/d Lambda)/sigma^2 = (kappa + e/2)/(rho kappa), the power of Lambda that the
innovation variance grows like, and chi = 1 - Lambda (d psi/d Lambda)/psi carry those of the first
entries: alpha = 1 - 1/sigma^2 and M11 = sigma^2 - 1, so that
alpha'' = -psi (psi + chi)/(sigma Lambda)^2 and M11'' = sigma^2 psi (psi - chi)/Lambda^2.
psi rises from 0 to 2, chi tends to 1/2 at one end of Lambda and to 1 at the other: the gain bends
down everywhere, M11 first down and then up. With q = kappa - e/(4 kappa) = 4/(Lambda^2 kappa),
1 - chi is q (e/(2 kappa (kappa + e/2)) + 1/(2 rho^2)).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from gainproof.derive.steady_state.forms import Basis


@dataclass(frozen=True)
class Curvature:
    """What the second derivatives of one basis share; each quantity is positive."""

    x: Basis

    @cached_property
    def inverse_ratio(self) -> Any:
        """1/rho."""
        return (2 * self.x.unit) / self.x.twice if self.x.e == 0 else self.x.unit / self.x.rho

    @cached_property
    def inverse_kappa(self) -> Any:
        """1/kappa."""
        return self.x.unit / self.x.kappa

    @property
    def square(self) -> Any:
        """rho^2, times the unit: twice that could overflow."""
        return self.x.kappa + self.x.unit * (1 + self.x.e) / 4

    @cached_property
    def ratio(self) -> Any:
        """rho."""
        return self.x.twice * (1 / (2 * self.x.unit))

    @cached_property
    def gain(self) -> Any:
        """1 + e/(2 kappa), in which psi = (1 + e/(2 kappa))/rho differs from 1/rho."""
        return 1 + self.inverse_kappa * (self.x.e / 2)

    @cached_property
    def growth(self) -> Any:
        """psi."""
        if self.x.e == 0:
            return self.inverse_ratio
        if self.x.e == 1:
            return self.x.rho / self.x.kappa
        return self.gain * self.inverse_ratio

    @cached_property
    def bend(self) -> Any:
        """chi, times `bend_weight`."""
        x, k, e, unit = self.x, self.inverse_kappa, self.x.e, self.x.unit
        if e == 0:
            return (x.kappa + unit / 2) / self.square / 2
        if e == 1:
            return (x.kappa + ((x.kappa + unit) / x.kappa) * (k * (unit / 4))) / self.square / 2
        return self.bend_sum / self.square / 2

    @property
    def bend_sum(self) -> Any:
        """2 rho^2 (1 + e/(2 kappa)) chi for 0 < e < 1, times the unit."""
        x, k, e = self.x, self.inverse_kappa, self.x.e
        last = k * (e * e * (1 + e) / 16) + e * e * 3 / 8
        return x.kappa + (k * (k * last + e / 4) + Fraction(1, 2)) * x.unit

    @property
    def bend_weight(self) -> Any:
        """1, but for 0 < e < 1 what saves a division: 1 + e/(2 kappa)."""
        return 1 if self.x.e in (0, 1) else self.gain

    @cached_property
    def fall(self) -> Any:
        """q, times the unit."""
        x = self.x
        return x.kappa if x.e == 0 else (4 * x.unit * x.unit / x.half_eta) / x.index

    @property
    def unbent(self) -> Any:
        """1 - chi."""
        x, e = self.x, self.x.e
        share = self.fall / self.square / 2
        if e == 0:
            return share
        if e == 1:
            return share * (1 + self.inverse_kappa)
        return share + (self.fall / x.kappa) * (x.unit * e / 2 / x.raised)

    @property
    def half_step(self) -> Any:
        """y = rho - 1/2, without a subtraction."""
        return (self.x.kappa + self.x.unit * self.x.e / 4) / self.x.shifted

    @property
    def half_total(self) -> Any:
        """sigma/Lambda = (1/2 + kappa + rho)/2."""
        return self.x.total * (1 / (2 * self.x.total_unit))
