"""Fixed-gain filters run on simulated tracks: errors judged at a stated rate of false alarms.

Independent because no covariance equation is solved and no lag is derived: a target is moved by
Taylor's formula and shaken, its position is measured with noise of variance 1, the filter with the
gains under test follows it (T = 1), and the errors at the last sample are noted, truth less
estimate, one set a track. They are linear in independent normal draws, hence exactly normal: the
sum of squares about the mean over the variance is chi-square with as many degrees as there are
tracks, and the mean error normal. `contradictions` compares in several directions of the state and
shares the rate of false alarms out among them (Bonferroni), so that a true covariance and lag are
contradicted with at most that probability.

What it rests on: that the start is forgotten. The error of the start, none, dies out with the
powers of the closed loop; `samples_to_forget` says how many samples that takes. The generator is
NumPy's with the seed given.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import factorial, sqrt

import numpy as np
from numpy.typing import NDArray
from scipy import special

Reals = NDArray[np.float64]
LONGEST_RUN, LARGEST = 100_000, 1e100
NOTHING = 2.0**-48
"""What roundings may leave of a variance of 0 in a direction of two unit deviations."""
NOTHING = 2.0**-48
"""What roundings may leave of a variance of 0 in a direction of at most two unit deviations."""


@dataclass(frozen=True)
class Errors:
    """Truth less prediction and less update at the last sample, one row a track, (tracks, n)."""

    predicted: Reals
    updated: Reals


def run(
    gains: Sequence[float],
    samples: int,
    tracks: int,
    seed: int,
    *,
    process_noise: Reals | None = None,
    push: float = 0.0,
) -> Errors:
    """Follow so many tracks over so many samples with n = 2 or 3 fixed gains.

    ``push`` is the constant derivative beyond the state: the acceleration for two states, the jerk
    for three. ``process_noise`` is n x n, added to the state at each sample.
    """
    size = len(gains)
    moving, pushed = _transition(size), push * _next_column(size)
    gain = np.array(gains)[:, None]
    root = np.zeros((size, 0)) if process_noise is None else _root(process_noise)
    generator = np.random.default_rng(seed)
    true, estimate = np.zeros((size, tracks)), np.zeros((size, tracks))
    ahead = estimate
    for _ in range(samples):
        true = moving @ true + pushed
        if root.shape[1]:
            true += root @ generator.standard_normal((root.shape[1], tracks))
        ahead = moving @ estimate
        measured = true[0] + generator.standard_normal(tracks)
        estimate = ahead + gain * (measured - ahead[0])
    return Errors((true - ahead).T, (true - estimate).T)


def standing_errors(
    gains: Sequence[float], samples: int, *, push: float = 1.0
) -> tuple[Reals, Reals]:
    """Errors of one run without any noise, predicted and updated: the lags where they settle."""
    size = len(gains)
    moving, pushed, gain = _transition(size), push * _next_column(size)[:, 0], np.array(gains)
    true, estimate = np.zeros(size), np.zeros(size)
    ahead = estimate
    for _ in range(samples):
        true, ahead = moving @ true + pushed, moving @ estimate
        estimate = ahead + gain * (true[0] - ahead[0])
    return true - ahead, true - estimate


def samples_to_forget(gains: Sequence[float], left: float) -> int:
    """After how many samples the closed loop has shrunk any error of the start to ``left``.

    Raises ValueError for a loop that does not shrink.
    """
    size = len(gains)
    rest = np.eye(size)
    rest[:, 0] -= gains
    loop = _transition(size) @ rest
    samples, power = 1, loop
    while np.linalg.norm(power) > left:
        samples, power = samples + 1, power @ loop
        if samples > LONGEST_RUN or not np.abs(power).max() < LARGEST:
            raise ValueError("the closed loop does not shrink")
    return samples


def contradictions(
    errors: Reals, mean: Reals, covariance: Reals, false_alarm: float
) -> tuple[str, ...]:
    """What of the stated mean and covariance the errors do not bear out, in words.

    ``errors`` (tracks, n). Every state and every sum and difference of two states, each in units
    of its stated deviation, is asked for its spread and its mean. ValueError where the covariance
    gives a direction no variance beyond what roundings leave of 0, or the rate is not between 0
    and 1.
    """
    if not 0 < false_alarm < 1:
        raise ValueError(f"a rate of false alarms lies between 0 and 1, got {false_alarm}")
    tracks = len(errors)
    chosen = _directions(covariance)
    share = false_alarm / (2 * len(chosen))
    low, high = spread_interval(tracks, share)
    reach = -float(special.ndtri(share / 2))
    found = []
    for name, direction in chosen:
        variance = float(direction @ covariance @ direction)
        if not variance > NOTHING:
            raise ValueError(f"the stated variance of {name} is {variance}")
        away = (errors - mean) @ direction / sqrt(variance)
        ratio, offset = float(np.mean(away**2)), float(np.mean(away)) * sqrt(tracks)
        if not low <= ratio <= high:
            room = f"{low:.4f}..{high:.4f}"
            found.append(f"variance of {name}: {ratio:.4f} of that stated, not in {room}")
        if not abs(offset) <= reach:
            found.append(f"mean of {name}: {offset:.2f} deviations off, more than {reach:.2f}")
    return tuple(found)


def spread_interval(degrees: int, false_alarm: float) -> tuple[float, float]:
    """Where chi-square over its degrees lies but for that probability, half of it on each side."""
    tail = false_alarm / 2
    low = float(special.gammaincinv(degrees / 2, tail))
    high = float(special.gammainccinv(degrees / 2, tail))
    return 2 * low / degrees, 2 * high / degrees


def _directions(covariance: Reals) -> list[tuple[str, Reals]]:
    size = len(covariance)
    unit = np.eye(size) / np.sqrt(np.diag(covariance))[:, None]
    single = [(f"state {i + 1}", unit[i]) for i in range(size)]
    both = [
        (f"states {i + 1} {word} {j + 1}", unit[i] + sign * unit[j])
        for i, j in combinations(range(size), 2)
        for word, sign in (("plus", 1), ("less", -1))
    ]
    return [*single, *both]


def _transition(size: int) -> Reals:
    rows = [[1 / factorial(j - i) if j >= i else 0 for j in range(size)] for i in range(size)]
    return np.array(rows, dtype=np.float64)


def _next_column(size: int) -> Reals:
    """What a constant derivative beyond the state adds to it over one interval."""
    return np.array([[1 / factorial(size - i)] for i in range(size)])


def _root(covariance: Reals) -> Reals:
    """A matrix of few columns whose product with its transpose is the covariance."""
    values, vectors = np.linalg.eigh(covariance)
    there = values > 1e-12 * values.max()
    return np.asarray(vectors[:, there] * np.sqrt(values[there]))
