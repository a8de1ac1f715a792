"""The process noises of three states whose recursions are printed, and their steady states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_three_states


@dataclass(frozen=True)
class Noise:
    """One process noise: its name among the kernels.

    ``power``: q t^power is the variance that the acceleration gains over an interval t, so that
    Lambda^2 = q T^(4 + power)/r. ``strength``: what q is. ``shape``: the
    upper triangle of Q for q = t = 1, by rows, as the kernels state it for any q and t.
    """

    name: str
    power: int
    strength: str
    shape: tuple[tuple[float, ...], ...]

    def kernel(self, operation: str) -> Any:
        """The printed recursion: "start" or "predict"."""
        return getattr(recursion_three_states, f"{operation}_{self.name}")

    @property
    def steady(self) -> ModuleType:
        """The printed steady state of equal intervals."""
        return import_module(f"gainproof.generated.{self.name}")

    @property
    def unit_covariance(self) -> NDArray[np.float64]:
        """Q of one unit over an interval of 1."""
        (p11, p12, p13), (p22, p23), (p33,) = self.shape
        return np.array([[p11, p12, p13], [p12, p22, p23], [p13, p23, p33]], np.float64)

    def tracking_index(
        self, interval: ArrayLike, strength: ArrayLike, variance: ArrayLike
    ) -> NDArray[np.float64]:
        """Lambda of equal intervals."""
        t, q, r = (np.asarray(x, np.float64) for x in (interval, strength, variance))
        return np.asarray(np.sqrt(q) / np.sqrt(r) * t * t * np.sqrt(t) ** self.power)


PROCESS_NOISES: Mapping[str, Noise] = {
    "acceleration-increments": Noise(
        "acceleration_increments",
        0,
        "variance of the acceleration's increment at each sample, m^2/s^4",
        ((0, 0, 0), (0, 0), (1,)),
    ),
    "continuous-white-jerk": Noise(
        "continuous_white_jerk",
        1,
        "two-sided power density of the jerk, m^2/s^5",
        ((1 / 20, 1 / 8, 1 / 6), (1 / 3, 1 / 2), (1,)),
    ),
    "random-jerk": Noise(
        "random_jerk",
        2,
        "variance of the jerk of each interval, m^2/s^6",
        ((1 / 36, 1 / 12, 1 / 6), (1 / 4, 1 / 2), (1,)),
    ),
    "wiener-acceleration": Noise(
        "wiener_acceleration",
        0,
        "variance of an acceleration added over each interval, m^2/s^4",
        ((1 / 4, 1 / 2, 1 / 2), (1, 1), (1,)),
    ),
}
DEFAULT = "continuous-white-jerk"


def noise_called(name: str) -> Noise:
    """The process noise of this name. Raises ValueError for a name there is not."""
    if name not in PROCESS_NOISES:
        known = ", ".join(sorted(PROCESS_NOISES))
        raise ValueError(f"process_noise must be one of {known}, got {name!r}")
    return PROCESS_NOISES[name]
