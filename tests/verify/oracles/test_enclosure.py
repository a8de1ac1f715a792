"""The enclosure for any number of measurements: against the one by spectral factorisation where
only one quantity is measured, and with starts that are wrong on purpose.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES
from samples import samples

from gainproof.verify.oracles import ball, distance, doubling, enclosure
from gainproof.verify.oracles import position_velocity as oracle
from gainproof.verify.oracles.multiprecision import context
from gainproof.verify.oracles.spectrum import spectrum
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState, state_space

FAMILIES = sorted(STEADY_STATES)
ANY = st.floats(-30, 30).map(lambda e: Fraction(10.0**e))
NOISE = STEADY_STATES["continuous_white_acceleration"]["process_noise"]
OWN = context(800)


def overlap(one: SteadyState, other: SteadyState) -> bool:
    """Whether every entry's two balls have a point in common, as balls round one number must."""
    pairs = zip(one.entries().values(), other.entries().values(), strict=True)
    return all(bool(x.overlaps(y)) for x, y in pairs)


def starting_at(monkeypatch: pytest.MonkeyPatch, predicted: Any) -> None:
    """Doubling replaced by one that always answers with this predicted covariance."""
    rows = tuple(tuple(OWN.mpf(x.numerator) / x.denominator for x in row) for row in predicted)
    wrong = doubling.Doubled(SteadyState(rows, rows, rows, rows), 800)
    monkeypatch.setattr(doubling, "steady_state", lambda *_: wrong)


def one_state(transition: int) -> StateSpace:
    """x' = f x without process noise, measured with unit variance."""
    number = ((Fraction(1),),)
    return StateSpace(((Fraction(transition),),), ((Fraction(0),),), number, number)


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(5), deadline=None)
@given(index=ANY)
def test_one_measurement_overlaps_the_spectral_enclosure(family: str, index: Fraction) -> None:
    model = STEADY_STATES[family]
    by_spectrum = ball.enclose(spectrum(state_space(model)), index).state
    assert overlap(enclosure.enclose(state_space(model, index)), by_spectrum)


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(6), deadline=None)
@given(index=ANY, ratio=ANY)
def test_two_measurements_to_forty_digits_over_the_whole_domain(
    family: str, index: Fraction, ratio: Fraction
) -> None:
    model = oracle.model(STEADY_STATES[family]["process_noise"], index, ratio)
    found = enclosure.enclose(model)
    assert all(x.rel_accuracy_bits() >= 133 for x in found.entries().values())
    # another start, another precision
    assert overlap(found, enclosure.enclose(model, 70))


def test_without_velocity_noise_dominates_as_with_position_alone() -> None:
    """Two different models approach one another: their balls do not overlap, but nearly."""
    both = enclosure.enclose(oracle.model(NOISE, 1, 10**30), 80).predicted[0][0]
    alone = enclosure.enclose(oracle.position_only(NOISE, 1), 80).predicted[0][0]
    assert not both.overlaps(alone)
    assert 1e-61 < distance.relative_error(distance.middle(both), alone) < 1e-50


@pytest.mark.parametrize("power", [15, 30, 50])
def test_a_start_that_is_off_is_enclosed_all_the_same_or_refused(
    power: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    model = oracle.model(NOISE, 1, 1)
    truth = enclosure.enclose(model, 60)
    off = 1 + Fraction(1, 10**power)
    start = [[distance.middle(x) * off for x in row] for row in truth.predicted]
    starting_at(monkeypatch, start)
    if power == 15:
        with pytest.raises(NotConverged):
            enclosure.enclose(model, 40)
    else:
        assert overlap(enclosure.enclose(model, 20), truth)


def test_a_solution_that_does_not_stabilise_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """x' = 2 x without noise: 3 stabilises, 0 solves the equation too."""
    model = one_state(2)
    starting_at(monkeypatch, [[Fraction(3)]])
    assert bool(enclosure.enclose(model).predicted[0][0].contains(3))
    starting_at(monkeypatch, [[Fraction(0)]])
    with pytest.raises(NotConverged):
        enclosure.enclose(model)


def test_what_is_no_solution_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    starting_at(monkeypatch, [[Fraction(1)]])
    with pytest.raises(NotConverged):
        enclosure.enclose(one_state(2))
