"""The numbers of the turning target as two filters see it, each with a slow and a fast choice.

One seeded run is shown; the errors are those of a hundred runs.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gainproof.figures.lecture import fixed_gain_track, kalman_track
from gainproof.figures.lecture.scene import Scene, Seen, seen
from gainproof.generated import alpha_beta
from gainproof.plots.table import Column, Reals, Table

RUNS = 100
SEED = 18
GAINS: Mapping[str, tuple[float, float]] = {"small": (0.095, 0.01), "large": (0.4571, 0.5)}
"""alpha and beta as the lecture gives them."""
INCREMENTS: Mapping[str, float] = {"small": 0.01, "large": 10.0}
"""The lecture's driving noise n_x = n_y in m/s."""
SETTLED = 10
"""Samples before the turn in which errors are told too."""


def alpha_beta_turn() -> Table:
    """The alpha-beta filter with the small and the large pair of gains."""
    scene = Scene()
    drawn = seen(scene, RUNS, SEED)
    measured = np.moveaxis(drawn.positions, 1, 0)
    tracks = {}
    for name, (alpha, beta) in GAINS.items():
        gains = fixed_gain_track.handed_over(alpha, beta, len(measured))
        tracks[name] = np.moveaxis(fixed_gain_track.followed(measured, *gains)[0], 0, 1)
    unit = scene.acceleration * scene.interval**2
    lags = {
        name: unit * float(alpha_beta.lags(*gains).updated_position_lag)
        for name, gains in GAINS.items()
    }
    return _table(
        "Turning target, alpha-beta filter with small and large gains",
        scene,
        drawn,
        tracks,
        {"steady lag behind a constant 0.1 g (m), from the kernel": lags},
        (
            "alpha and beta are the lecture's; the same gains in x and in y.",
            "Ours: least-squares gains first, until their alpha falls below the fixed one.",
        ),
    )


def kalman_turn() -> Table:
    """The Kalman filter of constant velocity with small and large driving noise."""
    scene = Scene()
    drawn = seen(scene, RUNS, SEED)
    noise = drawn.covariances(scene)
    tracks = {
        name: kalman_track.followed(drawn.positions, noise, scene.interval, increment)
        for name, increment in INCREMENTS.items()
    }
    return _table(
        "Turning target, Kalman filter (constant velocity) with small and large driving noise",
        scene,
        drawn,
        tracks,
        {},
        (
            "Driving noise n_x = n_y = 0.01 m/s and 10 m/s is the lecture's.",
            "Ours: it is the deviation of an increment of each velocity at every sample.",
            "Ours: the covariance of the measured x and y is to first order, at the measurement.",
            "Ours: the track starts with the first two measurements.",
        ),
    )


def rms(errors: Reals) -> Reals:
    """The root of the mean square over the last axis."""
    return np.asarray(np.sqrt(np.mean(errors**2, axis=-1)))


def _table(
    title: str,
    scene: Scene,
    drawn: Seen,
    tracks: Mapping[str, Reals],
    more: Mapping[str, object],
    notes: tuple[str, ...],
) -> Table:
    true = scene.positions()
    shown = {"observed": drawn.positions, **tracks}
    errors = {name: np.linalg.norm(track - true, axis=-1) for name, track in shown.items()}
    columns = [
        Column("time_s", "seconds since the first sample", scene.times),
        Column("in_turn", "1 while the target turns", scene.in_turn.astype(float)),
        *_pair("true", "the target, m east and north of the radar", true),
        Column("observed_range_m", "measured range of the run shown", drawn.range[0]),
        Column(
            "observed_bearing_deg",
            "measured bearing from north of the run shown",
            np.rad2deg(drawn.bearing[0]),
        ),
        *(
            column
            for name, track in shown.items()
            for column in _pair(name, f"{name}: position in the run shown", track[0])
        ),
        *(
            Column(f"{name}_rms_m", f"{name}: RMS position error of {RUNS} runs", rms(error.T))
            for name, error in errors.items()
        ),
    ]
    turn = scene.in_turn
    before = (scene.times <= scene.turn_begins) & (
        scene.times > scene.turn_begins - SETTLED * scene.interval
    )
    numbers: dict[str, object] = {}
    for stretch, words in ((turn, "over the turn"), (before, f"over {SETTLED} samples before it")):
        each = {name: rms(error[:, stretch]) for name, error in errors.items()}
        numbers[f"RMS position error {words} (m), mean of {RUNS} runs"] = {
            name: float(values.mean()) for name, values in each.items()
        }
        numbers[f"RMS position error {words} (m), its deviation from run to run"] = {
            name: float(values.std(ddof=1)) for name, values in each.items()
        }
    return Table(title, tuple(columns), {**numbers, **more}, (*_scene_notes(scene), *notes))


def _pair(name: str, meaning: str, positions: Reals) -> list[Column]:
    return [Column(f"{name}_{axis}_m", meaning, positions[:, k]) for k, axis in enumerate("xy")]


def _scene_notes(scene: Scene) -> tuple[str, ...]:
    x, y = (value / 1e3 for value in scene.start)
    degrees = np.rad2deg([scene.heading, scene.turned, scene.bearing_deviation])
    heading, turned, deviation = (f"{value:g}" for value in degrees.tolist())
    return (
        f"The lecture gives a turn of 0.1 g and sampling every {scene.interval:g} s,",
        f"noise of {scene.range_deviation:g} m in range and {deviation} degrees in bearing.",
        f"Ours: {scene.speed:g} m/s, start {x:g} km east and {y:g} km north of the radar,",
        f"heading {heading} degrees, turning right by {turned} after {scene.turn_begins:g} s,",
        f"{scene.last_sample + 1} samples, all in one plane; seed {SEED}, {RUNS} runs.",
        "Smoothed positions are shown; normal noise, independent from sample to sample.",
    )
