"""How fast the gains of three states come to their steady state, at equal intervals."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.time_varying.covariance import Reals
from gainproof.time_varying.process_noise import Noise
from gainproof.time_varying.settling import last_outside, least_run
from gainproof.time_varying.three_states.covariance import Factors
from gainproof.time_varying.three_states.process_noise import DEFAULT, noise_called
from gainproof.time_varying.three_states.track import start, step

# H (z I - F)^-1 at z = -1, half the sampling frequency
FASTEST = np.array([-0.5, 0.25, 0.0])


def error_ratio(tracking_index: ArrayLike, process_noise: str = DEFAULT) -> np.float64 | Reals:
    """|z|^2, the largest closed-loop pole squared: in the long run the covariance's distance from
    the steady state shrinks by this from one sample to the next.

    For a start above the steady state the derivation recursion-three-states proves that
    P_k - P <= A^k (P_0 - P) (A^k)' with the steady closed loop A; for any other start the same is
    observed. Where |z| rounds to 1, so does the ratio. Next to an index at which two poles meet and
    are the largest, half of the digits are right, as the ratio itself bends sharply there.
    """
    poles = _hurwitz_roots(noise_called(process_noise), np.asarray(tracking_index, np.float64))
    least = np.maximum(-poles.real, 0.0)
    near, far = (1 - least) ** 2 + poles.imag**2, (1 + least) ** 2 + poles.imag**2
    return np.asarray(np.max(near / far, axis=-1))[()]


def _hurwitz_roots(noise: Noise, index: Reals) -> NDArray[np.complex128]:
    """(z + 1)/(z - 1) for the poles z, along the last axis: they lie left of zero.

    They solve x^3 + xi x^2 + eta x + delta = 0 with the xi, eta and delta of the derivations of the
    four steady states (steps on the ratios of gains and on the three equations): xi = 2 beta/gamma,
    eta = 4 alpha/gamma - 1, and delta^2 = 64 (1/Lambda^2 + h Q h') with h = H (z I - F)^-1 at
    z = -1. So poles that crowd at z = 1 are told apart.
    """
    alpha, beta, gamma = (np.asarray(x) for x in noise.steady.gains(index))
    with np.errstate(over="ignore"):
        last = np.hypot(8 / index, 8 * np.sqrt(max(FASTEST @ noise.unit_covariance @ FASTEST, 0.0)))
        size = np.cbrt(np.maximum(last, 1.0))
        companion = np.zeros((*index.shape, 3, 3))
        companion[..., 1, 0] = companion[..., 2, 1] = 1.0
        companion[..., 0, 2] = -last / size / size / size
        companion[..., 1, 2] = -(4 * (alpha / gamma) - 1) / size / size
        companion[..., 2, 2] = -2 * (beta / gamma) / size
    return np.asarray(np.linalg.eigvals(companion) * size[..., None], np.complex128)


def samples_to_steady_gains(
    tracking_index: ArrayLike,
    share: float,
    process_noise: str = DEFAULT,
    after: Factors | None = None,
) -> NDArray[np.int64]:
    """After how many samples all three gains stay within ``share`` of the steady ones.

    tracking_index: Lambda, numbers or an array of tracks. share: of each steady gain, above 1e-12
    and below 1. after: covariances after the last sample taken, in units of the sampling interval
    and of the measured position's deviation; by default those after the first three positions.
    0 where the next gains are near enough already.

    The gains are run, not estimated: past the last one that is further off, for at least as many
    samples again, and until `error_ratio` leaves a thousandth of the share. Raises ValueError for
    a share out of range, where that takes more than 2,000,000 samples, and as `step` where a shear
    leaves the range of the kernels (with noise that is smooth enough above an index of some 1e8).
    """
    index = np.asarray(tracking_index, np.float64)
    least = least_run(share, error_ratio(index, process_noise))
    one, strength = np.ones(()), index * index
    factors = start(one, one, strength, one, process_noise) if after is None else after

    def advance(kept: Factors) -> tuple[Factors, list[Reals]]:
        found = step(kept, one, strength, one, process_noise=process_noise)
        return found.factors, [np.asarray(gain) for gain in found[1:4]]

    shape = np.broadcast_shapes(index.shape, *(np.shape(x) for x in factors))
    steady = noise_called(process_noise).steady.gains(index)
    return last_outside(advance, factors, steady, share, least, shape)
