"""The tracker: scan by scan, detections become tracks (figure 1 of the source)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from gainproof.tracking import gains
from gainproof.tracking.arrays import Bools, Ints, Reals
from gainproof.tracking.association import assigned
from gainproof.tracking.conversion import NoCovarianceError, converted
from gainproof.tracking.gains import Point, Sample
from gainproof.tracking.gating import Pairs, gated, threshold
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import POSITION, Estimate, predicted, started, updated
from gainproof.tracking.nominal import nominal_point
from gainproof.tracking.scans import Scans
from gainproof.tracking.settings import Settings
from gainproof.tracking.tracks import Tracks, no_tracks


@dataclass(frozen=True)
class Followed:
    """What became of detections: track (n,), the number of each one's track, from 0 in the order of
    first detections, -1 for none; state (n, 4) and deviation (n, 4) of that track after it, NaN
    where unknown. tracks: those that were confirmed. limited: updates whose gains of first order
    were not stable with alpha at most 1.
    """

    track: Ints
    state: Reals
    deviation: Reals
    tracks: Ints
    limited: int


def followed(
    scans: Scans, settings: Settings, at: Callable[[float, Tracks], None] | None = None
) -> Followed:
    """All scans, one after the other. ``at`` is called with time and tracks after each.

    Raises ValueError where a conversion is outside its domain or an estimate has a variance that is
    not above 0, BadInputError without SciPy.
    """
    seen = converted(scans.polar, settings.conversion)
    nominal = nominal_point(scans, settings)
    limit = threshold(settings.gate)
    n = len(seen.position)
    number = np.full(n, -1)
    state, deviation = np.full((n, 4), np.nan), np.full((n, 4), np.nan)
    tracks, born, outside, settled = no_tracks(), 0, 0, []
    for time, places in scans:
        try:
            done = after_scan(tracks, seen.part(places), time, nominal, settings, limit, born)
        except NoCovarianceError as error:
            place = places.start + error.place
            raise NoCovarianceError(str(error), place, error.field) from None
        tracks, born = done.tracks, done.born
        number[places] = done.number
        state[places], deviation[places] = done.state, done.deviation
        outside += done.limited
        settled.append(done.confirmed)
        if at is not None:
            at(time, tracks)
    confirmed = np.unique(np.concatenate([*settled, np.zeros(0, np.int64)]))
    return _numbered(number, state, deviation, confirmed, outside)


@dataclass(frozen=True)
class AfterScan:
    """Tracks after a scan; of each detection the number of its track and the estimate after it;
    how many numbers are taken; the numbers confirmed by now; updates with limited gains.
    """

    tracks: Tracks
    number: Ints
    state: Reals
    deviation: Reals
    born: int
    confirmed: Ints
    limited: int


def after_scan(
    tracks: Tracks,
    seen: Measured,
    time: float,
    nominal: Point,
    settings: Settings,
    limit: float,
    born: int,
) -> AfterScan:
    """One scan: predict, gate, associate, update, begin, confirm and drop."""
    before = predicted(tracks.estimate, time - tracks.time, settings.acceleration)
    detection = associated(tracks, gated(before, seen, limit), len(seen.position), limit)
    hit = detection >= 0
    tracks, outside = _updated(tracks, before, seen, detection, time, nominal, settings)
    tracks = _counted(tracks, hit)
    number = np.full(len(seen.position), -1)
    state = np.full((len(seen.position), 4), np.nan)
    deviation = state.copy()
    used = detection[hit]
    number[used] = tracks.number[hit]
    state[used] = tracks.estimate.state[hit]
    deviation[used] = _deviations(tracks.estimate.part(hit), used)
    free = np.flatnonzero(number < 0)
    new = _begun(seen.part(free), time, born, settings, limit)
    number[free] = new.number
    begun_at = new.estimate
    state[free, ::2] = begun_at.state[:, ::2]
    deviation[free, ::2] = np.sqrt(np.diagonal(begun_at.covariance, axis1=1, axis2=2))[:, ::2]
    tracks, kept = _judged(tracks, settings)
    confirmed = tracks.number[tracks.confirmed]
    tracks = tracks.part(kept).with_more(new)
    return AfterScan(tracks, number, state, deviation, born + len(free), confirmed, outside)


def associated(tracks: Tracks, pairs: Pairs, detections: int, limit: float) -> Ints:
    """For each track its detection or -1: confirmed tracks choose first, beginnings last."""
    ranks = _rank(tracks)
    found = np.full(len(tracks), -1)
    free = np.ones(detections, np.bool_)
    for turn in range(3):
        own = (ranks[pairs.track] == turn) & free[pairs.detection]
        if not own.any():
            continue
        chosen = assigned(len(tracks), pairs.part(own), limit)
        taken = chosen >= 0
        found[taken] = chosen[taken]
        free[chosen[taken]] = False
    return found


def _updated(
    tracks: Tracks,
    before: Estimate,
    seen: Measured,
    detection: Ints,
    time: float,
    nominal: Point,
    settings: Settings,
) -> tuple[Tracks, int]:
    """Estimates and points of the tracks that have a detection, with its time."""
    moving, fresh = ((detection >= 0) & which for which in (tracks.hits > 1, tracks.hits == 1))
    estimate, point, outside = tracks.estimate, tracks.point, 0
    if fresh.any():
        two = started(
            estimate.state[fresh, POSITION],
            estimate.covariance[fresh, POSITION, POSITION],
            seen.part(detection[fresh]),
            time - tracks.time[fresh],
            settings.acceleration,
        )
        estimate, point = estimate.changed(fresh, two), point.changed(fresh, nominal)
    if moving.any():
        sample = Sample(
            seen.part(detection[moving]),
            time - tracks.time[moving],
            settings.acceleration,
            before.covariance[moving],
            nominal,
            point.part(moving),
            tracks.hits[moving],
        )
        gain, last, outside = gains.FILTERS[settings.filter](sample)
        estimate = estimate.changed(moving, updated(before.part(moving), gain, sample.seen))
        point = point.changed(moving, last)
    when = np.where(detection >= 0, time, tracks.time)
    return replace(tracks, time=when, estimate=estimate, point=point), outside


def _numbered(
    number: Ints, state: Reals, deviation: Reals, confirmed: Ints, outside: int
) -> Followed:
    """Numbers of the confirmed tracks alone, without gaps."""
    known: Bools = np.isin(number, confirmed)
    new = np.where(known, np.searchsorted(confirmed, number), -1)
    state, deviation = (np.where(known[:, None], x, np.nan) for x in (state, deviation))
    return Followed(new, state, deviation, np.arange(len(confirmed)), outside)


_NAMES = (("x", "m"), ("the velocity along x", "m/s"), ("y", "m"), ("the velocity along y", "m/s"))


def _deviations(after: Estimate, detection: Ints) -> Reals:
    """(n, 4) of estimates after the detections of one scan, whose places are `detection`, (n,).

    Raises NoCovarianceError where a variance is not above 0, or a number is not finite: rounding
    took more digits than there are.
    """
    variances = np.diagonal(after.covariance, axis1=1, axis2=2)
    sound = (variances > 0) & np.isfinite(variances) & np.isfinite(after.state)
    if not sound.all():
        row, which = np.unravel_index(int(np.argmin(sound)), sound.shape)
        name, unit = _NAMES[int(which)]
        raise NoCovarianceError(
            f"the variance of {name} after this detection is to be above 0 and finite, got "
            f"{variances[row, which]:.3g} ({unit})^2 at {after.state[row, which]:.6g} {unit}: "
            "deviations, intervals and --acceleration are further apart than float64 has digits",
            int(detection[row]),
            field="",
        )
    return np.sqrt(variances)


def _rank(tracks: Tracks) -> Ints:
    """Who chooses a detection first: 0 confirmed tracks, 1 those with a velocity, 2 beginnings."""
    return np.where(tracks.confirmed, 0, np.where(tracks.hits > 1, 1, 2))


def _counted(tracks: Tracks, detected: Bools) -> Tracks:
    """A scan later, with or without a detection."""
    return replace(
        tracks,
        hits=tracks.hits + detected,
        age=tracks.age + 1,
        missed=np.where(detected, 0, tracks.missed + 1),
    )


def _judged(tracks: Tracks, settings: Settings) -> tuple[Tracks, Bools]:
    """Confirmed where the detections suffice, with which are kept: a confirmed track until it was
    missed too often in a row, another one as long as it can still be confirmed.
    """
    needed, scans = settings.confirm
    confirmed = tracks.confirmed | (tracks.hits >= needed)
    hopeful = scans - tracks.age + tracks.hits >= needed
    kept = np.where(confirmed, tracks.missed < settings.drop, hopeful)
    return replace(tracks, confirmed=confirmed), kept


def _begun(seen: Measured, time: float, first: int, settings: Settings, limit: float) -> Tracks:
    """A beginning for each detection, numbered from ``first``.

    Its velocity is unknown: taken as 0 with a deviation that puts the fastest target at the border
    of the gate.
    """
    n = len(seen.position)
    state = np.zeros((n, 4))
    state[:, POSITION] = seen.position
    covariance = np.zeros((n, 4, 4))
    covariance[:, POSITION, POSITION] = seen.covariance
    covariance[:, (1, 3), (1, 3)] = settings.most_speed**2 / limit
    whole = np.ones(n, np.int64)
    unknown = np.full((n, 2), np.nan)
    return Tracks(
        first + np.arange(n),
        np.zeros(n, np.bool_),
        np.full(n, time),
        whole,
        whole,
        0 * whole,
        Estimate(state, covariance),
        Point(unknown, unknown, unknown),
    )
