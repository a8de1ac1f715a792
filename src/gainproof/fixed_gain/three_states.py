"""Alpha-beta-gamma filters: variances, lags and poles of any stable gains, arrays of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.kernel_reach import gap, put_together, require_reach, within
from gainproof.fixed_gain.pole_discs import pole_discs
from gainproof.fixed_gain.stability import CONDITIONS, stable_gains
from gainproof.generated import alpha_beta_gamma
from gainproof.generated.alpha_beta_gamma import Lags, Variances

MARGIN, DETERMINANT = CONDITIONS[3][2], CONDITIONS[3][4]
FAR = 0.75
"""Share of the largest stable gamma up to which its rounding is no matter for what is left to 1."""


def variances(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Variances:
    """Steady covariances under measurement noise alone, over its variance B; velocities times T,
    accelerations times T^2.

    alpha, beta, gamma: numbers or arrays, broadcast together. Within the domain of the kernel
    (alpha < 1, beta < 2) and up to 3/4 of the largest stable gamma by its bounds for a gamma that
    is off by no more than 4 * 2^-52 of itself; other stable gains through their coordinates, which
    are taken from the gains without loss, where these are not too small for it.

    ValueError for gains outside the stability region: which inequality, its values, the first
    place; and for NaN, infinity and shapes that do not fit. TypeError for no real number.
    """
    gains = stable_gains(alpha, beta, gamma)
    shared = _shared(*gains)
    fine = within(alpha_beta_gamma._VARIANCES, shared)
    fine &= (shared[2] <= FAR) | _without_coordinates(*gains)
    return Variances(*put_together(fine, gains, _inside, _beyond))


def _shared(alpha: Reals, beta: Reals, gamma: Reals) -> tuple[Reals, Reals, Reals]:
    """alpha, beta and gamma over the largest stable one."""
    with np.errstate(over="ignore", under="ignore"):
        return alpha, beta, (gamma / alpha) * ((1 - alpha / 2) / beta)


def _without_coordinates(alpha: Reals, beta: Reals, gamma: Reals) -> NDArray[np.bool_]:
    """Where gains are so small that a coordinate may be larger than its kernels take."""
    with np.errstate(over="ignore"):
        sizes = 2 * (beta / gamma), 8 / gamma, 8 * (alpha / gamma) * (beta / gamma)
    most = alpha_beta_gamma._VARIANCES_OF_COORDINATES.inputs[0].double[1]
    return np.asarray(np.logical_or.reduce([size > most for size in sizes]), np.bool_)


def _inside(*gains: Reals) -> Variances:
    return alpha_beta_gamma.variances(*_shared(*gains))


def _beyond(*gains: Reals) -> Variances:
    alpha, beta, gamma = gains
    given = (
        2 * (beta / gamma),
        2 * (gap(MARGIN, gains) / gamma),
        8 * (gap(DETERMINANT, gains) / gamma / gamma),
    )
    require_reach(alpha_beta_gamma._VARIANCES_OF_COORDINATES, given, gains)
    p = alpha_beta_gamma.variances_of_coordinates(*given)
    q = alpha_beta_gamma.updated_variances_of_coordinates(*given)
    first = (1 - alpha) ** 2 * np.asarray(p.predicted_11) + alpha**2
    # a difference of gains, not of their coordinates: 1 + y - x is 2 (2 alpha - beta)/gamma
    second = q.updated_23 * ((2 * alpha - beta) / (2 * gamma))
    return Variances(*p, first, second, q.updated_13, q.updated_22, q.updated_23)


def lags(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Lags:
    """Steady errors behind a constant jerk j, over j T^3 (positions), j T^2 and j T.

    Arguments and errors as `variances`; beyond the kernel's domain each is a few roundings off.
    """
    gains = stable_gains(alpha, beta, gamma)
    fine = within(alpha_beta_gamma._LAGS, _shared(*gains))
    return Lags(*put_together(fine, gains, _lags_inside, _lags_beyond))


def _lags_inside(*gains: Reals) -> Lags:
    return alpha_beta_gamma.lags(*_shared(*gains))


def _lags_beyond(alpha: Reals, beta: Reals, gamma: Reals) -> Lags:
    first, second = alpha / gamma + 1 / 12, beta / gamma / 2
    return Lags(
        1 / gamma,
        first + second,
        2 * second + 0.5,
        (1 - alpha) / gamma,
        first - second,
        2 * second - 0.5,
    )


def poles(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> NDArray[np.complex128]:
    """The three closed-loop poles, that of largest modulus first; complex, shape (..., 3).

    Any gains up to 1e100 in magnitude, stable or not. `pole_discs` gives them with a proved radius
    each: half a unit in the last place where poles are apart, more where they nearly agree.
    """
    return pole_discs(alpha, beta, gamma).poles
