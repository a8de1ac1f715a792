"""How often covariances of conversions are positive definite as computed, by exact determinants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from converted_truth import NAMES
from numpy.typing import NDArray

from gainproof.generated import converted_measurements

Floats = NDArray[np.float64]
Entries = tuple[Floats, Floats, Floats]
SPLITTER = 2.0**27 + 1


@dataclass(frozen=True)
class Definite:
    """Shares of inputs at which a covariance is positive definite: as its paper prints it, and the
    kernel's entries; and where the kernel's variances along and across are both above 0.
    """

    name: str
    printed: float
    kernel: float
    axes: float


def definite(count: int, seed: int) -> list[Definite]:
    """Of random measurements in float64, log-uniform: ranges from 10 m to a million kilometres,
    deviations from 1 mm to 1 km and from 1e-8 to 1 rad.
    """
    given = _measurements(np.random.default_rng(seed), count)
    found = []
    for name in NAMES:
        made = getattr(converted_measurements, f"{name}_conversion_in_plane")(*given)
        entries = made.covariance_xx, made.covariance_xy, made.covariance_yy
        axes = (made.radial_variance > 0) & (made.cross_variance > 0)
        found.append(
            Definite(
                name,
                float(is_definite(PRINTED[name](*given)).mean()),
                float(is_definite(entries).mean()),
                float(axes.mean()),
            )
        )
    return found


def definite_correlated(count: int, seed: int) -> dict[str, float]:
    """The same shares of the kernels for correlated noises, at correlations from -1 to 1."""
    generator = np.random.default_rng(seed)
    given = *_measurements(generator, count), generator.uniform(-1, 1, count)
    found = {}
    for name in ("correlated_unbiased", "correlated_modified_unbiased"):
        made = getattr(converted_measurements, f"{name}_conversion_in_plane")(*given)
        entries = made.covariance_xx, made.covariance_xy, made.covariance_yy
        found[name] = float(is_definite(entries).mean())
    return found


def _measurements(generator: np.random.Generator, count: int) -> tuple[Floats, ...]:
    def spread(low: float, high: float) -> Floats:
        drawn: Floats = np.exp(generator.uniform(np.log(low), np.log(high), count))
        return drawn

    range_, azimuth = spread(10, 1e9), generator.uniform(-np.pi, np.pi, count)
    return range_, azimuth, spread(1e-3, 1e3), spread(1e-8, 1)


def is_definite(entries: Entries) -> NDArray[np.bool_]:
    """Whether xx > 0 and xx yy > xy^2, the products exact as sums of two floats."""
    xx, xy, yy = entries
    (p, q), (s, t) = _exact(xx, yy), _exact(xy, xy)
    sign: NDArray[np.bool_] = (p - s) + (q - t) > 0
    return sign & (xx > 0)


def _exact(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """A product and its rounding error (Dekker)."""
    product = a * b
    (a1, a2), (b1, b2) = _halves(a), _halves(b)
    return product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2


def _halves(a: Floats) -> tuple[Floats, Floats]:
    big = SPLITTER * a
    high = big - (big - a)
    return high, a - high


def _classical(r: Floats, a: Floats, sr: Floats, sa: Floats) -> Entries:
    c, s = np.cos(a), np.sin(a)
    return (
        r**2 * sa**2 * s**2 + sr**2 * c**2,
        (sr**2 - r**2 * sa**2) * s * c,
        r**2 * sa**2 * c**2 + sr**2 * s**2,
    )


def _debiased(r: Floats, a: Floats, sr: Floats, sa: Floats) -> Entries:
    """Lerro and Bar-Shalom (13a) to (13c)."""
    c, s, v = np.cos(a), np.sin(a), sa**2
    even = np.cosh(2 * v) - np.cosh(v), 2 * np.cosh(2 * v) - np.cosh(v)
    odd = np.sinh(2 * v) - np.sinh(v), 2 * np.sinh(2 * v) - np.sinh(v)
    return (
        np.exp(-2 * v)
        * (r**2 * (c**2 * even[0] + s**2 * odd[0]) + sr**2 * (c**2 * even[1] + s**2 * odd[1])),
        s * c * np.exp(-4 * v) * (sr**2 + (r**2 + sr**2) * (1 - np.exp(v))),
        np.exp(-2 * v)
        * (r**2 * (s**2 * even[0] + c**2 * odd[0]) + sr**2 * (s**2 * even[1] + c**2 * odd[1])),
    )


def _means(r: Floats, a: Floats, sr: Floats, sa: Floats, factor: Floats) -> Entries:
    """Mean squares of the true place, and `factor` times the products of the measured one."""
    c, s, k = np.cos(a), np.sin(a), np.exp(-(sa**2) / 2)
    whole = (r**2 + sr**2) / 2
    return (
        whole * (1 + k**4 * np.cos(2 * a)) + factor * r**2 * c**2,
        whole * k**4 * np.sin(2 * a) + factor * r**2 * s * c,
        whole * (1 - k**4 * np.cos(2 * a)) + factor * r**2 * s**2,
    )


def _unbiased(r: Floats, a: Floats, sr: Floats, sa: Floats) -> Entries:
    """Longbin et al. (7a) to (7c)."""
    return _means(r, a, sr, sa, np.exp(sa**2) - 2)


def _modified(r: Floats, a: Floats, sr: Floats, sa: Floats) -> Entries:
    """Duan, Han and Li; (12) to (14) of the patent."""
    return _means(r, a, sr, sa, -np.exp(-(sa**2)))


PRINTED: dict[str, Callable[[Floats, Floats, Floats, Floats], Entries]] = {
    "classical": _classical,
    "debiased": _debiased,
    "unbiased": _unbiased,
    "modified_unbiased": _modified,
}
"""As the papers print them."""
