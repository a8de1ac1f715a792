"""The steady state in metres and seconds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.position_velocity.arguments import positive, require
from gainproof.position_velocity.powers import Factor, Reals, product
from gainproof.position_velocity.process_noise import DEFAULT, kernels


@dataclass(frozen=True)
class SteadyState:
    """Covariances and gain of the stationary filter, each an array of shape (..., 2, 2).

    The dots are the common shape of the arguments. Index 0 is the position, 1 the velocity;
    ``predicted`` and ``updated`` are in m^2, m^2/s and m^2/s^2; ``gain[..., i, j]`` carries the
    innovation of measured quantity j to state i: in 1, s (position from velocity), 1/s (velocity
    from position) and 1. ``tracking_index`` and ``velocity_ratio`` are the two numbers, or
    arrays of the common shape, on which the dimensionless steady state depends.
    """

    predicted: Reals
    updated: Reals
    gain: Reals
    tracking_index: np.float64 | Reals
    velocity_ratio: np.float64 | Reals


def steady_state(
    sampling_interval: ArrayLike,
    position_deviation: ArrayLike,
    velocity_deviation: ArrayLike,
    acceleration_deviation: ArrayLike,
    process_noise: str = DEFAULT,
) -> SteadyState:
    """The steady state of the filter that measures position and velocity at every sample.

    sampling_interval: T, in s. position_deviation: sigma_o, standard deviation of the measured
    position, in m. velocity_deviation: sigma_d, of the measured velocity, in m/s.
    acceleration_deviation: sigma_a, in m/s^2. Each a number or an array, broadcast together;
    positive and finite.

    process_noise: what sigma_a is the deviation of. "continuous-white-acceleration": the
    source's (7), white acceleration whose density is sigma_a^2 T; "random-acceleration": an
    acceleration constant over each interval; "random-velocity": velocity increments of standard
    deviation sigma_a T at the samples.

    The kernels take Lambda = sigma_a T^2/sigma_o (the source's r is 4/Lambda) and
    S = sigma_d T/sigma_o. Both are rounded, by less than 4 * 2^-53 and 2 * 2^-53 of themselves:
    the dimensionless steady state is that of a sigma_a and a sigma_d off by no more, within the
    bounds that the kernels state. The way to metres and seconds adds less than 5 * 2^-53. An
    entry too large or small for a float64 comes as infinity, a subnormal number or 0; none is
    NaN.

    Raises ValueError for an argument that is not positive and finite, with its place, for shapes
    that do not fit, for a Lambda or S outside the domain of the kernels, and for an unknown
    process noise; TypeError for what is no real number.

    Source: Suzuki, equations (16), (18) and (19).
    """
    both = kernels(process_noise)
    interval, position, velocity, acceleration = positive(
        {
            "sampling_interval": sampling_interval,
            "position_deviation": position_deviation,
            "velocity_deviation": velocity_deviation,
            "acceleration_deviation": acceleration_deviation,
        }
    )
    index = product((acceleration, 1), (interval, 2), (position, -1))
    ratio = product((velocity, 1), (interval, 1), (position, -1))
    _require_inside(process_noise, index, ratio)
    units = [[(position, 2), (interval, -power)] for power in range(3)]
    p11, p12, p22 = (
        product((np.asarray(entry), 1), *unit)
        for entry, unit in zip(both.predicted_covariance(index, ratio), units, strict=True)
    )
    u11, u12, u22 = (
        product((np.asarray(entry), 1), *unit)
        for entry, unit in zip(both.updated_covariance(index, ratio), units, strict=True)
    )
    k11, k12, k21, k22 = (np.asarray(entry) for entry in both.gains(index, ratio))
    return SteadyState(
        _matrix(p11, p12, p12, p22),
        _matrix(u11, u12, u12, u22),
        _matrix(k11, _times(k12, (interval, 1)), _times(k21, (interval, -1)), k22),
        index[()],
        ratio[()],
    )


def _require_inside(process_noise: str, index: Reals, ratio: Reals) -> None:
    """ValueError where Lambda or S lies beyond what the kernels take, with what it is made of."""
    domains = kernels(process_noise)._PREDICTED_COVARIANCE.inputs
    made = (
        (index, "acceleration_deviation sampling_interval^2/position_deviation"),
        (ratio, "velocity_deviation sampling_interval/position_deviation"),
    )
    for domain, (values, formula) in zip(domains, made, strict=True):
        least, most = domain.double
        wanted = f"at least {least:g} and at most {most:g}"
        name = f"{domain.name} = {formula}"
        require((values >= least) & (values <= most), values, name, wanted)


def _times(entry: Reals, unit: Factor) -> Reals:
    return product((entry, 1), unit)


def _matrix(a: Reals, b: Reals, c: Reals, d: Reals) -> NDArray[np.float64]:
    """Four entries in rows, stacked into the last two axes."""
    entries = np.stack(np.broadcast_arrays(a, b, c, d), axis=-1)
    return entries.reshape(*entries.shape[:-1], 2, 2)
