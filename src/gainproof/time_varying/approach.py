"""How fast gains come to their steady state, at equal intervals."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.time_varying.covariance import Factors, Reals
from gainproof.time_varying.process_noise import DEFAULT, noise_called
from gainproof.time_varying.settling import last_outside, least_run
from gainproof.time_varying.track import step


def error_ratio(tracking_index: ArrayLike, process_noise: str = DEFAULT) -> np.float64 | Reals:
    """|z|^2, the larger closed-loop pole squared: in the long run the covariance's distance from
    the steady state shrinks by this from one sample to the next.

    For a start above the steady state the derivation recursion-two-states proves that
    P_k - P <= A^k (P_0 - P) (A^k)' with the steady closed loop A; for any other start the same is
    observed. Below Lambda = 1e-16, where |z| rounds to 1, so does the ratio.
    """
    poles = noise_called(process_noise).steady.closed_loop_poles(tracking_index)
    first, second = (np.hypot(*poles[i : i + 2]) for i in (0, 2))
    return np.asarray(np.maximum(first, second) ** 2)[()]


def samples_to_steady_gains(
    tracking_index: ArrayLike,
    share: float,
    process_noise: str = DEFAULT,
    after: Factors | None = None,
) -> NDArray[np.int64]:
    """After how many samples both gains stay within ``share`` of the steady ones.

    tracking_index: Lambda, numbers or an array of tracks. share: of each steady gain, above 1e-12
    and below 1. after: covariances after the last sample taken, in units of the sampling interval
    and of the measured position's deviation; by default those after the first two positions.
    0 where the next gains are near enough already.

    The gains are run, not estimated: past the last one that is further off, for at least as many
    samples again, and until `error_ratio` leaves a thousandth of the share. Raises ValueError for
    a share out of range, and where that takes more than 2,000,000 samples.
    """
    noise = noise_called(process_noise)
    index = np.asarray(tracking_index, np.float64)
    least = least_run(share, error_ratio(index, process_noise))
    one, strength = np.ones(()), index * index
    factors = Factors(*noise.kernel("start")(one, strength, one)) if after is None else after

    def advance(kept: Factors) -> tuple[Factors, tuple[Reals, Reals]]:
        found = step(kept, one, strength, one, process_noise=process_noise)
        return found.factors, (np.asarray(found.position_gain), np.asarray(found.velocity_gain))

    shape = np.broadcast_shapes(index.shape, *(np.shape(x) for x in factors))
    return last_outside(advance, factors, noise.steady.gains(index), share, least, shape)
