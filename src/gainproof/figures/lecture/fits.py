"""The numbers of a mean and a line that grow with each measurement, and of their gains."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from gainproof.figures.lecture import fixed_gain_track
from gainproof.generated import least_squares_line, least_squares_mean
from gainproof.plots.table import Column, Reals, Table

SAMPLES = 25
DEVIATION = 8.0
"""Of the measured range in m; the lecture's number for another picture."""
INTERVAL = 10.0
STANDING = 5000.0
"""Range of the target that stands, in m."""
FIRST, SPEED = 5000.0, 0.3
"""Range at the first sample in m and range rate in m/s of the target that moves: slow, so that
noise of 8 m is seen beside its course."""
SEED = 9
LAST_GAIN = 30


def mean_and_line() -> Table:
    """A standing target's range by the mean, and a moving one's by the line, sample by sample."""
    k = np.arange(SAMPLES + 0.0)
    time = INTERVAL * k
    noise = DEVIATION * np.random.default_rng(SEED).standard_normal((2, SAMPLES))
    standing, moving = STANDING + noise[0], FIRST + SPEED * time + noise[1]
    mean_gain = _from_one(least_squares_mean.gains(k[1:]).alpha)
    mean, _ = fixed_gain_track.followed(standing, mean_gain, np.zeros(SAMPLES))
    alpha, beta = (_from_one(gain) for gain in least_squares_line.gains(k[1:]))
    line, velocity = fixed_gain_track.followed(moving, alpha, beta)
    mean_variance = least_squares_mean.updated_covariance(k[1:]).updated_11
    line_variance = least_squares_line.updated_covariance(k[1:]).updated_11
    spreads = [
        DEVIATION * np.sqrt(_from_one(variance)) for variance in (mean_variance, line_variance)
    ]
    # the line through all samples, back from the last estimate
    through = line[-1] + velocity[-1] * (k - k[-1])
    return Table(
        "A target that stands, by the mean, and one that moves, by the line",
        (
            Column("time_s", "seconds since the first sample", time),
            Column("standing_observed_m", "measured range of the standing target", standing),
            Column("mean_m", "mean of the measurements so far", mean),
            Column("mean_deviation_m", "its standard deviation", spreads[0]),
            Column("moving_observed_m", "measured range of the moving target", moving),
            Column("line_m", "end of the line through the measurements so far", line),
            Column("line_deviation_m", "its standard deviation", spreads[1]),
            Column("last_line_m", "the line through all measurements", through),
        ),
        {
            "true range rate (m/s)": SPEED,
            "range rate of the line through all (m/s)": float(velocity[-1] / INTERVAL),
        },
        (
            "The lecture gives the recursions; its numbers are not among what we have.",
            f"Ours: standing at {STANDING:g} m; moving from {FIRST:g} m at {SPEED:g} m/s;",
            f"every {INTERVAL:g} s, normal noise of {DEVIATION:g} m, seed {SEED}.",
        ),
    )


def gains() -> Table:
    """alpha and beta of the line, and the gain of the mean, against the sample number."""
    k = np.arange(1.0, LAST_GAIN + 1)
    line = least_squares_line.gains(k)
    mean = least_squares_mean.gains(k)
    return Table(
        "Gains of the linear least-squares filter against the sample number",
        (
            Column("k", "sample number, the first sample is 0", k),
            Column("alpha", "gain of the position, of the line", _reals(line.alpha)),
            Column("beta", "gain of the velocity times T, of the line", _reals(line.beta)),
            Column("mean_alpha", "gain of the mean, 1/(k + 1)", _reals(mean.alpha)),
        ),
        {},
        (f"Ours: k from 1 to {LAST_GAIN}, the gain of the mean beside those of the line.",),
    )


def _reals(values: ArrayLike) -> Reals:
    return np.asarray(values, np.float64)


def _from_one(values: ArrayLike) -> Reals:
    """1 for the first sample, which is taken as measured, then the values."""
    return np.concatenate([np.ones(1), _reals(values)])
