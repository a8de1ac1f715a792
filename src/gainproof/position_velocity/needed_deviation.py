"""The velocity accuracy that a wanted position accuracy needs, in metres and seconds."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.position_velocity.arguments import positive
from gainproof.position_velocity.inverse import velocity_ratio_for
from gainproof.position_velocity.powers import product
from gainproof.position_velocity.process_noise import DEFAULT
from gainproof.position_velocity.reach import Limits, require_reachable
from gainproof.position_velocity.variance import position_variance


def velocity_deviation_for(
    sampling_interval: ArrayLike,
    position_deviation: ArrayLike,
    acceleration_deviation: ArrayLike,
    wanted_deviation: ArrayLike,
    *,
    covariance: str = "predicted",
    process_noise: str = DEFAULT,
) -> np.float64 | NDArray[np.float64]:
    """sigma_d, the deviation of the measured velocity that the wanted accuracy allows, in m/s.

    sampling_interval: T, in s. position_deviation: sigma_o, of the measured position, in m.
    acceleration_deviation: sigma_a, in m/s^2. wanted_deviation: standard deviation of the
    predicted position (of the updated one with ``covariance="updated"``), in m. Positive finite
    numbers or arrays, broadcast together. process_noise: as in `steady_state`.

    The answer is that of `velocity_ratio_for` with G1 = (wanted_deviation/sigma_o)^2, times
    sigma_o/T, and is exact for a nearby question in the same sense: a wanted variance and a
    sigma_a off by less than the bound stated there and 4 * 2^-53 (for G1 and for
    sigma_a T^2/sigma_o), the answer itself rounded by 2 * 2^-53.

    Raises ValueError with both limits in metres when no velocity accuracy is enough, or none is
    needed, and says which; else as `velocity_ratio_for`.

    Source: Suzuki, equations (14), (15) and section 4.
    """
    interval, position, acceleration, wanted = positive(
        {
            "sampling_interval": sampling_interval,
            "position_deviation": position_deviation,
            "acceleration_deviation": acceleration_deviation,
            "wanted_deviation": wanted_deviation,
        }
    )
    variance = position_variance(covariance, process_noise)
    index = product((acceleration, 1), (interval, 2), (position, -1))
    variance_ratio = product((wanted, 2), (position, -2))
    with np.errstate(all="ignore"):
        limits = Limits(
            position * np.sqrt(variance.known_exactly(index)),
            position * np.sqrt(variance.not_measured(index)),
        )
    require_reachable("wanted_deviation", wanted, limits, index, " m")
    ratio = velocity_ratio_for(
        index, variance_ratio, covariance=covariance, process_noise=process_noise
    )
    return product((np.asarray(ratio), 1), (position, 1), (interval, -1))[()]
