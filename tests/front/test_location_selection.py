"""The chi-square test of a bias beside SciPy's distributions; covariances that are none."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from samples import samples

from gainproof.fixed_gain.arguments import Reals
from gainproof.location import LocationError, locate
from gainproof.location.example import STATIONS, example_observations, example_stations
from gainproof.location.noise import diagonal, whitening
from gainproof.location.result import Location, Place
from gainproof.location.selection import detection, exceeded, threshold
from gainproof.location.stations import Observations, Stations, observations, stations


@pytest.mark.parametrize("false_alarm", [1e-200, 1e-12, 1e-3, 0.05, 0.5, 0.999])
def test_the_threshold_is_the_quantile(false_alarm: float) -> None:
    from scipy import stats  # half a second, in every process that collects

    assert threshold(false_alarm) == pytest.approx(stats.chi2.isf(false_alarm, 1), rel=1e-12)


def test_five_per_cent_is_the_papers_number() -> None:
    assert f"{threshold(0.05):.2f}" == "3.84"


@pytest.mark.parametrize("false_alarm", [0.0, 1.0, -0.1, float("nan")])
def test_what_is_no_probability_is_refused(false_alarm: float) -> None:
    with pytest.raises(ValueError, match="between 0 and 1"):
        threshold(false_alarm)
    with pytest.raises(ValueError, match="between 0 and 1"):
        locate(example_stations(), example_observations(), false_alarm=false_alarm)


@pytest.mark.parametrize("bias", [0.0, 3.0, -25.0, 60.0])
def test_detection_is_the_noncentral_chi_square(bias: float) -> None:
    from scipy import stats  # half a second, in every process that collects

    wanted = stats.ncx2.sf(threshold(0.05), 1, (bias / 13) ** 2) if bias else 0.05
    assert detection(bias, 13, 0.05) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("freedom", [1, 2, 3, 4, 7, 10, 41])
@pytest.mark.parametrize("cost", [0.0, 1e-9, 0.3, 4.0, 30.0, 400.0])
def test_how_often_noise_gives_more(cost: float, freedom: int) -> None:
    from scipy import stats  # half a second, in every process that collects

    wanted = stats.chi2.sf(cost, freedom)
    assert exceeded(cost, freedom) == pytest.approx(wanted, rel=1e-11, abs=1e-300)


def test_the_example_finds_its_two_biased_ranges() -> None:
    found = locate(example_stations(), example_observations())
    assert found.selection is not None
    assert found.selection.clean == ("B1", "B2")
    assert [each.station for each in found.biases] == ["B3", "B4"]
    assert found.first is not None
    for decision, bias in zip(found.selection.decisions, found.first.biases, strict=True):
        assert decision.statistic == (bias.value / bias.deviation) ** 2
        assert decision.clean == (decision.statistic <= found.selection.threshold)
    rare = locate(example_stations(), example_observations(), false_alarm=1e-30)
    assert rare.selection is not None
    assert rare.selection.clean == ("B1", "B2", "B3", "B4")
    (told,) = [each for each in rare.warnings if "residuals are larger than their noise" in each]
    assert told.endswith("bias-detection gives every range a bias of its own")


@pytest.mark.parametrize(
    ("method", "next_step"),
    [
        ("range-doppler", "The method unknown-reduction looks for such biases"),
        ("common-bias", "The method unknown-reduction looks for such biases"),
        ("range-only", "The method unknown-reduction, with range rates, looks for such biases"),
        ("bias-detection", "the range rates do not fit each other"),
        ("doppler-only", "the range rates do not fit each other"),
    ],
)
def test_residuals_that_are_too_large_come_with_a_next_step(method: str, next_step: str) -> None:
    """A fifth station whose range rate is wrong by thirty deviations."""
    given = stations([*STATIONS, (20e3, 0.0)])
    seen = example_observations().values
    five = observations(
        given, [*seen[:4], 14142.0], [*seen[4:], -138.4], diagonal([10.0] * 5 + [0.1] * 5)
    )
    (told,) = [each for each in locate(given, five, method).warnings if "larger than" in each]
    assert told.endswith(next_step)


def test_ranges_too_short_for_multipath_are_named() -> None:
    short = example_observations(biases=(-5000.0, 0.0, 120.0, -12000.0))
    found = locate(example_stations(), short)
    (told,) = [each for each in found.warnings if "too short" in each]
    # within five of their deviations, which are below 20 m
    first, fourth = map(float, re.findall(r"B1 by (\d+) m, B4 by (\d+) m\. Multipath", told)[0])
    assert abs(first - 5000) < 100
    assert abs(fourth - 12000) < 100
    assert not any(
        "too short" in each for each in locate(example_stations(), four_deviations()).warnings
    )
    common = locate(example_stations(), example_observations(biases=(-5e3,) * 4), "common-bias")
    assert not any("too short" in each for each in common.warnings)


def four_deviations() -> Observations:
    """Noise of four deviations, no bias."""
    return example_observations(biases=(0.0,) * 4, range_noise=(-4.0, 0.0, 0.0, 0.0))


def test_white_is_white() -> None:
    noise = diagonal([10, 20, 0.1, 1e-9], [0.3, -0.999999])
    white = whitening(noise)
    assert np.allclose(white @ noise @ white.T, np.eye(4), atol=1e-9)


@pytest.mark.parametrize(
    ("noise", "message"),
    [
        (
            [[1, 0.5], [0.4, 1]],
            "number 1 with number 2 has 0.5, number 2 with number 1 0.4",
        ),
        ([[1, 2], [2, 1]], "positive definite: the least eigenvalue of its correlations is -1"),
        ([[1, 1], [1, 1]], "positive definite"),
        ([[1, 0], [0, 0]], r"the variance of number 2 must be above 0, got 0\.0"),
        ([[1, 0], [0, -4]], "the variance of number 2 must be above 0"),
        ([[1, 0, 0], [0, 1, 0]], r"square matrix, got shape \(2, 3\)"),
        ([[1, float("nan")], [0, 1]], "must be finite"),
    ],
)
def test_a_covariance_that_is_none_is_named(noise: list[list[float]], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        whitening(noise)


def test_a_probability_that_no_number_holds_is_not_told_as_none() -> None:
    """Deviations a thousand times too small: the cost is beyond what any noise gives."""
    observed = example_observations()
    sure = replace(observed, covariance=observed.covariance * 1e-6)
    found = locate(example_stations(), sure, "range-doppler")
    (told,) = [each for each in found.warnings if "larger than their noise" in each]
    assert " in less than 2e-308 of all cases" in told


def places_that_explain(seed: int, size: int) -> tuple[Stations, Observations, Reals]:
    """A target among stations, noise of 20 m and 0.5 m/s, no multipath; its state."""
    chance = np.random.default_rng(seed)
    given = stations(chance.uniform(-20e3, 30e3, (size, 2)))
    place, velocity = chance.uniform(-10e3, 20e3, 2), chance.uniform(-150, 150, 2)
    apart = place - given.positions
    far = np.linalg.norm(apart, axis=1)
    ranges = far + 20 * chance.standard_normal(size)
    rates = (apart @ velocity) / far + 0.5 * chance.standard_normal(size)
    noise = diagonal([20.0] * size + [0.5] * size)
    return given, observations(given, ranges, rates, noise), np.concatenate([place, velocity])


def plain_cost(given: Stations, observed: Observations, found: Location, other: Place) -> float:
    """At a place, with the ranges that are clean in what was found; by the plain formula."""
    assert other.velocity is not None
    assert found.selection is not None
    apart = other.position - given.positions
    far = np.linalg.norm(apart, axis=1)
    rest = observed.values - np.concatenate([far, (apart @ other.velocity) / far])
    size = len(far)
    kept = [name in found.selection.clean for name in given.names] + [True] * size
    white = rest / np.sqrt(np.diag(observed.covariance))
    return float(np.square(white[np.array(kept)]).sum())


@pytest.mark.sampled
@pytest.mark.parametrize("size", [4, 5, pytest.param(6, marks=pytest.mark.thorough)])
def test_a_place_that_free_biases_alone_explain_is_no_other(size: int) -> None:
    """Range rates have second solutions; where the ranges have no bias they are none."""
    second = 0
    for seed in range(samples(5)):
        given, observed, truth = places_that_explain(seed, size)
        try:
            found = locate(given, observed)
        except LocationError:
            continue
        assert found.first is not None
        second += bool(found.first.others)
        told = [each for each in found.warnings if each.startswith("ambiguous")]
        assert len(told) == len(found.others)
        for other in found.others:
            cost = plain_cost(given, observed, found, other)
            assert cost == pytest.approx(other.cost, rel=1e-6, abs=1e-6)
            assert cost <= found.convergence.cost + 9
            assert np.abs(other.position - found.position).max() > 1
        if not found.others:
            assert np.abs(found.position - truth[:2]).max() < 500
    assert second or size > 5  # with six stations they are rare


def test_places_with_clean_ranges_of_their_own_are_both_told() -> None:
    """Two of four ranges fit the one place, two the other, and the rates fit both."""
    given, alone = example_stations(), example_observations(biases=(0.0,) * 4)
    free = locate(given, alone, "doppler-only")
    (other,) = free.others
    far = np.linalg.norm(other.position - given.positions, axis=1)
    near = np.linalg.norm(free.position - given.positions, axis=1)
    mixed = observations(given, [*near[:2], *far[2:]], alone.values[4:], alone.covariance)
    found = locate(given, mixed)
    assert found.selection is not None
    assert len(found.selection.clean) == 2
    (told,) = [each for each in found.warnings if each.startswith("ambiguous")]
    also = ("B3", "B4") if found.selection.clean == ("B1", "B2") else ("B1", "B2")
    assert f"with {also[0]} and {also[1]} taken as clean, explains the observations" in told
