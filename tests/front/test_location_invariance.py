"""The same target in other coordinates and units; what is warned of where linear models fail."""

from __future__ import annotations

from collections.abc import Callable

import location_cases as cases
import numpy as np
import one_of_each
import pytest

from gainproof.fixed_gain.arguments import Reals
from gainproof.location import diagonal, locate, observations, stations
from gainproof.location.example import example_observations, example_stations
from gainproof.location.stations import Observations, Stations

TURN = np.linalg.qr(np.random.default_rng(4).standard_normal((3, 3)))[0]
CHANGES: dict[str, tuple[Callable[[Reals], Reals], Callable[[Reals], Reals], float]] = {
    "turned": (lambda place: place @ TURN.T, lambda motion: motion @ TURN.T, 1.0),
    "far": (lambda place: place + 1e9, lambda motion: motion, 1.0),
    "tiny": (lambda place: place * 1e-8, lambda motion: motion * 1e-8, 1e-8),
    "huge": (lambda place: place * 1e8, lambda motion: motion * 1e8, 1e8),
}
"""Of positions, of velocities, of ranges and range rates."""


def scene() -> tuple[cases.Scene, Observations]:
    made = cases.random_scene(9, 3, 9)
    return made, made.observed(np.random.default_rng(1).standard_normal(18))


def changed(name: str) -> tuple[Stations, Observations]:
    place, motion, scale = CHANGES[name]
    made, observed = scene()
    given = stations(place(made.stations.positions), motion(made.stations.velocities))
    values = scale * observed.values
    covariance = scale**2 * observed.covariance
    return given, observations(given, values[:9], values[9:], covariance)


@pytest.mark.alike
@pytest.mark.parametrize(
    ("method", "name"),
    one_of_each.cases(
        [(method, name) for method in ("doppler-only", "unknown-reduction") for name in CHANGES],
        lambda case: case[0] == "unknown-reduction" or case[1] == "turned",
    ),
)
def test_a_change_of_coordinates_changes_the_answer_with_it(method: str, name: str) -> None:
    """Stations a million kilometres off the zero: their own last digit is 1e-7 m."""
    place, motion, scale = CHANGES[name]
    made, observed = scene()
    before = locate(made.stations, observed, method)
    after = locate(*changed(name), method)
    assert before.velocity is not None
    assert after.velocity is not None
    assert np.allclose(after.position, place(before.position), rtol=1e-9, atol=0)
    assert np.allclose(after.velocity, motion(before.velocity), rtol=1e-7)
    sizes = [np.linalg.eigvalsh(found.covariance[:3, :3]) for found in (before, after)]
    assert np.allclose(sizes[1], scale**2 * sizes[0], rtol=1e-6)


def test_an_observation_left_out_is_one_less() -> None:
    """None in the middle, and the covariance without its row and column."""
    made, observed = scene()
    keep = np.arange(18) != 3
    ranges = [None if i == 3 else value for i, value in enumerate(observed.values[:9].tolist())]
    fewer = observations(
        made.stations, ranges, observed.values[9:], observed.covariance[np.ix_(keep, keep)]
    )
    found = locate(made.stations, fewer, "bias-detection")
    assert [each.station for each in found.biases] == [
        "B1",
        "B2",
        "B3",
        *("B5", "B6", "B7", "B8", "B9"),
    ]
    whole = locate(made.stations, observed, "bias-detection")
    # a range whose bias is free says nothing, also where its noise is correlated with the others'
    assert np.allclose(found.position, whole.position, rtol=1e-9)
    # without noise both are at the truth
    true = made.true
    ranges = [None if i == 3 else value for i, value in enumerate(true[:9].tolist())]
    left = observed.covariance[np.ix_(keep, keep)]
    with_it = locate(
        made.stations,
        observations(made.stations, true[:9], true[9:], observed.covariance),
        "range-doppler",
    )
    without = locate(
        made.stations, observations(made.stations, ranges, true[9:], left), "range-doppler"
    )
    worse = without.covariance - with_it.covariance
    assert np.linalg.eigvalsh(worse).max() > 0
    assert np.linalg.eigvalsh(worse).min() > -1e-9 * np.abs(with_it.covariance).max()


def test_a_model_that_bends_within_its_deviations_is_told() -> None:
    """A range of 3 m with 10 m of deviation."""
    given = stations(np.array([[0, 0], [10e3, 0], [0, 10e3], [3e3, 3e3]]))
    place = np.array([3e3, 3e3 + 3.0])
    ranges = np.linalg.norm(place - given.positions, axis=1)
    noise = diagonal([10] * 4 + [0.1] * 4)
    beside = locate(given, observations(given, ranges, None, noise[:4, :4]), "range-only")
    assert "the covariance says little there" in " ".join(beside.warnings)
    quiet = example_observations()
    found = locate(example_stations(), quiet, "unknown-reduction")
    assert "says little" not in " ".join(found.warnings)


def test_multipath_everywhere_is_doubted() -> None:
    observed = example_observations(biases=(300, 400, 500, 600))
    told = " ".join(locate(example_stations(), observed).warnings)
    assert "only 0 of 4 ranges are taken as clean" in told


def test_a_velocity_that_is_hardly_observed_is_told() -> None:
    """A target passing within a metre of a row of stations."""
    given = stations([[0, 10e3], [10e3, 10e3], [20e3, 10e3], [40e3, 10e3]])
    noise = diagonal([10] * 4 + [0.1] * 4)
    observed = observations(given, [10e3, 30, 10e3, 30e3], [200, 0, -200, -200], noise)
    told = " ".join(locate(given, observed, "range-doppler").warnings)
    assert "one direction of it is hardly observed" in told
