"""The steady state in sums, products, quotients and roots of positive terms only.

Every function works on anything with the operators + * /: on SymPy symbols, where a certificate
proves the form equal to what it stands for, and on graph nodes, from which kernels are printed.

In units T = sigma_o = 1 with t = Lambda/S: sigma^2 = det(P + R)/det R; Lambda w and eta are
sigma c(1) and sigma c(-1), c being the closed-loop polynomial; their mean m is sigma + 1/sigma and
delta is sigma - 1/sigma. The cross covariances are h sigma (predicted) and h/sigma (updated), and
g = Lambda w - h. Every predicted entry becomes the updated one when sigma and 1/sigma change
places. e = noise(4)/noise(0), n = Q12/Q22, d = det Q/Q22^2 with Q in these units.

Computed are the products with S: S w, S eta and S delta stay finite where w, eta and delta do not,
so that squares over- or underflow only far outside the range of any radar.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gainproof.derive.vector_measurement.process_noise import Noise, times, total


@dataclass(frozen=True)
class Basis:
    """Lambda and S with the three roots made from them, times S.

    level_scaled: S w, None where w is 1. eta_scaled, delta_scaled: S eta, S delta.
    """

    index: Any
    ratio: Any
    level_scaled: Any
    eta_scaled: Any
    delta_scaled: Any
    noise: Noise

    @property
    def level(self) -> Any:
        """w; None where it is 1."""
        return None if self.level_scaled is None else self.level_scaled / self.ratio

    @property
    def eta(self) -> Any:
        """eta = sigma c(-1)."""
        return self.eta_scaled / self.ratio

    @property
    def delta(self) -> Any:
        """delta = sigma - 1/sigma."""
        return self.delta_scaled / self.ratio

    @property
    def width(self) -> Any:
        """S w."""
        return self.ratio if self.level_scaled is None else self.level_scaled

    @property
    def velocity_index(self) -> Any:
        """t = Lambda/S, the tracking index of the measured velocity."""
        return self.index / self.ratio

    @property
    def one_end(self) -> Any:
        """Lambda w = sigma c(1)."""
        return self.index if self.level_scaled is None else self.index * self.level

    @property
    def mean(self) -> Any:
        """m = sigma + 1/sigma."""
        return (self.one_end + self.eta) / 2

    @property
    def sigma_scaled(self) -> Any:
        """S sigma."""
        return ((self.index * self.width + self.eta_scaled) / 2 + self.delta_scaled) / 2

    @property
    def sigma(self) -> Any:
        """sigma, the root of det(P + R)/det R."""
        return self.sigma_scaled / self.ratio

    @property
    def coupling_scaled(self) -> Any:
        """S kappa."""
        if self.noise.interval:
            square = self.index * self.index + (self.ratio * self.ratio) * 4
            return (self.index * self.eta_scaled) / square
        return ((self.index * self.sigma_scaled) / self.ratio) / self.ratio

    @property
    def cross_share(self) -> Any:
        """h/S."""
        return self.index / (self.coupling_scaled + self.width)

    @property
    def cross(self) -> Any:
        """h, the geometric mean of both cross covariances."""
        return self.cross_share * self.ratio

    @property
    def rest_scaled(self) -> Any:
        """S g."""
        product = self.width * self.coupling_scaled
        if self.level_scaled is not None:
            product = times(self.noise.determinant, self.index * self.index) + product
        return self.cross_share * product

    @property
    def rest(self) -> Any:
        """g = Lambda w - h = sigma det(U)/S^2."""
        return self.rest_scaled / self.ratio


def _position_step(x: Basis) -> Any:
    """P11 - U11 = 2 U12 + U22 + Q11, what one interval adds to the position's variance."""
    own = times(x.noise.first, x.index * x.index) if x.noise.first else None
    return total(_cross(x) * 2, _velocity(x), own)


def _cross(x: Basis) -> Any:
    """U12 = h/sigma."""
    return (x.cross_share / x.sigma_scaled) * (x.ratio * x.ratio)


def _velocity_gain(x: Basis) -> Any:
    """K22 = U22/S^2."""
    if not x.noise.interval:
        return ((x.delta_scaled * x.cross_share) / x.ratio) / x.ratio
    return (x.rest_scaled + (x.index * x.index) / x.sigma_scaled) / x.delta_scaled


def _velocity(x: Basis) -> Any:
    """U22."""
    if not x.noise.interval:
        return x.delta_scaled * x.cross_share
    return (x.ratio * x.ratio) * _velocity_gain(x)


def _first_updated(x: Basis) -> Any:
    step = (x.ratio * x.ratio) * (_position_step(x) / x.sigma_scaled)
    return (x.rest_scaled + step) / x.delta_scaled


def gains(x: Basis) -> dict[str, Any]:
    """Filter gain K = U R^-1; K12 times T and K21 over T in units.

    The position's own gain comes from det K = g/sigma and the other three, which takes fewer
    roundings than what one interval adds to its variance.
    """
    slope, cross, velocity = x.cross_share / x.sigma_scaled, _cross(x), _velocity_gain(x)
    determinant = x.rest_scaled / x.sigma_scaled
    return {
        "gain_11": (determinant + cross * slope) / velocity,
        "gain_12": slope,
        "gain_21": cross,
        "gain_22": velocity,
    }


def updated_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the updated covariance in units of sigma_o^2 and T."""
    return {
        "updated_11": _first_updated(x),
        "updated_12": _cross(x),
        "updated_22": _velocity(x),
    }


def predicted_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the predicted covariance in units of sigma_o^2 and T."""
    return {
        "predicted_11": (x.rest_scaled + x.sigma_scaled * _position_step(x)) / x.delta_scaled,
        "predicted_12": x.cross_share * x.sigma_scaled,
        "predicted_22": x.delta_scaled * x.cross_share + times(1 - x.noise.n, x.index * x.index),
    }
