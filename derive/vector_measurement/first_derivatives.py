"""First derivatives of the steady state with respect to Lambda and S, in the forms of `forms`.

A perturbation of the noise moves a covariance by a sum over the closed loop L, of order two, so
that sum_k (l L^k w)(r L^k w) is a quarter wave of two points of the unit circle:
[ (l N w)(r N w)/c(-1) + (l A w)(r A w)/c(1) ] / (2 (1 - c(0))), A = adj(I - L), N = adj(I + L).
With c(1) = Lambda w/sigma, c(-1) = eta/sigma and 1 - c(0) = delta/sigma every variance becomes a
sum of two squares, and the entries of A w and N w have forms without a subtraction:
1 - K12 - (1 - n) K22 = w h/Lambda = w/(w + kappa), sigma (K22 - det K) = P22/(sigma S^2), and
P11 - n P12 is sigma delta h/Lambda for n = 0, a product over 2 w S + t m for n = 1/2.
Three outputs change their sign: the covariance of the updated state (so K21) and K12 as functions
of Lambda, K12 as a function of S; each is one difference of two positive terms.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

from gainproof.derive.vector_measurement.forms import (
    Basis,
    gains,
    predicted_covariance,
    updated_covariance,
)
from gainproof.derive.vector_measurement.process_noise import times, total


class Rates:
    """What the derivatives of one basis share; every quantity is made once, when it is asked for.

    Every property is positive on the whole domain.
    """

    def __init__(self, basis: Basis) -> None:
        self.x = basis

    @cached_property
    def sigma(self) -> Any:
        """sigma."""
        return self.x.sigma

    @cached_property
    def gain(self) -> dict[str, Any]:
        """The filter gain."""
        return gains(self.x)

    @cached_property
    def updated(self) -> dict[str, Any]:
        """The updated covariance."""
        return updated_covariance(self.x)

    @cached_property
    def predicted(self) -> dict[str, Any]:
        """The predicted covariance."""
        return predicted_covariance(self.x)

    @cached_property
    def velocity(self) -> Any:
        """P22/S^2."""
        return (self.predicted["predicted_22"] / self.x.ratio) / self.x.ratio

    @cached_property
    def rate(self) -> Any:
        """sigma K22, which for n = 1/2 has fewer roundings as g + P22/(sigma S^2)."""
        if not self.x.noise.interval:
            return self.sigma * self.gain["gain_22"]
        return self.x.rest + self.velocity / self.sigma

    @cached_property
    def slow(self) -> Any:
        """sigma (2 K22 - det K) = g + 2 P22/(sigma S^2)."""
        return self.x.rest + (self.velocity / self.sigma) * 2

    @cached_property
    def both_scaled(self) -> Any:
        """S^2 (2 w S + t m)."""
        x = self.x
        mean = (x.index * x.width + x.eta_scaled) / 2
        return (x.ratio * x.ratio) * (x.width * 2) + x.index * mean

    @cached_property
    def lead(self) -> Any:
        """P11 - n P12."""
        x = self.x
        if not x.noise.interval:
            return self.sigma * x.delta * (x.cross / x.index)
        more = None
        if x.noise.e:
            area = times(x.noise.e, x.index * x.index)
            more = x.eta_scaled * (area / (area + 16))
        inner = total(x.index * x.width + x.delta_scaled * 2, more)
        return (x.width * ((x.eta_scaled / 4) * inner)) / self.both_scaled

    @cached_property
    def lead_and_two(self) -> Any:
        """P11 - n P12 + 2."""
        x = self.x
        if not x.noise.interval:
            return self.lead + 2
        return ((x.sigma_scaled * x.width + x.index) * x.eta_scaled) / self.both_scaled

    @cached_property
    def share(self) -> Any:
        """1 - K12 - (1 - n) K22 = w h/Lambda = w/(w + kappa)."""
        return self.x.width / (self.x.coupling_scaled + self.x.width)

    @cached_property
    def turned(self) -> Any:
        """K12 + (1 - n) K22 + (1 - 2n) = 2 (1 - n) - w h/Lambda = 1 - 2n + kappa/(w + kappa)."""
        own = self.x.coupling_scaled / (self.x.coupling_scaled + self.x.width)
        return own if self.x.noise.interval else own + 1

    @cached_property
    def doubled(self) -> Any:
        """2 - K22 for n = 1/2."""
        return (self.gain["gain_12"] + self.share) * 2

    def wave(self, one: Any, minus_one: Any) -> Any:
        """one/(sigma c(1)) + minus_one/(sigma c(-1))."""
        return one / self.x.one_end + minus_one / self.x.eta

    def squares(self, one: Any, minus_one: Any) -> Any:
        """The wave of two squares."""
        return self.wave(one * one, minus_one * minus_one)
