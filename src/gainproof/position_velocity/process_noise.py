"""The process noises for which kernels with measured position and velocity are printed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType


@dataclass(frozen=True)
class Noise:
    """One process noise: the modules of `gainproof.generated` with ``both`` quantities measured,
    and with the position ``alone``.
    """

    both: str
    alone: str


PROCESS_NOISES: Mapping[str, Noise] = {
    "continuous-white-acceleration": Noise("position_velocity", "continuous_white_acceleration"),
    "random-acceleration": Noise("position_velocity_random_acceleration", "random_acceleration"),
    "random-velocity": Noise("position_velocity_random_velocity", "random_velocity"),
}
DEFAULT = "continuous-white-acceleration"


def noise_called(name: str) -> Noise:
    """The process noise of this name. Raises ValueError for a name there is not."""
    if name not in PROCESS_NOISES:
        known = ", ".join(sorted(PROCESS_NOISES))
        raise ValueError(f"process_noise must be one of {known}, got {name!r}")
    return PROCESS_NOISES[name]


def kernels(process_noise: str) -> ModuleType:
    """The printed module with both quantities measured: functions of tracking index and velocity
    ratio. Raises ValueError for a name there is not.
    """
    return printed(noise_called(process_noise).both)


def printed(module: str) -> ModuleType:
    """A module of printed kernels."""
    return import_module(f"gainproof.generated.{module}")
