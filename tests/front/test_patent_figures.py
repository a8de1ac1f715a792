"""The patent's experiment: indices and gains against plain recursions, the runs, the page."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import plain_tracking as plain
import pytest

from gainproof.figures import (
    patent_drift,
    patent_errors,
    patent_gains,
    patent_limits,
    patent_runs,
    patent_scene,
)
from gainproof.plots.table import Table
from gainproof.tracking.conversion import converted
from gainproof.tracking.gains import kalman
from gainproof.tracking.measured import Measured
from gainproof.tracking.motion import predicted, updated

PAGE = Path(__file__).resolve().parents[2] / "docs" / "track.md"


@cache
def comparison() -> Table:
    return patent_errors.comparison()


def test_figure_5_is_the_index_of_the_moments() -> None:
    """The covariance at the measurement from a hundred thousand draws of range and bearing."""
    draw = np.random.default_rng(5)
    table = patent_gains.figure_5()
    for far in (5e3, 40e3):
        (row,) = np.flatnonzero(table["range_m"] == far)
        drawn = far + 50 * draw.standard_normal(100_000)
        angle = np.deg2rad(draw.standard_normal(100_000))
        for name, values in (("along", drawn * np.cos(angle)), ("across", drawn * np.sin(angle))):
            index = 0.98 * 25 / values.std()
            assert table[f"index_{name}"][row] == pytest.approx(index, rel=0.01)


@pytest.mark.parametrize("which", [0, 1])
def test_figures_6_and_7_are_gains_and_slopes_of_the_recursion(which: int) -> None:
    table = (patent_gains.figure_6, patent_gains.figure_7)[which]()
    far, index = table["range_m"], table["index"]
    for name, nominal in patent_scene.NOMINAL.items():
        (at,) = np.flatnonzero(far == nominal)
        gain = plain.steady_gains(float(index[at]))[which]
        slope = plain.steady_slopes(float(index[at]))[which]
        for column in ("exact", f"fixed_{name}", f"constant_{name}", f"recursive_{name}"):
            assert table[column][at] == pytest.approx(gain, rel=1e-9)
        for place in (0, 100, 396):
            expected = gain + slope * (index[place] - index[at])
            assert table[f"constant_{name}"][place] == pytest.approx(expected, rel=1e-6)
        assert (table[f"constant_{name}"] >= table["exact"] * (1 - 1e-12)).all()
        first = plain.steady_slopes(float(index[at - 5]))[which]
        expected = gain + slope * (index[at - 5] - index[at])
        assert table[f"recursive_{name}"][at - 5] == pytest.approx(expected, rel=1e-6)
        if at >= 10:
            expected += first * (index[at - 10] - index[at - 5])
            assert table[f"recursive_{name}"][at - 10] == pytest.approx(expected, rel=1e-6)


def test_limits_are_where_the_gains_of_the_recursion_say() -> None:
    """A tangent reaches 1, and 4 = 2 alpha + beta, at the ratios told."""
    told = patent_limits.limits().numbers
    for name, index in told["index at the nominal points"].items():
        gains, slopes = plain.steady_gains(index), plain.steady_slopes(index)
        ratios = told[f"ratios at the {name} nominal point"]
        alpha, beta = (
            [gains[k] + slopes[k] * index * (ratios[which] - 1) for k in (0, 1)]
            for which in ("alpha_one_ratio", "unstable_ratio")
        )
        assert alpha[0] == pytest.approx(1, rel=1e-6)
        assert 2 * beta[0] + beta[1] == pytest.approx(4, rel=1e-6)
        for k, which in enumerate(("alpha_gain_ratio", "beta_gain_ratio")):
            there = index * ratios[which]
            exact = plain.steady_gains(there)[k]
            assert gains[k] + slopes[k] * (there - index) - exact == pytest.approx(
                exact - gains[k], rel=1e-6
            )
    name_of = "range (m) within which the constant update has alpha above 1"
    shown = patent_gains.figure_6().numbers[name_of]
    assert [round(shown[name] / 1e3, 1) for name in ("far", "middle")] == [7.5, 4.6]
    assert shown["near"] == "never"


def index_at(far: float) -> tuple[float, float, float]:
    """Along the line of sight, across it and of x at 45 degrees: by moments of the noise at the
    measurement, which is normal. The mean of cos(2 v) is exp(-2 s^2), v of deviation s.
    """
    square, s = far**2 + 50.0**2, math.radians(1.0)
    mean = far * math.exp(-(s**2) / 2)
    along = square * (1 + math.exp(-2 * s**2)) / 2 - mean**2
    across = square * -math.expm1(-2 * s**2) / 2
    first, second, third = (0.98 * 25 / x**0.5 for x in (along, across, (along + across) / 2))
    return first, second, third


def test_the_page_has_the_indices_and_ratios_of_the_moments() -> None:
    """Where alpha passes 1 and the filter is unstable: on the tangent of the recursion's gains."""
    text = " ".join(PAGE.read_text(encoding="utf-8").split())
    at_80, at_40, at_5, near = (index_at(far) for far in (80e3, 40e3, 5e3, 1e3))
    crossed = {}
    for name, nominal in (("far", at_80[2]), ("middle", at_40[2])):
        (a, b), (da, db) = plain.steady_gains(nominal), plain.steady_slopes(nominal)
        crossed[name] = (
            1 + (1 - a) / (da * nominal),
            1 + (4 - 2 * a - b) / ((2 * da + db) * nominal),
        )
    far, middle = crossed["far"], crossed["middle"]
    within = next(d for d in range(80_000, 1_000, -10) if index_at(d)[0] > far[1] * at_80[2])
    assert index_at(100e3)[0] > far[0] * at_80[2]
    assert index_at(100e3)[0] > middle[0] * at_40[2]
    assert near[0] < middle[1] * at_40[2]
    for words in (
        f"the index of x and y at 45° grows from {at_80[2]:.3f} to {at_5[2]:.2f} (figure 5)",
        f"at 80 km the index along is {at_80[0] / at_80[1]:.0f} times that across",
        f"from {near[0]:.2f} near the radar to {at_80[0]:.2f} at 80 km",
        f"{near[0] / at_80[2]:.1f} to {at_80[0] / at_80[2]:.1f} times that of the far nominal",
        f"Alpha exceeds 1 from {far[0]:.1f} times on, so at any range up to 100 km",
        f"unstable from {far[1]:.1f} times on, so within {within / 1e3:.1f} km",
        f"whose index is {at_40[2]:.3f}, it is {near[0] / at_40[2]:.1f} times at most",
        f"(from {middle[0]:.1f} times on), and unstable ({middle[1]:.1f}) it is at no range",
    ):
        assert words in text


