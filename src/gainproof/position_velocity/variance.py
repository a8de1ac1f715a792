"""The variance of the position as a function of the velocity ratio, with its two limits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gainproof.position_velocity.arguments import Reals
from gainproof.position_velocity.process_noise import DEFAULT, noise_called, printed

COVARIANCES = ("predicted", "updated")


@dataclass(frozen=True)
class Variance:
    """G1, the variance of the position over sigma_o^2, predicted or updated.

    ``at(index, ratio)``; ``known_exactly(index)``, its limit as the velocity ratio goes to 0;
    ``not_measured(index)``, as it goes to infinity; the least and the greatest velocity ratio
    that the kernels take in float64.
    """

    title: str
    at: Callable[[Reals, Reals], Reals]
    known_exactly: Callable[[Reals], Reals]
    not_measured: Callable[[Reals], Reals]
    smallest_ratio: float
    largest_ratio: float


def position_variance(covariance: str = "predicted", process_noise: str = DEFAULT) -> Variance:
    """G1 of the predicted or the updated position. Raises ValueError for an unknown name.

    All values come from printed kernels. `known_velocity` has the limits of an exact velocity that
    do not vanish: where the velocities at both ends of an interval fix the displacement in it, the
    updated variance does.
    """
    noise = noise_called(process_noise)
    if covariance not in COVARIANCES:
        raise ValueError(f"covariance must be one of {', '.join(COVARIANCES)}, got {covariance!r}")
    function, entry = f"{covariance}_covariance", f"{covariance}_11"
    both, alone = (getattr(printed(module), function) for module in (noise.both, noise.alone))

    known_velocity = getattr(printed(noise.both), "known_velocity", None)

    def known_exactly(index: Reals) -> Reals:
        known = None if known_velocity is None else known_velocity(index)
        return np.asarray(getattr(known, entry)) if hasattr(known, entry) else np.zeros(index.shape)

    _, ratio = getattr(printed(noise.both), f"_{function.upper()}").inputs
    return Variance(
        f"the variance of the {covariance} position over sigma_o^2",
        lambda index, ratio: np.asarray(getattr(both(index, ratio), entry)),
        known_exactly,
        lambda index: np.asarray(getattr(alone(index), entry)),
        *ratio.double,
    )
