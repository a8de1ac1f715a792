"""How fast gains come to their steady state, at equal intervals: by running them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.time_varying.covariance import Factors, Reals
from gainproof.time_varying.process_noise import DEFAULT, noise_called
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


Kept = TypeVar("Kept")

# samples run at most, some seconds for one track
MOST = 2_000_000
# the run goes on until what is left is this part of the share asked for
REST = 1e-3


def least_run(share: float, ratio: np.float64 | Reals) -> int:
    """How many samples must be run at least, for the slowest of the tracks.

    Raises ValueError for a share out of range, and where there are more than 2,000,000.
    """
    if not 1e-12 < share < 1:
        raise ValueError(f"share must lie above 1e-12 and below 1, got {share!r}")
    with np.errstate(divide="ignore"):
        least = np.log(share * REST) / np.log(ratio)
    longest = float(np.max(np.abs(least), initial=0.0))
    if not longest < MOST:
        raise ValueError(f"steady gains within {share} may take {longest:.3g} samples, over {MOST}")
    return int(longest) + 1


def last_outside(
    advance: Callable[[Kept], tuple[Kept, Sequence[Reals]]],
    kept: Kept,
    steady: Sequence[Reals],
    share: float,
    least: int,
    shape: tuple[int, ...],
) -> NDArray[np.int64]:
    """The last sample at which a gain is further off than ``share`` of the steady one; else 0.

    `advance` takes covariances over one sample and gives them with the gains. The run goes past
    that sample for at least as many again, and for at least `least`.
    """
    last = np.zeros(shape, np.int64)
    count = 0
    while count < least or count < 2 * int(np.max(last, initial=0)):
        if count >= MOST:
            raise ValueError(
                f"gains are not within {share} of the steady ones after {MOST} samples"
            )
        kept, gains = advance(kept)
        count += 1
        near = [np.abs(x - y) <= share * y for x, y in zip(gains, steady, strict=True)]
        last[~np.logical_and.reduce(np.broadcast_arrays(*near))] = count
    return last