def test_the_page_has_the_indices_and_ratios_of_the_kernels() -> None:
    """Those numbers of the page are what its figures show."""
    table, limits = patent_gains.figure_5(), patent_limits.limits().numbers
    for far in (1e3, 5e3, 40e3, 80e3):
        (row,) = np.flatnonzero(table["range_m"] == far)
        told = [table[f"index_{name}"][row] for name in ("along", "across", "45")]
        assert told == pytest.approx(index_at(far), rel=1e-6)
    assert limits["ratios at the far nominal point"]["unstable_ratio"] == pytest.approx(
        18.988, abs=1e-3
    )


def test_the_recursive_update_drifts_upwards() -> None:
    table = patent_drift.drift()
    for key in ("40_km_at_5_deg", "80_km_at_2_deg"):
        median = table[f"alpha_median_{key}"]
        assert (np.diff(median[::60]) > 0).all()
    near = table["alpha_high_40_km_at_45_deg"]
    assert near[-1] - near[0] < 0.02
    passed = [
        table["time_s"][np.flatnonzero(table[f"alpha_median_{key}"] > 1)[0]] / 60
        for key in ("40_km_at_5_deg", "80_km_at_2_deg")
    ]
    assert 14 < passed[0] < 22
    assert 5 < passed[1] < 10
    shares = table.numbers["share of runs with alpha above 1 or unstable, 40 km at 5°"]
    assert shares["after 30 min"] == 1


