"""Alpha-beta filters: variances, lags and poles of any stable gains, arrays of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.kernel_reach import gap, put_together, require_reach, within
from gainproof.fixed_gain.stability import CONDITIONS, moderate, stable_gains
from gainproof.generated import alpha_beta
from gainproof.generated.alpha_beta import Lags, Variances

MARGIN = CONDITIONS[2][2]


def variances(alpha: ArrayLike, beta: ArrayLike) -> Variances:
    """Steady covariances under measurement noise alone, over its variance B; velocities times T.

    alpha, beta: numbers or arrays, broadcast together. Within the domain of the kernel
    (alpha < 1, beta < 2) with its proved bounds; other stable gains through their coordinates
    2 alpha/beta and (4 - 2 alpha - beta)/beta, rounded by less than 4 * 2^-52 of themselves.

    ValueError for gains outside the stability region: which inequality, its values, the first
    place; and for NaN, infinity and shapes that do not fit. TypeError for no real number.
    """
    gains = stable_gains(alpha, beta)
    fine = within(alpha_beta._VARIANCES, gains)
    return Variances(*put_together(fine, gains, alpha_beta.variances, _beyond))


def _beyond(alpha: Reals, beta: Reals) -> Variances:
    given = 2 * (alpha / beta), gap(MARGIN, (alpha, beta)) / beta
    require_reach(alpha_beta._VARIANCES_OF_COORDINATES, given, (alpha, beta))
    return Variances(*alpha_beta.variances_of_coordinates(*given))


def lags(alpha: ArrayLike, beta: ArrayLike) -> Lags:
    """Steady errors behind a constant acceleration a, over a T^2 (positions) and a T (velocities).

    Arguments and errors as `variances`; beyond the kernel's domain each is two roundings off.
    A lag beyond float64 comes as infinity.
    """
    gains = stable_gains(alpha, beta)
    fine = within(alpha_beta._LAGS, gains)
    return Lags(*put_together(fine, gains, alpha_beta.lags, _lags_beyond))


def _lags_beyond(alpha: Reals, beta: Reals) -> Lags:
    ratio = alpha / beta
    return Lags(1 / beta, ratio + 0.5, (1 - alpha) / beta, ratio - 0.5)


def poles(alpha: ArrayLike, beta: ArrayLike) -> NDArray[np.complex128]:
    """Both closed-loop poles, the one of larger modulus first; complex, shape (..., 2).

    The roots of z^2 - (2 - alpha - beta) z + 1 - alpha. Any gains up to 1e100 in magnitude: what
    is not stable has poles, too. A pole is rounded by some 2^-52 of 1 + (alpha + beta)/2, and where
    both nearly agree by the root of that.
    """
    gains = moderate((alpha, beta))
    fine = within(alpha_beta._CLOSED_LOOP_POLES, gains)
    both = put_together(fine, gains, _parts, _parts_beyond)
    half_sum, discriminant = (np.asarray(each) for each in both)
    root = np.sqrt(np.abs(discriminant))
    turned = np.where(discriminant >= 0, np.copysign(root, half_sum), 1j * root)
    found = np.stack([half_sum + turned, half_sum - turned], axis=-1)
    return np.asarray(found, np.complex128)


def _parts(alpha: Reals, beta: Reals) -> tuple[Reals, Reals]:
    found = alpha_beta.closed_loop_poles(alpha, beta)
    parts = found.half_sum, found.quarter_discriminant
    return np.asarray(parts[0], np.float64), np.asarray(parts[1], np.float64)


def _parts_beyond(alpha: Reals, beta: Reals) -> tuple[Reals, Reals]:
    half = (alpha + beta) / 2
    return 1 - half, half * half - beta
