"""Jacobians of many targets and stations: shapes, signs, derivatives, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gainproof.generated import range_doppler
from gainproof.location.errors import OnStationError
from gainproof.location.jacobians import Jacobians, range_doppler_jacobians


def states(seed: int, *shape: int) -> np.ndarray:
    generator = np.random.default_rng(seed)
    half = shape[-1] // 2
    scale = np.array([1e4] * half + [300.0] * half)
    return np.asarray(generator.normal(0, 1, shape) * scale)


def plain(target: np.ndarray, station: np.ndarray) -> tuple[complex, complex]:
    """Range and range rate by Pythagoras and the chain rule, of complex numbers too."""
    half = len(target) // 2
    place, velocity = (target - station)[:half], (target - station)[half:]
    distance = np.sqrt((place * place).sum())
    return distance, (place * velocity).sum() / distance


def complex_step(target: np.ndarray, station: np.ndarray, by_station: bool) -> np.ndarray:
    """The derivatives of both, (2, s): imaginary parts, which nothing is subtracted for."""
    columns = []
    for number in range(len(target)):
        step = np.zeros(len(target), complex)
        step[number] = 1e-30j
        moved = (target, station + step) if by_station else (target + step, station)
        columns.append([value.imag / 1e-30 for value in plain(*moved)])
    return np.array(columns).T


@pytest.mark.parametrize("size", [4, 6])
@pytest.mark.parametrize("moving", [False, True])
def test_against_complex_steps(size: int, moving: bool) -> None:
    targets = states(1, 7, size)
    stations = states(2, 7, 5, size) if moving else states(2, 5, size)
    found = range_doppler_jacobians(targets, stations)
    assert found.slant_range.shape == found.range_rate.shape == (7, 5)
    assert found.range_D_target.shape == found.rate_D_target.shape == (7, 5, size)
    for i in range(7):
        for j in range(5):
            station = stations[i, j] if moving else stations[j]
            values = plain(targets[i], station)
            assert found.slant_range[i, j] == pytest.approx(values[0], rel=1e-14)
            assert found.range_rate[i, j] == pytest.approx(values[1], rel=1e-12, abs=1e-12)
            for by_station, slopes in (
                (False, (found.range_D_target, found.rate_D_target)),
                (True, (found.range_D_station, found.rate_D_station)),
            ):
                exact = complex_step(targets[i], station, by_station)
                for row, slope in zip(exact, slopes, strict=True):
                    assert np.allclose(slope[i, j], row, rtol=1e-10, atol=1e-14)


def test_the_numbers_are_those_of_the_kernel() -> None:
    targets, stations = states(3, 4, 6), states(4, 3, 6)
    found = range_doppler_jacobians(targets, stations)
    for i, target in enumerate(targets):
        for j, station in enumerate(stations):
            one = range_doppler.range_doppler(*target, *station)
            numbers = [float(value) for value in one]
            assert found.slant_range[i, j] == one.slant_range
            assert found.range_rate[i, j] == one.range_rate
            assert np.array_equal(found.range_D_target[i, j], [*numbers[2:5], 0, 0, 0])
            assert np.array_equal(found.rate_D_target[i, j], [*numbers[5:8], *numbers[2:5]])


def test_single_precision_stays_and_lists_become_double() -> None:
    targets, stations = states(5, 3, 6).astype("f4"), states(6, 2, 6).astype("f4")
    assert all(each.dtype == np.float32 for each in range_doppler_jacobians(targets, stations))
    mixed = range_doppler_jacobians(targets, stations.astype("f8"))
    assert all(each.dtype == np.float64 for each in mixed)
    listed = range_doppler_jacobians([[3, 4, 10, 0]], [[0, 0, 0, 0]])
    assert listed.slant_range.tolist() == [[5.0]]
    assert listed.range_rate.tolist() == [[6.0]]


def test_no_target_and_no_station() -> None:
    for targets, stations in (
        (np.zeros((0, 6)), states(1, 2, 6)),
        (states(1, 2, 6), np.zeros((0, 6))),
    ):
        found = range_doppler_jacobians(targets, stations)
        assert found.rate_D_target.shape == (len(targets), len(stations), 6)


def test_nothing_given_is_changed() -> None:
    targets, stations = states(7, 3, 6), states(8, 2, 6)
    before = targets.copy(), stations.copy()
    range_doppler_jacobians(targets, stations)
    assert np.array_equal(targets, before[0])
    assert np.array_equal(stations, before[1])


def test_a_target_on_a_station_is_named() -> None:
    targets, stations = states(9, 4, 6), states(10, 3, 6)
    targets[2, :3] = stations[1, :3]
    with pytest.raises(
        OnStationError, match="target 2 is on station 1: where a range is 0"
    ) as error:
        range_doppler_jacobians(targets, stations)
    assert error.value.station == "1"
    near = np.array([[1e-7, 0, 0, 1, 1, 1]], np.float32)
    with pytest.raises(OnStationError, match="target 0 is on station 0"):
        range_doppler_jacobians(near, np.zeros((1, 6), np.float32))
    assert range_doppler_jacobians(near, np.zeros((1, 6))).slant_range[0, 0] == pytest.approx(1e-7)


@pytest.mark.parametrize(
    ("targets", "stations", "words"),
    [
        (np.zeros(6), np.zeros((2, 6)), r"wanted targets \(N, 6\) or \(N, 4\) and stations"),
        (np.zeros((3, 6)), np.zeros(6), r"got targets \(3, 6\) and stations \(6,\)"),
        (np.zeros((3, 6)), np.zeros((2, 4)), "must have 6 numbers, or both 4"),
        (np.zeros((3, 5)), np.zeros((2, 5)), "must have 6 numbers, or both 4"),
        (np.zeros((3, 6)), np.zeros((2, 2, 6)), r"stations \(N, m, 6\) are wanted for as many"),
        ([[1, 2, 3, 4], [1, 2]], np.zeros((2, 4)), "targets must be an array, got rows of unlike"),
        ([[1, 2, math.nan, 4]], [[0, 0, 0, 0]], r"targets must be finite .* nan at index \(0, 2\)"),
        (
            [[1, 2, 3, 4]],
            [[0, 0, 0, math.inf]],
            r"stations must be finite .* inf at index \(0, 3\)",
        ),
        ([[1, 2e60, 3, 4]], [[0, 0, 0, 0]], r"target_y must be of magnitude at most 1e60"),
    ],
)
def test_what_does_not_fit(targets: object, stations: object, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        range_doppler_jacobians(targets, stations)  # type: ignore[arg-type]


@pytest.mark.parametrize("given", [np.zeros((1, 6), complex), [["a"] * 6], np.zeros((1, 6), "f2")])
def test_what_is_not_real(given: object) -> None:
    with pytest.raises(TypeError, match="targets must be real numbers of float64 or float32, got"):
        range_doppler_jacobians(given, np.ones((1, 6)))  # type: ignore[arg-type]


def test_stations_are_the_negatives() -> None:
    found = range_doppler_jacobians(states(11, 2, 4), states(12, 3, 4))
    assert isinstance(found, Jacobians)
    assert np.array_equal(found.range_D_station, -found.range_D_target)
    assert np.array_equal(found.rate_D_station, -found.rate_D_target)