def test_one_run_is_that_of_plain_loops() -> None:
    given = patent_scene.seen("crossing")
    found = patent_runs.outcomes("crossing")
    times = (patent_scene.INTERVAL * np.arange(patent_scene.SAMPLES)).tolist()
    run = 7
    place = given.measured.position[:, run]
    noise = given.measured.covariance[:, run].tolist()
    columns = [[[float(a)], [float(b)]] for a, b in place]
    truth = given.truth.position[:, 0]
    track = plain.kalman_track(times, columns, noise, patent_scene.ACCELERATION)
    for k, (state, _) in enumerate(track, 1):
        off = (state[0] - truth[k, 0]) ** 2 + (state[2] - truth[k, 1]) ** 2
        assert found["kalman"].position[k, run] == pytest.approx(off, rel=1e-6)
    nominal = patent_scene.nominal_points()["far"]
    gains = plain.steady_gains(float(nominal.index[0, 0]))
    fixed = plain.fixed_gain_track(times, columns, [(gains, gains)] * len(times))
    for k, state in enumerate(fixed, 1):
        off = (state[0] - truth[k, 0]) ** 2 + (state[2] - truth[k, 1]) ** 2
        assert found["fixed, far"].position[k, run] == pytest.approx(off, rel=1e-6)


def promised(given: patent_scene.Seen, seen: Measured) -> tuple[float, float]:
    """RMS position error of the Kalman filter, and what its covariances say it should be."""
    kept = patent_runs._start(seen)
    interval = np.full(patent_scene.RUNS, patent_scene.INTERVAL)
    errors, told = [], []
    for k in range(2, patent_scene.SAMPLES):
        before = predicted(kept, interval, patent_scene.ACCELERATION)
        now = seen.part(k)
        kept = updated(before, kalman(now, before.covariance), now)
        off = kept.state[:, ::2] - given.truth.position[k]
        errors.append(np.sum(off**2, -1))
        told.append(kept.covariance[:, 0, 0] + kept.covariance[:, 2, 2])
    part = slice(patent_scene.SETTLED - 2, None)
    return float(np.mean(errors[part]) ** 0.5), float(np.mean(told[part]) ** 0.5)


def test_the_kalman_filter_keeps_its_promise_where_its_covariances_know_no_noise() -> None:
    """On the path it is made for, with the conversion's covariance at the true place. At the
    measured place the covariance follows the noise, and the errors are larger than it says.
    """
    given = patent_scene.seen("manoeuvring")
    x, y = np.moveaxis(given.truth.position, -1, 0)
    true = converted(patent_scene.polar(np.hypot(x, y), np.arctan2(x, y)))
    known = replace(given.measured, covariance=true.covariance)
    error, told = promised(given, known)
    assert error == pytest.approx(told, rel=0.04)
    error, told = promised(given, given.measured)
    assert 1.03 < error / told < 1.12
    table = comparison()
    (row,) = np.flatnonzero(
        (np.array(table.words("path")) == "manoeuvring")
        & (np.array(table.words("filter")) == "kalman")
    )
    assert table["rms_position_m"][row] == pytest.approx(error, rel=1e-12)


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    """Of 400 drawn samples of squares of normal numbers, whose root mean square is 1."""
    draw = np.random.default_rng(9)
    squares = draw.standard_normal((400, 500)) ** 2
    found = patent_runs.rms(squares)
    held = np.mean((found.lower <= 1) & (found.upper >= 1))
    assert 0.91 < held < 0.985
    other = draw.standard_normal((400, 500)) ** 2 + squares
    quotient = patent_runs.ratio(squares, other)
    held = np.mean((quotient.lower <= 0.5**0.5) & (quotient.upper >= 0.5**0.5))
    assert 0.91 < held < 0.985


def test_the_page_has_the_numbers_of_the_runs() -> None:
    text = PAGE.read_text(encoding="utf-8")
    table = comparison()
    paths = [*patent_scene.PATHS]
    for kind, unit, step in (("position", "m", 1.0), ("velocity", "m_s", 0.1)):
        head = f"| RMS {kind} error, {unit.replace('_', '/')} | {' | '.join(paths)} |"
        rows = text.partition(head)[2].partition("\n\n")[0].strip().splitlines()[1:]
        shown = {row.split("|")[1].strip(): row.split("|")[2:6] for row in rows}
        assert set(shown) == set(table.words("filter"))
        for i, (path, name) in enumerate(
            zip(table.words("path"), table.words("filter"), strict=True)
        ):
            middle, half = (float(x) for x in shown[name][paths.index(path)].split("±"))
            column = f"rms_{kind}_{unit}"
            reach = (table[f"{column}_upper"][i] - table[f"{column}_lower"][i]) / 2
            assert middle == pytest.approx(table[column][i], abs=0.51 * step)
            assert half == pytest.approx(reach, abs=0.51 * step)
    assert re.search(r"500 seeded\s+runs", text)
