"""The turning target of the lecture's figures: the scene, both filters, and the numbers told."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from gainproof import time_varying
from gainproof.figures.lecture import fixed_gain_track, kalman_track, turn
from gainproof.figures.lecture.scene import STANDARD_GRAVITY, Scene, Seen, seen
from gainproof.plots.table import Reals, Table
from gainproof.verify.oracles import fixed_gain

SCENE = Scene()


def test_the_target_flies_at_its_speed_and_turns_with_a_tenth_of_g() -> None:
    """By differences of a fine path, which know no circle."""
    fine = Scene(interval=0.5, last_sample=2200)
    path, step = fine.positions(), 0.5
    speed = np.linalg.norm(np.diff(path, axis=0), axis=-1) / step
    assert np.allclose(speed, 200, rtol=1e-6)
    bend = np.diff(path, n=2, axis=0) / step**2
    size, turning = np.linalg.norm(bend, axis=-1), fine.in_turn[1:-1]
    inside = turning[1:-1] & turning[:-2] & turning[2:]
    assert np.allclose(size[1:-1][inside], 0.1 * STANDARD_GRAVITY, rtol=1e-5)
    outside = ~(turning[1:-1] | turning[:-2] | turning[2:])
    assert np.abs(size[1:-1][outside]).max() < 1e-6
    right = path[1:-1] - path[:-2]
    assert (right[:, 0] * bend[:, 1] - right[:, 1] * bend[:, 0])[turning].max() < 0
    # from east to south
    assert np.allclose(path[1] - path[0], [100, 0])
    assert np.allclose(path[-1] - path[-2], [0, -100])


def test_what_is_seen_has_the_noise_of_the_lecture() -> None:
    """Chi-square and normal intervals of six deviations over 111 000 draws each."""
    drawn, true = seen(SCENE, 1000, 5), SCENE.positions()
    radial = (drawn.range - np.hypot(*true.T)) / 8.0
    turned = (drawn.bearing - np.arctan2(*true.T)) / np.deg2rad(0.06)
    for draws in (radial, turned):
        assert abs(draws.mean()) < 6 / np.sqrt(draws.size)
        assert abs((draws**2).mean() - 1) < 6 * np.sqrt(2 / draws.size)
    # bearings from north, clockwise
    east = Seen(np.array([[2.0]]), np.array([[np.pi / 2]]))
    assert np.allclose(east.positions, [[[2.0, 0.0]]])


def test_the_measured_covariance_is_that_of_the_draws() -> None:
    """At one place, to first order, against many draws."""
    scene = Scene(last_sample=1)
    drawn = seen(scene, 40_000, 6)
    place = np.cov(drawn.positions[:, 0].T)
    first = drawn.covariances(scene)[:, 0].mean(axis=0)
    assert np.allclose(first, place, atol=6 * np.sqrt(2 / 40_000) * np.trace(place))


def ahead(size: int, interval: float) -> Reals:
    """Position at every sample from the start's position and velocity and all increments."""
    samples = np.arange(float(size))
    counts = [np.ones(size), samples, *(samples[:, None] - samples[None, 1:]).clip(min=0).T]
    return np.asarray(np.stack(counts, axis=1) * np.array([1.0, *[interval] * size]))


