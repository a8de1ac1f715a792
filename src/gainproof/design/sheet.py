"""The numbers of a design: each named filter at one lag, tracking index, alpha or given gains."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gainproof.design import decay
from gainproof.design.named_filter import NamedFilter, missing, out_of_reach
from gainproof.design.named_filters import named_filters
from gainproof.fixed_gain import three_states, two_states
from gainproof.fixed_gain.settling import samples_to_settle
from gainproof.fixed_gain.stability import is_stable, stable_gains

NOT_TOLD = (
    "largest modulus and settling cannot be told: they are too near the border of stability for "
    "gains in float64"
)


@dataclass(frozen=True)
class Row:
    """One filter: gains, variances of the predicted and the smoothed position over B, lag (e_fin
    over a_c T^2, of three states over that of a jerk, T^3), closed-loop poles, what the largest
    modulus leaves to 1, samples until 1 %; these two are None where gains as rounded do not tell.
    """

    name: str
    title: str
    gains: tuple[float, ...]
    predicted: float
    smoothed: float
    lag: float
    poles: tuple[complex, ...]
    stable: bool
    distance: float | None
    samples: float | None
    note: str = ""


@dataclass(frozen=True)
class Absent:
    """A filter that does not exist there, or is not computed, and why."""

    name: str
    title: str
    reason: str


@dataclass(frozen=True)
class Sheet:
    """All named filters of two or three states for one choice of the user."""

    states: int
    kind: str
    value: float | tuple[float, ...]
    rows: tuple[Row | Absent, ...]

    @property
    def found(self) -> tuple[Row, ...]:
        return tuple(row for row in self.rows if isinstance(row, Row))


def sheet(states: int, kind: str, value: float) -> Sheet:
    """Every named filter at a lag, a tracking index or an alpha.

    The index is that of the noise whose steady state a filter is; a filter without one is shown at
    the lag of the last filter before it that has one, and its note says so.
    """
    rows: list[Row | Absent] = []
    reference: Row | None = None
    for each in named_filters(states):
        if kind == "tracking index" and each.by_index is None:
            rows.append(_at_lag_of(each, reference))
            continue
        made = list(_rows(each, kind, value))
        rows += made
        found = [row for row in made if isinstance(row, Row)]
        reference = found[0] if found else reference
    return Sheet(states, kind, value, tuple(rows))


def row_of(
    name: str,
    title: str,
    gains: Sequence[float],
    note: str = "",
    variance: float | None = None,
    at: float | None = None,
) -> Row:
    """A filter's numbers from its gains; `variance` of the predicted position and the lag `at`
    where they are known apart from them. ValueError where gains are not stable, or nearly not.
    """
    gains = tuple(float(gain) for gain in gains)
    if variance is not None and at is not None:
        stable_gains(*gains)
        alpha = gains[0]
        predicted, lag = variance, at
        # a sum of two squares: of (I - K H) P (I - K H)' + K K' the first entry
        smoothed = (1 - alpha) ** 2 * variance + alpha**2
        poles = two_states.poles(*gains) if len(gains) == 2 else three_states.poles(*gains)
    elif len(gains) == 2:
        v2, lag2 = two_states.variances(*gains), two_states.lags(*gains)
        predicted, smoothed = float(v2.predicted_11), float(v2.updated_11)
        lag, poles = float(lag2.predicted_position_lag), two_states.poles(*gains)
    else:
        v3, lag3 = three_states.variances(*gains), three_states.lags(*gains)
        predicted, smoothed = float(v3.predicted_11), float(v3.updated_11)
        lag, poles = float(lag3.predicted_position_lag), three_states.poles(*gains)
    known = tuple(complex(pole) for pole in poles)
    left: float | None = 1 - max(map(abs, known))
    count: float | None = float(samples_to_settle(poles))
    if max(map(abs, known)) > decay.CLEAR:
        left = decay.distance(gains)
        count = None if left is None else decay.samples(left)
    stable = bool(is_stable(*gains))
    return Row(name, title, gains, predicted, smoothed, lag, known, stable, left, count, note)


def _rows(each: NamedFilter, kind: str, value: float) -> Iterator[Row | Absent]:
    """One filter at a value; two where two have the same alpha."""
    if kind in ("lag", "alpha"):
        reason = missing(each, kind, value)
        if reason is not None:
            yield Absent(each.name, each.title, f"does not exist: {reason}; got {value!s}")
            return
    beyond = out_of_reach(each, value) if kind == "lag" else None
    if beyond is not None:
        yield Absent(each.name, each.title, f"not computed: {beyond}; got {value!s}")
        return
    given = np.asarray(value)
    variances: Sequence[float | None] = (None,)
    try:
        if kind == "alpha":
            several = each.by_alpha(given)
            if each.variances_by_alpha is None:
                variances = (None,) * len(several)
            else:
                variances = [float(found) for found in each.variances_by_alpha(given)]
        elif kind == "tracking index":
            assert each.by_index is not None
            several = (each.by_index(given),)
            if each.variance_by_index is not None and is_stable(*several[0]):
                variances = (float(each.variance_by_index(given)),)
        else:
            several = (each.by_lag(given),)
            if each.variance_by_lag is not None:
                variances = (float(each.variance_by_lag(given)),)
    except ValueError as error:
        yield Absent(each.name, each.title, f"not computed: {error}")
        return
    notes = ("the slow one of the two of this alpha", "the fast one of the two of this alpha")
    told = notes if len(several) == 2 else ("",)
    for gains, note, variance in zip(several, told, variances, strict=True):
        if kind == "lag" and value <= each.kalman_above:
            note = "alpha is not below 1: stable, yet no steady state of a Kalman filter"
        known = [float(gain) for gain in gains]
        yield _safe(each, known, note, value if kind == "lag" else 1 / known[-1], variance)


def _at_lag_of(each: NamedFilter, reference: Row | None) -> Row | Absent:
    if reference is None:
        reason = "has no tracking index, and no filter before it has a lag to be shown at"
        return Absent(each.name, each.title, reason)
    reason_missing = missing(each, "lag", reference.lag)
    if reason_missing is not None:
        reason = f"at the lag of {reference.name}, {reference.lag!s}, it does not exist: "
        return Absent(each.name, each.title, reason + reason_missing)
    beyond = out_of_reach(each, reference.lag)
    if beyond is not None:
        told = f"not computed at the lag of {reference.name}, {reference.lag!s}: {beyond}"
        return Absent(each.name, each.title, told)
    gains = [float(gain) for gain in each.by_lag(np.asarray(reference.lag))]
    note = f"has no tracking index: at the lag of {reference.name}"
    by_lag = each.variance_by_lag
    variance = None if by_lag is None else float(by_lag(np.asarray(reference.lag)))
    return _safe(each, gains, note, reference.lag, variance)


def _safe(
    each: NamedFilter, gains: list[float], note: str, at: float | None, variance: float | None
) -> Row | Absent:
    """A row; with the variance of the lag, alpha or index itself, not that of rounded gains."""
    try:
        return row_of(each.name, each.title, gains, note, variance, at)
    except ValueError as error:
        return Absent(each.name, each.title, f"not computed, gains as rounded: {error}")
