"""What cannot be estimated is named: counts, directions, stations hit, iterations that fail."""

from __future__ import annotations

import numpy as np
import pytest
from one_of_each import cases
from samples import samples

from gainproof.fixed_gain.arguments import Reals
from gainproof.location import (
    METHODS,
    DivergedError,
    Location,
    LocationError,
    OnStationError,
    TooFewError,
    UnobservableError,
    diagonal,
    locate,
    observations,
    stations,
)
from gainproof.location.stations import Observations, Stations

LINE = [[0, 0], [1e4, 0], [2e4, 0], [3e4, 0], [4e4, 0]]
AROUND = [[0, 0], [1e4, 0], [1e4, 3e4], [0, 2e4], [5e3, 1e3]]
LEVEL = [
    *([0, 0, 0], [1e4, 0, 0], [1e4, 3e4, 0], [0, 2e4, 0], [5e3, 1e3, 0], [3e4, 1e4, 0]),
    [2e4, 3e4, 0],
]
LONG = [[1e4 * i, 0, 0] for i in range(7)]
MIRRORED: dict[int, tuple[object, list[float], list[float]]] = {
    2: (LINE, [5e3, 7e3], [100, 50]),
    3: (LEVEL, [6e3, 9e3, 5e3], [100, 20, 5]),
}
ALL = tuple(method.name for method in METHODS)
WITH_RATES = tuple(name for name in ALL if name != "range-only")


def seen(
    places: object, target: object, velocity: object, motion: object = None, noise: float = 0.0
) -> tuple[Stations, Observations]:
    """10 m and 0.1 m/s of deviation; the noise is drawn."""
    given = stations(np.array(places, float), motion)  # type: ignore[arg-type]
    n = len(given.names)
    apart = np.array(target, float) - given.positions
    distance = np.linalg.norm(apart, axis=1)
    moving = np.array(velocity, float) - given.velocities
    rate = (apart * moving).sum(axis=1) / np.where(distance > 0, distance, 1)
    drawn = noise * np.random.default_rng(1).standard_normal(2 * n)
    drawn *= [10] * n + [0.1] * n
    covariance = diagonal([10] * n + [0.1] * n)
    return given, observations(given, distance + drawn[:n], rate + drawn[n:], covariance)


def unobserved(problem: tuple[Stations, Observations], method: str) -> UnobservableError:
    with pytest.raises(UnobservableError) as caught:
        locate(*problem, method)
    return caught.value


def spans(error: UnobservableError, wanted: list[list[float]]) -> bool:
    """Whether the error's directions span the same space of position and velocity."""
    named = np.array([(*each.position, *each.velocity) for each in error.directions])
    both = np.vstack([named, wanted])
    return int(np.linalg.matrix_rank(both, 1e-6)) == len(named) == len(wanted)


@pytest.mark.alike
@pytest.mark.parametrize("method", ALL)
def test_stations_on_a_line_with_the_target_on_it(method: str) -> None:
    error = unobserved(seen(LINE, [5e3, 0], [100, 50]), method)
    assert "position along y" in str(error)
    assert "the stations lie on a line and the target on it" in str(error)


@pytest.mark.parametrize("method", WITH_RATES)
def test_all_stations_in_one_place(method: str) -> None:
    error = unobserved(seen([[0, 0]] * 5, [5e3, 3e3], [100, 50]), method)
    assert "position along y and velocity along y" in str(error)
    assert "all stations are in one place" in str(error)


@pytest.mark.parametrize("method", ["unknown-reduction", "bias-detection", "doppler-only"])
def test_nothing_moves(method: str) -> None:
    error = unobserved(seen(AROUND, [6e3, 9e3], [0, 0]), method)
    assert spans(error, [[1, 0, 0, 0], [0, 1, 0, 0]])
    assert "the scaled rank is 2 of 4" in str(error)
    assert "nothing moves" in str(error)
    assert ("the biases of B1" in str(error)) == (method != "doppler-only")


@pytest.mark.parametrize("method", ["unknown-reduction", "bias-detection", "doppler-only"])
def test_all_motion_is_along_the_lines_of_sight(method: str) -> None:
    angles = np.array([0.3, 0.7, 1.9, 3.0, 4.4])
    sight = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    target = np.array([6e3, 9e3])
    motion = np.array([10.0, 20.0]) - 30 * sight
    error = unobserved(seen(target - 1e4 * sight, target, [10, 20], motion), method)
    assert spans(error, [[1, 0, 0, 0], [0, 1, 0, 0]])
    assert "all motion is along the lines of sight" in str(error)


@pytest.mark.parametrize("method", ALL)
def test_stations_in_a_plane_with_the_target_in_it(method: str) -> None:
    error = unobserved(seen(LEVEL, [6e3, 9e3, 0], [100, 20, 0]), method)
    assert "position along z" in str(error)
    assert "the stations lie in a plane and the target on it" in str(error)


@pytest.mark.parametrize("method", WITH_RATES)
def test_stations_on_a_line_in_space(method: str) -> None:
    """Turned around the line nothing changes: one direction of position, one of velocity."""
    error = unobserved(seen(LONG, [6e3, 9e3, 3e3], [100, 20, 10]), method)
    assert len(error.directions) == 2
    assert "the scaled rank is 4 of 6" in str(error)


def test_a_bias_that_all_ranges_share_follows_a_free_direction() -> None:
    """One station and one direction: a longer distance is a larger bias."""
    error = unobserved(seen([[0, 0]] * 5, [5e3, 0], [100, 50]), "common-bias")
    (first, *_) = error.directions
    assert np.allclose(first.position, [1, 0])
    ((station, bias),) = first.biases
    assert (station, round(bias, 9)) == ("all stations", -1)


