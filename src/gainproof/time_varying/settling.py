"""After how many samples gains stay near their steady ones, by running them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from gainproof.time_varying.covariance import Reals

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
