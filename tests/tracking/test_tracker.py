"""The tracker as a whole: what every detection is told, how tracks begin and end."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples
from tracker_scene import Scene, drawn, judged

from gainproof.bad_input import BadInputError
from gainproof.generated import recursion_two_states
from gainproof.tracking import FILTERS, DetectionError, Measured, Polar, Settings, followed, scans
from gainproof.tracking.motion import Estimate, predicted, started, updated
from gainproof.tracking.nominal import nominal_point

SIGMAS = 50.0, float(np.deg2rad(0.5))
SMALL = Scene(targets=25, scans=30, false_alarms=4.0, bearing_deviation=SIGMAS[1], seed=5)


def one_by_one(detected: list[bool], **chosen: object) -> list[int]:
    """The track of each detection of a target that moves slowly, -1 for none."""
    t = 5.0 * np.arange(len(detected))
    seen = np.array(detected)
    far = 20e3 + 10.0 * t[seen]
    found = followed(
        scans(t[seen], far, np.full(far.size, 0.7), *SIGMAS, empty=t[~seen]),
        Settings(**chosen),  # type: ignore[arg-type]
    )
    return [int(number) for number in found.track]


def test_many_targets_are_followed() -> None:
    scene = drawn(SMALL)
    told = judged(scene, followed(scene.scans, Settings()), SMALL.targets)
    assert told.kept >= 24
    assert told.swaps <= 2
    assert told.lost < 0.02
    assert told.false_alarms <= 2


@given(st.integers(0, 2**32))
@settings(max_examples=samples(6), deadline=None)
def test_the_order_of_detections_within_a_scan_does_not_matter(seed: int) -> None:
    scene = drawn(Scene(targets=8, scans=12, false_alarms=3.0, seed=seed))
    first = followed(scene.scans, Settings())
    polar = scene.scans.polar
    times = np.repeat(scene.scans.times, np.diff(scene.scans.first))
    order = np.lexsort((np.random.default_rng(seed).random(times.size), times))
    mixed = polar.part(order)
    shuffled = scans(
        times[order],
        mixed.range,
        mixed.bearing,
        mixed.range_deviation,
        mixed.bearing_deviation,
    )
    second = followed(shuffled, Settings())
    assert np.array_equal(order[shuffled.row], np.arange(times.size))
    assert np.array_equal(first.track, second.track)
    assert np.array_equal(first.state, second.state, equal_nan=True)


def test_the_same_detections_give_the_same_bits() -> None:
    scene = drawn(SMALL)
    first, second = (followed(scene.scans, Settings()) for _ in range(2))
    assert first.state.tobytes() == second.state.tobytes()
    assert first.deviation.tobytes() == second.deviation.tobytes()


@pytest.mark.parametrize("name", FILTERS)
def test_a_quarter_turn_and_another_clock_change_nothing_else(name: str) -> None:
    """x becomes y: filters that take them apart, too; times a power of two later stay as exact."""
    scene = drawn(Scene(targets=10, scans=15, false_alarms=3.0, seed=11))
    first = followed(scene.scans, Settings(filter=name))
    polar = scene.scans.polar
    times = np.repeat(scene.scans.times, np.diff(scene.scans.first))
    bearing = np.remainder(polar.bearing + np.pi / 2, 2 * np.pi)
    sigmas = polar.range_deviation, polar.bearing_deviation
    turned = scans(times + 2.0**20, polar.range, bearing, *sigmas)
    second = followed(turned, Settings(filter=name))
    back = np.argsort(turned.row)
    told = second.track[back]
    assert np.array_equal(first.track < 0, told < 0)
    pairs = set(zip(first.track.tolist(), told.tolist(), strict=True))
    assert len(pairs) == len({a for a, _ in pairs}) == len({b for _, b in pairs})
    known = np.isfinite(first.state).all(-1)
    x, vx, y, vy = second.state[back][known].T
    assert np.allclose(first.state[known], np.stack([-y, -vy, x, vx], -1), rtol=1e-7, atol=1e-6)


def test_every_detection_has_one_track_or_none_and_a_track_one_detection_a_scan() -> None:
    scene = drawn(SMALL)
    found = followed(scene.scans, Settings())
    assert found.track.shape == scene.target.shape
    assert set(found.track.tolist()) == {-1, *found.tracks.tolist()}
    for _, places in scene.scans:
        own = found.track[places]
        own = own[own >= 0]
        assert np.unique(own).size == own.size
    assert np.isnan(found.state[found.track < 0]).all()
    assert np.isfinite(found.state[found.track >= 0][:, ::2]).all()


@pytest.mark.parametrize(
    ("detected", "confirm", "expected"),
    [
        ("110", (3, 4), [-1, -1]),
        ("1101", (3, 4), [0, 0, 0]),
        ("1011", (3, 4), [0, 0, 0]),
        ("11001111", (3, 4), [-1, -1, 0, 0, 0, 0]),
        ("11", (2, 2), [0, 0]),
        ("101", (2, 2), [-1, -1]),
        ("10001", (2, 5), [0, 0]),
    ],
)
def test_a_track_needs_m_of_n_detections(
    detected: str, confirm: tuple[int, int], expected: list[int]
) -> None:
    assert one_by_one([mark == "1" for mark in detected], confirm=confirm) == expected


@pytest.mark.parametrize(
    ("detected", "drop", "expected"),
    [
        ("111" + "0" * 4 + "111", 5, [0] * 6),
        ("111" + "0" * 5 + "111", 5, [0] * 3 + [1] * 3),
        ("111" + "0" + "111", 1, [0] * 3 + [1] * 3),
    ],
)
def test_a_track_ends_after_scans_without_a_detection(
    detected: str, drop: int, expected: list[int]
) -> None:
    assert one_by_one([mark == "1" for mark in detected], drop=drop) == expected


@pytest.mark.parametrize(("speed", "expected"), [(398.0, [0] * 4), (402.0, [-1] * 4)])
def test_a_target_faster_than_the_fastest_is_not_begun(speed: float, expected: list[int]) -> None:
    """Nearly without noise: the gate of a single detection ends at the speed."""
    t = 5.0 * np.arange(4)
    found = followed(scans(t, 20e3 + speed * t, np.full(4, 0.7), 0.1, 1e-6), Settings())
    assert found.track.tolist() == expected


def spread_of_draws(far: float, sigmas: tuple[float, float]) -> float:
    """Deviation of x of a target at 45 degrees, from draws: what the modified one is about."""
    noise = np.random.default_rng(8).standard_normal((2, 200_000))
    drawn_range, angle = far + sigmas[0] * noise[0], np.pi / 4 + sigmas[1] * noise[1]
    return float(np.std(np.concatenate([drawn_range * np.sin(angle), drawn_range * np.cos(angle)])))


def spread_of_differences(far: float, sigmas: tuple[float, float]) -> float:
    """The same to first order in the noise, by differences: what the classical one is about."""
    h = 1e-4
    along = (far * (1 + h) - far * (1 - h)) / (2 * h * far) * np.sin(np.pi / 4)
    across = far * (np.sin(np.pi / 4 + h) - np.sin(np.pi / 4 - h)) / (2 * h)
    return float(np.hypot(along * sigmas[0], across * sigmas[1]))


@pytest.mark.parametrize("bearing_deviation", [0.01, 0.5])
@pytest.mark.parametrize(
    ("conversion", "spread", "rel"),
    [
        ("modified-unbiased", spread_of_draws, 5e-3),
        ("classical", spread_of_differences, 1e-7),
    ],
)
def test_the_nominal_point_is_that_of_the_chosen_conversion(
    conversion: str,
    spread: Callable[[float, tuple[float, float]], float],
    rel: float,
    bearing_deviation: float,
) -> None:
    given = scans([0.0, 4.0], [20e3, 30e3], [0.0, 0.0], 50.0, bearing_deviation)
    for chosen, far in ((None, 25e3), (40e3, 40e3)):
        point = nominal_point(given, Settings(nominal_range=chosen, conversion=conversion))
        index = 0.98 * 16 / spread(far, (50.0, bearing_deviation))
        assert point.index.tolist() == pytest.approx([index, index], rel=rel)


def test_a_nominal_range_far_from_all_detections_refuses_none() -> None:
    """At 1e9 m the variances along and across are 1e14 apart; each detection has a covariance."""
    given = scans([0.0, 4.0], [20e3, 30e3], [0.0, 0.0], 1.0, 0.01)
    found = followed(given, Settings(nominal_range=1e9))
    assert np.isfinite(nominal_point(given, Settings(nominal_range=1e9)).alpha).all()
    assert found.track.tolist() == [-1, -1]


def test_nothing_detected_gives_no_track() -> None:
    found = followed(scans([], [], [], *SIGMAS, empty=[0.0, 5.0]), Settings())
    assert found.track.size == found.tracks.size == 0


def measured(position: list[float], covariance: list[list[float]]) -> Measured:
    none = np.zeros(1)
    return Measured(
        np.array([position]),
        np.array([covariance]),
        np.zeros((1, 2)),
        Polar(none, none, none, none),
    )


def test_the_start_and_the_steps_are_those_of_the_printed_recursion() -> None:
    """x and y apart, as the kernels have them."""
    t, sigma, r = 4.0, 1.3, (40.0**2, 90.0**2)
    noise = [[r[0], 0.0], [0.0, r[1]]]
    two = started(
        np.zeros((1, 2)), np.array([noise]), measured([3.0, 4.0], noise), np.array([t]), sigma
    )
    assert two.state[0].tolist() == [3.0, 0.75, 4.0, 1.0]
    interval = np.array([t])
    before = predicted(two, interval, sigma)
    gain = np.zeros((1, 4, 2))
    for axis in (0, 1):
        factors = recursion_two_states.start_random_acceleration(t, sigma**2, r[axis])
        whole = np.array(recursion_two_states.covariance(*factors))
        place = slice(2 * axis, 2 * axis + 2)
        assert np.allclose(two.covariance[0, place, place].ravel()[[0, 1, 3]], whole, rtol=1e-12)
        ahead = recursion_two_states.predict_random_acceleration(*factors, t, sigma**2)
        whole = np.array(recursion_two_states.covariance(*ahead))
        assert np.allclose(before.covariance[0, place, place].ravel()[[0, 1, 3]], whole, rtol=1e-12)
        gain[0, place, axis] = recursion_two_states.gains(*ahead, r[axis])[:2]
    after = updated(before, gain, measured([9.0, 9.0], noise))
    ahead = recursion_two_states.predict_random_acceleration(
        *recursion_two_states.start_random_acceleration(t, sigma**2, r[1]), t, sigma**2
    )
    updated_factors = recursion_two_states.update(*ahead, r[1])
    whole = np.array(recursion_two_states.covariance(*updated_factors))
    assert np.allclose(after.covariance[0, 2:, 2:].ravel()[[0, 1, 3]], whole, rtol=1e-12)


def test_josephs_form_holds_for_any_gain() -> None:
    """Errors of a linear update, drawn: their covariance is the one that is carried."""
    draw = np.random.default_rng(7)
    root = draw.standard_normal((4, 4))
    noise_root = draw.standard_normal((2, 2))
    covariance, noise = root @ root.T, noise_root @ noise_root.T
    gain = draw.uniform(0, 1, (4, 2))
    found = updated(
        Estimate(np.zeros((1, 4)), covariance[None]),
        gain[None],
        measured([0.0, 0.0], noise.tolist()),
    ).covariance[0]
    errors = draw.standard_normal((40_000, 4)) @ root.T
    measured_errors = draw.standard_normal((40_000, 2)) @ noise_root.T
    left = errors - (errors[:, ::2] - measured_errors) @ gain.T
    assert np.allclose(left.T @ left / len(left), found, atol=0.06 * found.max())


@pytest.mark.parametrize(
    ("numbers", "field", "message"),
    [
        ({"time": [0.0, np.nan]}, "time", "a time of magnitude up to"),
        ({"time": [5.0, 0.0]}, "time", "times in order, got 0 s after 5 s"),
        ({"time": [0.0, 1e-9]}, "time", "scans are at least 1e-06 s apart"),
        ({"far": [1e4, 0.0]}, "range", "wanted a number from 1e-09 to"),
        ({"far": [1e4, -1e4]}, "range", "wanted a number from 1e-09 to"),
        ({"far": [1e4, np.inf]}, "range", "wanted a number from 1e-09 to"),
        ({"bearing": [0.0, 7.0]}, "bearing", "within one turn"),
        ({"bearing": [0.0, np.nan]}, "bearing", "within one turn"),
        ({"sigma_range": [50.0, 0.0]}, "sigma_range", "wanted a number from 1e-09 to"),
        ({"sigma_bearing": [0.1, 2.5]}, "sigma_bearing", "to 2 rad, got 2.5"),
        ({"sigma_bearing": [0.1, -0.1]}, "sigma_bearing", "wanted a number from 1e-09 to"),
        ({"time": [5.0, 5.0]}, "range", "the same detection twice"),
    ],
)
def test_detections_that_cannot_be_used_are_named(
    numbers: dict[str, list[float]], field: str, message: str
) -> None:
    given = {
        "time": [0.0, 5.0],
        "far": [1e4, 1e4],
        "bearing": [0.1, 0.1],
        "sigma_range": [50.0, 50.0],
        "sigma_bearing": [0.01, 0.01],
    } | numbers
    with pytest.raises(DetectionError, match=message) as caught:
        scans(*given.values())
    assert (caught.value.row, caught.value.field) == (1, field)


@pytest.mark.parametrize(
    ("chosen", "message"),
    [
        ({"filter": "kalmann"}, "nearest: kalman"),
        ({"conversion": "unbias"}, "nearest: unbiased"),
        ({"gate": 1.0}, "probability between 0 and 1"),
        ({"gate": float("nan")}, "probability between 0 and 1"),
        ({"gate": 1e-300}, "at least 1e-12 from both"),
        ({"acceleration": 0.0}, "the acceleration is between"),
        ({"most_speed": float("inf")}, "the speed is between"),
        ({"nominal_range": -1.0}, "the nominal range is between"),
        ({"confirm": (1, 4)}, "M from 2 to N and N up to 64"),
        ({"confirm": (5, 4)}, "M from 2 to N and N up to 64"),
        ({"drop": 0}, "dropped after 1 to 64"),
    ],
)
def test_settings_that_cannot_be_used_are_named(chosen: dict[str, object], message: str) -> None:
    with pytest.raises(BadInputError, match=message):
        Settings(**chosen)  # type: ignore[arg-type]
