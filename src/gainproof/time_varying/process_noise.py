"""The process noises whose recursions are printed, and their steady states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.generated import recursion_two_states


@dataclass(frozen=True)
class Noise:
    """One process noise: its name among the kernels.

    ``power``: q t^power is the variance that the velocity gains over an interval t, so that
    Lambda^2 = q T^(2 + power)/r. ``strength``: what q is.
    """

    name: str
    power: int
    strength: str

    def kernel(self, operation: str) -> Any:
        """The printed recursion: "start", "predict" or "step"."""
        return getattr(recursion_two_states, f"{operation}_{self.name}")

    @property
    def steady(self) -> ModuleType:
        """The printed steady state of equal intervals."""
        return import_module(f"gainproof.generated.{self.name}")

    def tracking_index(
        self, interval: ArrayLike, strength: ArrayLike, variance: ArrayLike
    ) -> NDArray[np.float64]:
        """Lambda of equal intervals."""
        t, q, r = (np.asarray(x, np.float64) for x in (interval, strength, variance))
        return np.asarray(np.sqrt(q) / np.sqrt(r) * t * np.sqrt(t) ** self.power)


PROCESS_NOISES: Mapping[str, Noise] = {
    "continuous-white-acceleration": Noise(
        "continuous_white_acceleration", 1, "two-sided power density of the acceleration, m^2/s^3"
    ),
    "random-acceleration": Noise(
        "random_acceleration", 2, "variance of the acceleration of each interval, m^2/s^4"
    ),
    "random-velocity": Noise(
        "random_velocity", 0, "variance of the velocity's increment at each sample, m^2/s^2"
    ),
}
DEFAULT = "continuous-white-acceleration"


def noise_called(name: str) -> Noise:
    """The process noise of this name. Raises ValueError for a name there is not."""
    if name not in PROCESS_NOISES:
        known = ", ".join(sorted(PROCESS_NOISES))
        raise ValueError(f"process_noise must be one of {known}, got {name!r}")
    return PROCESS_NOISES[name]