@pytest.mark.parametrize("increment", [0.01, 10.0])
@pytest.mark.parametrize("size", [2, 3, 40])
def test_the_kalman_filter_is_the_batch_fit_of_all_samples(increment: float, size: int) -> None:
    """Generalised least squares for the start and every increment at once, both coordinates."""
    scene = Scene(last_sample=size - 1)
    drawn = seen(scene, 1, 7)
    measured, noise = drawn.positions[0], drawn.covariances(scene)[0]
    found = kalman_track.followed(drawn.positions, noise[None], 10.0, increment)[0, -1]
    path = np.kron(ahead(size, 10.0), np.eye(2))
    rooted = np.zeros((2 * size, 2 * size))
    for k in range(size):
        rooted[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = np.linalg.inv(np.linalg.cholesky(noise[k]))
    # of the increments we know that they are about zero
    known = np.eye(path.shape[1])[4:] / increment
    left = np.concatenate([rooted @ path, known])
    right = np.concatenate([rooted @ measured.ravel(), np.zeros(len(known))])
    scale = np.abs(left).max(axis=0)
    fitted = np.linalg.lstsq(left / scale, right, rcond=None)[0] / scale
    last = (path @ fitted)[-2:]
    assert np.abs(found - last).max() < 1e-5


def test_without_coupling_the_gains_are_those_of_the_kernel() -> None:
    """Noise of one variance in all directions: each coordinate is a filter of one dimension."""
    measured = np.random.default_rng(3).normal(0, 50, (1, 30, 2)).cumsum(axis=1)
    noise = np.broadcast_to(400.0 * np.eye(2), (1, 30, 2, 2))
    found = kalman_track.followed(measured, noise, 10.0, 3.0)[0]
    start = time_varying.start(10.0, 9.0, 400.0, process_noise="random-velocity")
    sequence = time_varying.gain_sequence(
        time_varying.predict(start, 10.0, 9.0, process_noise="random-velocity"),
        [10.0] * 27,
        9.0,
        400.0,
        process_noise="random-velocity",
    )
    alpha = np.concatenate([[1.0, 1.0], np.asarray(sequence.position_gain)])
    beta = np.concatenate([[0.0, 1.0], 10.0 * np.asarray(sequence.velocity_gain)])
    steps, _ = fixed_gain_track.followed(np.asarray(measured[0]), alpha, beta)
    assert np.abs(found - steps).max() < 1e-8


def test_gains_of_a_young_track_are_those_of_a_line() -> None:
    """Against polyfit on the samples so far; then the fixed pair."""
    alpha, beta = fixed_gain_track.handed_over(0.4571, 0.5, 20)
    young = 7
    assert (alpha[young:] == 0.4571).all()
    assert (beta[young:] == 0.5).all()
    assert (alpha[1:young] > 0.4571).all()
    measured = np.random.default_rng(2).normal(0, 5, (20, 3))
    position, velocity = fixed_gain_track.followed(measured, alpha, beta)
    for k in range(1, young):
        slope, last = np.polyfit(np.arange(-k, 1.0), measured[: k + 1], 1)
        assert np.allclose(position[k], last, atol=1e-12)
        assert np.allclose(velocity[k], slope, atol=1e-12)


def test_fixed_gains_run_as_their_matrix_says() -> None:
    """By powers of the closed loop from the eighth sample on."""
    measured = np.random.default_rng(4).normal(0, 5, 30)
    alpha, beta = 0.4571, 0.5
    position, velocity = fixed_gain_track.followed(measured, np.full(30, alpha), np.full(30, beta))
    gain = np.array([[alpha], [beta]])
    loop = (np.eye(2) - gain @ [[1.0, 0.0]]) @ [[1.0, 1.0], [0.0, 1.0]]
    state = np.linalg.matrix_power(loop, 21) @ [position[8], velocity[8]]
    for k in range(9, 30):
        state = state + (np.linalg.matrix_power(loop, 29 - k) @ gain)[:, 0] * measured[k]
    assert np.allclose(state, [position[29], velocity[29]], atol=1e-12)


@pytest.mark.parametrize("make", [turn.alpha_beta_turn, turn.kalman_turn])
def test_the_numbers_are_those_of_the_errors(make: Callable[[], Table]) -> None:
    """Small reacts late and is quiet before; large follows; means agree with the RMS columns."""
    table = make()
    inside = table["in_turn"] > 0
    assert inside.sum() == 32
    over = table.numbers["RMS position error over the turn (m), mean of 100 runs"]
    quiet = table.numbers["RMS position error over 10 samples before it (m), mean of 100 runs"]
    spread = table.numbers["RMS position error over the turn (m), its deviation from run to run"]
    for name in ("observed", "small", "large"):
        # the mean square of all is the mean of the runs' squares
        whole = np.mean(table[f"{name}_rms_m"][inside] ** 2)
        assert whole == pytest.approx(over[name] ** 2 + 0.99 * spread[name] ** 2, rel=1e-12)
    assert over["small"] > 50 * over["large"]
    assert quiet["small"] < 0.5 * quiet["large"] < 0.5 * quiet["observed"]
    away = np.hypot(table["large_x_m"] - table["true_x_m"], table["large_y_m"] - table["true_y_m"])
    assert 0.7 < np.sqrt(np.mean(away[inside] ** 2)) / over["large"] < 1.3
    assert any("200 m/s" in note for note in table.notes)


def test_what_the_lecture_gives_is_taken() -> None:
    """Slides on the alpha-beta and on the Kalman filter."""
    assert turn.GAINS == {"small": (0.095, 0.01), "large": (0.4571, 0.5)}
    assert turn.INCREMENTS == {"small": 0.01, "large": 10.0}
    assert SCENE.acceleration == pytest.approx(0.980665)
    given = (SCENE.interval, SCENE.range_deviation, np.rad2deg(SCENE.bearing_deviation))
    assert given == (10.0, 8.0, pytest.approx(0.06))


def test_the_lags_are_those_of_long_runs() -> None:
    told = turn.alpha_beta_turn().numbers["steady lag behind a constant 0.1 g (m), from the kernel"]
    for name, (alpha, beta) in turn.GAINS.items():
        _, updated = fixed_gain.steady_errors((Fraction(alpha), Fraction(beta)), 2, 20)
        assert told[name] == pytest.approx(98.0665 * float(updated[0]), rel=1e-12)


def test_bad_input_of_the_tracks_is_refused() -> None:
    with pytest.raises(ValueError, match="a gain for each of 3 samples, got 2 and 3"):
        fixed_gain_track.followed(np.zeros(3), np.ones(2), np.ones(3))
    with pytest.raises(ValueError, match="two measurements, got 1"):
        kalman_track.followed(np.zeros((1, 1, 2)), np.ones((1, 1, 2, 2)), 1.0, 1.0)
