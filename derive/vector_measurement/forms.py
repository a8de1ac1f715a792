"""The steady state in sums, products, quotients and roots of positive terms only.

Every function works on anything with the operators + * /: on SymPy symbols, where a certificate
proves the form equal to what it stands for, and on graph nodes, from which kernels are printed.

In units T = sigma_o = 1 with t = Lambda/S: sigma^2 = det(P + R)/det R; Lambda w and eta are
sigma c(1) and sigma c(-1), c being the closed-loop polynomial; their mean m is sigma + 1/sigma and
delta is sigma - 1/sigma. The cross covariances are h sigma (predicted) and h/sigma (updated), and
g = Lambda w - h. Every predicted entry becomes the updated one when sigma and 1/sigma change
places. e = noise(4)/noise(0), n = Q12/Q22, d = det Q/Q22^2 with Q in these units.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

HALF = Fraction(1, 2)


def times(number: Fraction, value: Any) -> Any:
    """number * value; a quotient by the denominator where the number is one over an integer."""
    if number == 1:
        return value
    return value / number.denominator if number.numerator == 1 else value * number


def total(*terms: Any) -> Any:
    """The sum of the terms that are there: None stands for a term that vanishes in the family."""
    first, *rest = (term for term in terms if term is not None)
    for term in rest:
        first = first + term
    return first


@dataclass(frozen=True)
class Noise:
    """The numbers of a family: e = noise(4)/noise(0) and n = Q12/Q22."""

    e: Fraction
    n: Fraction

    @property
    def first(self) -> Fraction:
        """Q11/Q22."""
        return self.n - (1 - self.e) / 4

    @property
    def determinant(self) -> Fraction:
        """d = det Q/Q22^2."""
        return self.first - self.n * self.n

    @property
    def interval(self) -> bool:
        """Whether n = 1/2: the noise acts all through the interval, and eta is a product."""
        return self.n == HALF


@dataclass(frozen=True)
class Basis:
    """Lambda and S with the three roots made from them: w (None where it is 1), eta and delta."""

    index: Any
    ratio: Any
    level: Any
    eta: Any
    delta: Any
    noise: Noise

    @property
    def velocity_index(self) -> Any:
        """t = Lambda/S, the tracking index of the measured velocity."""
        return self.index / self.ratio

    @property
    def one_end(self) -> Any:
        """Lambda w = sigma c(1)."""
        return self.index if self.level is None else self.index * self.level

    @property
    def mean(self) -> Any:
        """m = sigma + 1/sigma."""
        return (self.one_end + self.eta) / 2

    @property
    def sigma(self) -> Any:
        """sigma, the root of det(P + R)/det R."""
        return (self.mean + self.delta) / 2

    @property
    def coupling(self) -> Any:
        """kappa with h (w + kappa) = Lambda."""
        t = self.velocity_index
        share = self.eta / (t * t + 4) if self.noise.interval else self.sigma
        return (t * share) / self.ratio

    @property
    def cross(self) -> Any:
        """h, the geometric mean of both cross covariances."""
        return self.index / (self.coupling + (1 if self.level is None else self.level))

    @property
    def rest(self) -> Any:
        """g = Lambda w - h = sigma det(U)/S^2."""
        if self.level is None:
            return self.cross * self.coupling
        t = self.velocity_index
        more = times(self.noise.determinant, t * t)
        return self.cross * (more + self.level * self.coupling)


def level_squared(noise: Noise, index: Any, ratio: Any) -> Any:
    """w^2 = 1 + d t^2; None where d = 0."""
    t = index / ratio
    return times(noise.determinant, t * t) + 1 if noise.determinant else None


def eta_squared(noise: Noise, index: Any, ratio: Any) -> Any:
    """eta^2 = 16 + e Lambda^2 + 4 t^2 + d Lambda^2 t^2; for n = 1/2 a product."""
    t = index / ratio
    first = times(noise.e, index * index) + 16 if noise.e else None
    if noise.interval:
        second = t * t + 4
        return second * 4 if first is None else first * (second / 4)
    return first + (t * t) * 4


def delta_squared(noise: Noise, index: Any, ratio: Any, level: Any, eta: Any) -> Any:
    """delta^2 = m^2 - 4, without a subtraction."""
    t = index / ratio
    square = t * t
    if not noise.interval:
        return square + index * ((index + eta) / 2)
    area = index * index
    weight = area * (noise.determinant / 2) + 1 if noise.determinant else None
    return total(
        times((1 + noise.e) / 4, area),
        square if weight is None else square * weight,
        (index if level is None else index * level) * eta / 2,
    )


def _position_step(x: Basis) -> Any:
    """P11 - U11 = 2 U12 + U22 + Q11, what one interval adds to the position's variance."""
    own = times(x.noise.first, x.index * x.index) if x.noise.first else None
    return total((x.cross / x.sigma) * 2, _velocity(x), own)


def _velocity_gain(x: Basis) -> Any:
    """K22 = U22/S^2."""
    t = x.velocity_index
    if not x.noise.interval:
        return (x.delta * (x.cross / x.ratio)) / x.ratio
    return (x.rest + (t * t) / x.sigma) / x.delta


def _velocity(x: Basis) -> Any:
    """U22."""
    if not x.noise.interval:
        return x.delta * x.cross
    return (x.ratio * x.ratio) * _velocity_gain(x)


def gains(x: Basis) -> dict[str, Any]:
    """Filter gain K = U R^-1; K12 times T and K21 over T in units."""
    cross = x.cross / x.sigma
    return {
        "gain_11": _first_updated(x),
        "gain_12": (cross / x.ratio) / x.ratio,
        "gain_21": cross,
        "gain_22": _velocity_gain(x),
    }


def _first_updated(x: Basis) -> Any:
    return (x.rest + _position_step(x) / x.sigma) / x.delta


def updated_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the updated covariance in units of sigma_o^2 and T."""
    return {
        "updated_11": _first_updated(x),
        "updated_12": x.cross / x.sigma,
        "updated_22": _velocity(x),
    }


def predicted_covariance(x: Basis) -> dict[str, Any]:
    """Entries of the predicted covariance in units of sigma_o^2 and T."""
    return {
        "predicted_11": (x.rest + x.sigma * _position_step(x)) / x.delta,
        "predicted_12": x.cross * x.sigma,
        "predicted_22": x.delta * x.cross + times(1 - x.noise.n, x.index * x.index),
    }
