"""Filters over arrays of tracks against one target in plain loops."""

from __future__ import annotations

import numpy as np
import plain_tracking as plain
import pytest

from gainproof.tracking import FILTERS, Scans, Settings, followed, scans
from gainproof.tracking.conversion import converted
from gainproof.tracking.gains import constant_point, exact_point, is_usable, limited
from gainproof.tracking.nominal import nominal_point

SIGMA = 0.98
INTERVAL = 5.0
SAMPLES = 24
ABOVE = 1e-9
NOMINAL = 10e3
"""Near enough for the update of first order to stay stable: along the line of sight the index is
large at any range.
"""
GAINS = ("fixed", "exact", "first-order-constant", "first-order-recursive")


def one_target(seed: int = 3) -> Scans:
    draw = np.random.default_rng(seed)
    t = INTERVAL * np.arange(SAMPLES)
    x, y = -20e3 + 180 * t, 30e3 - 120 * t
    far = np.hypot(x, y) + 50 * draw.standard_normal(SAMPLES)
    bearing = np.arctan2(x, y) + np.deg2rad(1) * draw.standard_normal(SAMPLES)
    return scans(t, far, bearing, 50.0, np.deg2rad(1.0))


def columns(given: Scans) -> tuple[list[float], list[plain.Matrix], list[plain.Matrix]]:
    seen = converted(given.polar)
    places = [[[float(a)], [float(b)]] for a, b in seen.position]
    return given.times.tolist(), places, seen.covariance.tolist()


def test_kalman_is_the_textbook_filter() -> None:
    given = one_target()
    found = followed(given, Settings(filter="kalman"))
    assert found.track.tolist() == [0] * SAMPLES
    truth = plain.kalman_track(*columns(given), SIGMA)
    for k, (state, covariance) in enumerate(truth, 1):
        assert np.allclose(found.state[k], state, rtol=ABOVE)
        deviation = [covariance[i][i] ** 0.5 for i in range(4)]
        assert np.allclose(found.deviation[k], deviation, rtol=ABOVE)


def expected_gains(given: Scans, name: str) -> list[tuple[tuple[float, float], ...]]:
    """alpha, beta of x and y at each sample, from the recursion run to its end."""
    variances = converted(given.polar).variances
    index = SIGMA * INTERVAL**2 / np.sqrt(variances)
    nominal = float(nominal_point(given, Settings(nominal_range=NOMINAL)).index[0])
    gains = plain.steady_gains(nominal)
    slopes = plain.steady_slopes(nominal)
    found = []
    kept = {0: (nominal, *gains), 1: (nominal, *gains)}
    for k in range(SAMPLES):
        pair = []
        for axis in (0, 1):
            here = float(index[k, axis])
            if name == "fixed":
                pair.append(gains)
            elif name == "exact":
                pair.append(plain.steady_gains(here))
            elif name == "first-order-constant":
                step = here - nominal
                pair.append((gains[0] + slopes[0] * step, gains[1] + slopes[1] * step))
            else:
                last, alpha, beta = kept[axis]
                if k >= 2:
                    slope = plain.steady_slopes(last)
                    alpha, beta = (
                        alpha + slope[0] * (here - last),
                        beta + slope[1] * (here - last),
                    )
                    kept[axis] = here, alpha, beta
                pair.append((alpha, beta))
        found.append(tuple(pair))
    return found


@pytest.mark.parametrize(
    "name", ["fixed", "exact", "first-order-constant", "first-order-recursive"]
)
def test_gains_of_the_index_are_those_of_the_recursion(name: str) -> None:
    given = one_target()
    found = followed(given, Settings(filter=name, nominal_range=NOMINAL))
    assert found.limited == 0
    times, places, _ = columns(given)
    gains = expected_gains(given, name)
    truth = plain.fixed_gain_track(times, places, [(a, b) for a, b in gains])
    assert np.allclose(found.state[1:], truth, rtol=1e-6)


def test_gains_along_and_across_the_line_of_sight() -> None:
    """Each detection's innovation turned to the line of sight by a complex number."""
    given = one_target()
    found = followed(given, Settings(filter="line-of-sight"))
    seen = converted(given.polar)
    _, places, _ = columns(given)
    t = INTERVAL
    z = [complex(b[0], a[0]) for a, b in places]  # north + i east: the angle is the bearing
    place, speed = z[1], (z[1] - z[0]) / t
    for k in range(2, SAMPLES):
        ahead = place + t * speed
        turn = np.exp(-1j * given.polar.bearing[k])
        off = (z[k] - ahead) * turn
        parts = []
        for variance, part in zip(seen.sight[k], (off.real, off.imag), strict=True):
            alpha, beta = plain.steady_gains(SIGMA * t * t / float(variance) ** 0.5)
            line = plain.line_gains(k)
            if line[0] >= alpha:
                alpha, beta = line
            parts.append((alpha * part, beta * part / t))
        place = ahead + complex(parts[0][0], parts[1][0]) / turn
        speed += complex(parts[0][1], parts[1][1]) / turn
        assert np.allclose(found.state[k, ::2], [place.imag, place.real], rtol=1e-7)
        assert np.allclose(found.state[k, 1::2], [speed.imag, speed.real], rtol=1e-6)


def test_gains_of_first_order_that_are_not_stable_are_replaced_and_counted() -> None:
    near = exact_point(np.array([0.02, 0.02]))
    far_off = constant_point(near, np.array([[0.03, 0.03], [3.0, 0.03], [3.0, 3.0]]))
    assert far_off.alpha[1, 0] > 1
    found, others = limited(far_off)
    assert others == 2
    assert is_usable(found).all()
    exact = exact_point(far_off.index)
    assert found.alpha[1, 0] == exact.alpha[1, 0]
    assert found.alpha[1, 1] == far_off.alpha[1, 1]


@pytest.mark.parametrize("name", FILTERS)
def test_every_filter_keeps_a_track_and_its_covariance_positive(name: str) -> None:
    given = one_target(4)
    found = followed(given, Settings(filter=name))
    assert found.track.tolist() == [0] * SAMPLES
    assert (found.deviation[1:] > 0).all()
    truth = np.stack([-20e3 + 180 * given.times, 30e3 - 120 * given.times], -1)
    off = (found.state[:, ::2] - truth) / found.deviation[:, ::2]
    assert np.sqrt(np.mean(off[5:] ** 2)) < 2.5
