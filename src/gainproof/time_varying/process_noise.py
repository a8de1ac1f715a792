"""The process noises whose recursions are printed, and their steady states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Noise:
    """One process noise: its name among the kernels.

    ``power``: q t^power is the variance that the last state gains over an interval t, so that
    Lambda^2 = q T^(2 + power)/r of two states and q T^(4 + power)/r of three. ``strength``: what q
    is. ``shape``: of three states the upper triangle of Q for q = t = 1, by rows, as the kernels
    state it for any q and t.
    """

    name: str
    power: int
    strength: str
    shape: tuple[tuple[float, ...], ...] = ()

    def kernel(self, operation: str) -> Any:
        """The printed recursion: "start", "predict", or of two states "step"."""
        states = "three_states" if self.shape else "two_states"
        module = import_module(f"gainproof.generated.recursion_{states}")
        return getattr(module, f"{operation}_{self.name}")

    @property
    def steady(self) -> ModuleType:
        """The printed steady state of equal intervals."""
        return import_module(f"gainproof.generated.{self.name}")

    @property
    def unit_covariance(self) -> NDArray[np.float64]:
        """Q of three states, of one unit over an interval of 1."""
        (p11, p12, p13), (p22, p23), (p33,) = self.shape
        return np.array([[p11, p12, p13], [p12, p22, p23], [p13, p23, p33]], np.float64)

    def tracking_index(
        self, interval: ArrayLike, strength: ArrayLike, variance: ArrayLike
    ) -> NDArray[np.float64]:
        """Lambda of equal intervals."""
        t, q, r = (np.asarray(x, np.float64) for x in (interval, strength, variance))
        ratio = np.sqrt(q) / np.sqrt(r) * t
        return np.asarray((ratio * t if self.shape else ratio) * np.sqrt(t) ** self.power)


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


def noise_called(name: str, noises: Mapping[str, Noise] = PROCESS_NOISES) -> Noise:
    """The process noise of this name. Raises ValueError for a name there is not."""
    if name not in noises:
        raise ValueError(f"process_noise must be one of {', '.join(sorted(noises))}, got {name!r}")
    return noises[name]
