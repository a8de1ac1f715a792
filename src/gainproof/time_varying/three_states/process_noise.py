"""The process noises of three states whose recursions are printed, and their steady states."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.time_varying import process_noise
from gainproof.time_varying.process_noise import Noise

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
    return process_noise.noise_called(name, PROCESS_NOISES)