@pytest.mark.parametrize(
    ("method", "ranges", "rates", "need", "have", "words"),
    [
        ("doppler-only", 3, 3, 4, 3, "at least 4 range rates for position and velocity"),
        ("bias-detection", 3, 3, 4, 3, "a range whose bias is unknown does not count"),
        ("unknown-reduction", 5, 3, 4, 3, "there are 3"),
        ("range-doppler", 1, 2, 4, 3, "at least 4 ranges and range rates"),
        ("range-doppler", 4, 1, 2, 1, "for velocity, of which ranges say nothing"),
        ("common-bias", 2, 2, 5, 4, "for position and velocity and the common bias"),
        ("range-only", 1, 5, 2, 1, "at least 2 ranges for position"),
        ("range-only", 0, 5, 2, 0, "needs ranges, there are none"),
        ("doppler-only", 5, 0, 4, 0, "needs range rates, there are none"),
    ],
)
def test_counts_are_told_before_anything_is_solved(
    method: str, ranges: int, rates: int, need: int, have: int, words: str
) -> None:
    given, full = seen(AROUND, [6e3, 9e3], [100, 50])
    values = full.values.tolist()
    fewer = observations(
        given,
        [value if i < ranges else None for i, value in enumerate(values[:5])],
        [value if i < rates else None for i, value in enumerate(values[5:])],
        diagonal([10] * ranges + [0.1] * rates),
    )
    with pytest.raises(TooFewError, match=words) as caught:
        locate(given, fewer, method)
    assert (caught.value.need, caught.value.have) == (need, have)


@pytest.mark.parametrize("method", cases(ALL, {"unknown-reduction", "range-only"}.__contains__))
def test_a_target_on_a_station(method: str) -> None:
    with pytest.raises(OnStationError, match="B5") as caught:
        locate(*seen(AROUND, [5e3, 1e3 + 1e-9], [100, 50]), method)
    assert caught.value.station == "B5"
    with pytest.raises(ValueError, match=r"ranges of B5 must be above 0, got 0\.0"):
        seen(AROUND, [5e3, 1e3], [100, 50])


def test_an_iteration_that_does_not_settle_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    from gainproof.location import gauss_newton, levenberg_marquardt, newton

    monkeypatch.setattr(gauss_newton, "MOST_ITERATIONS", 1)
    monkeypatch.setattr(levenberg_marquardt, "MOST_DAMPED", 0)
    monkeypatch.setattr(newton, "MOST_STARTS", 0)
    with pytest.raises(DivergedError, match="did not converge from any of") as caught:
        locate(*seen(AROUND, [6e3, 9e3], [100, 50], noise=3.0), "range-doppler")
    assert caught.value.report.iterations == 1
    assert caught.value.report.cost > 0


@pytest.mark.parametrize(
    ("method", "d"),
    cases(
        [(method, d) for method in ALL for d in (2, 3)],
        lambda case: case in {("unknown-reduction", 3), ("range-only", 3), ("range-doppler", 2)},
    ),
)
def test_a_mirror_image_is_a_warning(method: str, d: int) -> None:
    """On the upper side unless asked for the other; the image's observations are the same."""
    places, target, velocity = MIRRORED[d]
    given, observed = seen(places, target, velocity, noise=0.5)
    found = locate(given, observed, method)
    assert found.position[-1] > 0
    (warning,) = (each for each in found.warnings if "mirror" in each)
    what = "line" if len(target) == 2 else "plane"
    assert f"the mirror image in the {what} of the stations" in warning
    image = found.others[0]
    flipped = np.array([*[1] * (len(target) - 1), -1])
    assert np.allclose(image.position, found.position * flipped, rtol=1e-6)
    assert image.cost == pytest.approx(found.convergence.cost, rel=1e-6, abs=1e-9)
    below = locate(given, observed, method, near=[*target[:-1], -target[-1]])
    assert np.allclose(below.position, image.position, rtol=1e-9)
    if found.velocity is not None and image.velocity is not None:
        assert np.allclose(image.velocity, found.velocity * flipped, rtol=1e-4)


def test_stations_that_move_out_of_their_line_leave_no_mirror_image() -> None:
    motion = np.array([[0, 30], [0, -50], [0, 10], [0, 80], [0, -20]])
    found = locate(*seen(LINE, [5e3, 7e3], [100, 50], motion), "range-doppler")
    assert found.warnings == ()
    assert np.allclose(found.position, [5e3, 7e3])


@pytest.mark.sampled
def test_nothing_that_comes_out_is_no_number() -> None:
    """Targets on and beside lines, planes and stations, quiet and fast: an answer or an error."""
    random = np.random.default_rng(7)
    answers = 0
    for case in range(samples(3)):
        d = 2 + case % 2
        places = random.uniform(-1e4, 1e4, (2 * d + 1, d))
        places[:, -1] *= [0, 1e-6, 1e-3][case % 3]
        target = random.uniform(-1e4, 1e4, d)
        target[-1] *= [1, 0, 1e-3][case % 3]
        velocity = random.uniform(-1, 1, d) * 10.0 ** random.integers(-2, 4)
        told = told_or_not(*seen(places, target, velocity, noise=1.0), ALL[case % len(ALL)])
        answers += isinstance(told, Location)
        if isinstance(told, Location):
            assert all(np.isfinite(part).all() for part in numbers(told)), case
        else:
            assert "nan" not in told
    assert answers > 0


def told_or_not(given: Stations, observed: Observations, method: str) -> Location | str:
    """The estimate, or why there is none."""
    try:
        return locate(given, observed, method)
    except LocationError as error:
        return str(error)


def numbers(found: Location) -> list[Reals]:
    velocity = np.zeros(0) if found.velocity is None else found.velocity
    return [found.position, velocity, found.covariance, np.array(found.convergence.cost)]
