"""The covariance of the observations: checked, and what makes their noise white."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from gainproof.fixed_gain.arguments import Reals, real

SYMMETRIC = 1e-12
"""How far V_ij and V_ji may be apart, over the product of both deviations."""


def whitening(covariance: ArrayLike, names: Sequence[str] = ()) -> Reals:
    """W with W V W' = I: the inverse of the Cholesky factor of V.

    The deviations are taken out first, so that V's condition is that of its correlations and not of
    its units. ValueError, with the observations' names where there are any: V not square, a
    variance not above 0, not symmetric, not positive definite.
    """
    noise = real("covariance", covariance)
    if noise.ndim != 2 or noise.shape[0] != noise.shape[1]:
        raise ValueError(f"covariance must be a square matrix, got shape {noise.shape}")
    told = [*names] if len(names) == len(noise) else [f"number {i + 1}" for i in range(len(noise))]
    for name, variance in zip(told, np.diag(noise).tolist(), strict=True):
        if not variance > 0:
            raise ValueError(f"covariance: the variance of {name} must be above 0, got {variance}")
    deviations = np.sqrt(np.diag(noise))
    correlation = noise / deviations[:, None] / deviations
    apart = np.abs(correlation - correlation.T)
    if apart.size and not apart.max() <= SYMMETRIC:
        i, j = np.unravel_index(int(np.argmax(apart)), apart.shape)
        raise ValueError(
            f"covariance must be symmetric: {told[i]} with {told[j]} has {float(noise[i, j])!s}, "
            f"{told[j]} with {told[i]} {float(noise[j, i])!s}"
        )
    correlation = (correlation + correlation.T) / 2
    # Cholesky alone would take a singular matrix for definite where rounding makes it so
    least = float(np.linalg.eigvalsh(correlation)[0]) if correlation.size else 1.0
    if not least > len(noise) * 8 * np.finfo(np.float64).eps:
        raise ValueError(
            "covariance must be positive definite: the least eigenvalue of its correlations is "
            f"{least:.3g}"
        )
    factor = np.linalg.cholesky(correlation)
    return np.asarray(np.linalg.inv(factor) / deviations)


def diagonal(deviations: ArrayLike, correlations: ArrayLike | None = None) -> Reals:
    """V of independent stations: deviations (2n) of n ranges and then n range rates.

    correlations (n): between range and range rate of each station; none where it is left out.
    """
    sigma = real("deviations", deviations)
    noise = np.diag(np.square(sigma))
    if correlations is not None:
        rho = real("correlations", correlations)
        half = len(sigma) // 2
        for i, share in enumerate(rho.tolist()):
            noise[i, half + i] = noise[half + i, i] = share * sigma[i] * sigma[half + i]
    return np.asarray(noise)
