"""One method put to one set of observations: what is minimised, and its linear model.

Biases are linear unknowns with constant columns. They come first in the QR factorisation and are
taken out of residuals and Jacobians by projection: what is left is the cost with the best biases.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.measurement import Seen, seen
from gainproof.location.methods import CHOSEN, COMMON, EACH, Method
from gainproof.location.noise import whitening
from gainproof.location.stations import Observations, Stations


@dataclass(frozen=True, eq=False)
class Problem:
    """method; the observations that it uses (m); white (m, m) makes their noise white.

    biases: the numbers of the stations with a bias of their own, () for none; `common` says that
    all ranges share one. columns (m, q) of the biases, base (m, q) orthonormal over their whitened
    ones.
    """

    method: Method
    stations: Stations
    used: Observations
    white: Reals
    biases: tuple[int, ...]
    columns: Reals
    base: Reals

    @property
    def velocity(self) -> bool:
        return self.method.uses_rates

    @property
    def unknowns(self) -> int:
        """Of position and velocity."""
        return self.method.unknowns(self.stations.dimension)

    def split(self, unknowns: Reals) -> tuple[Reals, Reals]:
        """Position and velocity (N, d); zeros where there is no velocity."""
        d = self.stations.dimension
        place = unknowns[:, :d]
        return place, unknowns[:, d:] if self.velocity else np.zeros_like(place)


class Linear(NamedTuple):
    """The linear model at N points: residuals (N, m), Jacobians (N, m, k) whose columns are over
    their scale (N, k); all white, the biases taken out.
    """

    residual: Reals
    jacobian: Reals
    scale: Reals


def problem(
    given: Stations,
    observed: Observations,
    method: Method,
    biased: Sequence[int] | None = None,
) -> Problem:
    """biased: the stations whose ranges have a bias, where the method lets a test choose them.

    ValueError: a covariance that is none.
    """
    names = [
        f"the range{' rate' if rate else ''} of {given.names[i]}"
        for i, rate in zip(observed.station.tolist(), observed.is_rate.tolist(), strict=True)
    ]
    whitening(observed.covariance, names)  # of all, so that a wrong part is named by every method
    kept = np.where(observed.is_rate, method.uses_rates, method.uses_ranges)
    used = Observations(
        observed.values[kept],
        observed.station[kept],
        observed.is_rate[kept],
        observed.covariance[np.ix_(kept, kept)],
    )
    white = whitening(used.covariance, [n for n, keep in zip(names, kept, strict=True) if keep])
    of_ranges = used.station[~used.is_rate].tolist()
    chosen: tuple[int, ...] = ()
    if method.bias == EACH or (method.bias == CHOSEN and biased is None):
        chosen = tuple(of_ranges)
    elif method.bias == CHOSEN:
        chosen = tuple(i for i in of_ranges if i in set(biased or ()))
    columns = np.zeros((len(used.values), 0))
    if method.bias == COMMON:
        columns = np.where(used.is_rate, 0.0, 1.0)[:, None]
    elif chosen:
        at = ~used.is_rate[:, None] & (used.station[:, None] == np.array(chosen))
        columns = at.astype(np.float64)
    base = np.linalg.qr(white @ columns)[0] if columns.shape[1] else columns
    return Problem(method, given, used, white, chosen, columns, base)


def predicted(asked: Problem, unknowns: Reals) -> tuple[Reals, Seen]:
    """The observations (N, m) of targets (N, k) without noise and bias."""
    found = seen(asked.stations, *asked.split(unknowns))
    where = asked.used.station
    values = np.where(asked.used.is_rate, found.rate[:, where], found.distance[:, where])
    return values, found


def residual(asked: Problem, unknowns: Reals, observed: Reals) -> Reals:
    """White residuals (N, m) with the best biases; observed (N, m)."""
    return without_biases(asked, (observed - predicted(asked, unknowns)[0]) @ asked.white.T)


def without_biases(asked: Problem, white: Reals) -> Reals:
    """White rows (N, m) less what biases explain."""
    if not asked.base.shape[1]:
        return white
    return np.asarray(white - (white @ asked.base) @ asked.base.T)


def linearised(asked: Problem, unknowns: Reals, observed: Reals) -> Linear:
    """The linear model at targets (N, k).

    A column's scale is the length that it would have if no entry were smaller than its size allows:
    1 for a range by a position and a rate by a velocity, |w|/f for a rate by a position. So entries
    that vanish (radial motion) stay small and are not blown up with their rounding errors.
    """
    values, found = predicted(asked, unknowns)
    full = jacobian(asked, found)
    left = without_biases(asked, (observed - values) @ asked.white.T)
    sizes = np.abs(asked.white)
    rate = asked.used.is_rate
    turning = (found.speed / found.distance)[:, asked.used.station]
    lengths = [np.where(rate, turning, 1.0)] + ([rate * np.ones(turning.shape)] * asked.velocity)
    d = asked.stations.dimension
    scale = np.concatenate(
        [np.repeat(np.linalg.norm(size @ sizes.T, axis=1)[:, None], d, axis=1) for size in lengths],
        axis=1,
    )
    scale[scale == 0] = 1.0
    reduced = full - asked.base @ (asked.base.T @ full) if asked.base.shape[1] else full
    return Linear(left, reduced / scale[:, None, :], scale)


def jacobian(asked: Problem, found: Seen) -> Reals:
    """The white derivatives (N, m, k) of the observations by position and velocity."""
    where, rate = asked.used.station, asked.used.is_rate[:, None]
    by_position = np.where(rate, found.turn[:, where], found.unit[:, where])
    if not asked.velocity:
        return np.asarray(asked.white @ by_position)
    by_velocity = np.where(rate, found.unit[:, where], 0.0)
    return np.asarray(asked.white @ np.concatenate([by_position, by_velocity], axis=2))
