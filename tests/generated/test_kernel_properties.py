"""What must hold between the outputs of the kernels of one family, whatever the formulas are.

Tolerances: each side is off by its stated bound; a sum of terms by the bounds times the sum of
the sizes of the terms (the condition of that sum).
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES, truth_at
from printed_kernels import EPSILON, PrintedKernel, Promise, printed_kernels
from samples import samples

from gainproof.verify.oracles import distance, doubling
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import StateSpace

FAMILIES = sorted(STEADY_STATES)
EPS = EPSILON["float64"]
MODERATE = st.floats(-60, 60).map(lambda e: 10.0**e)


@cache
def kernel(family: str, name: str) -> PrintedKernel:
    (found,) = (k for k in printed_kernels() if (k.family, k.name) == (family, name))
    return found


def values(family: str, name: str, argument: float) -> dict[str, Fraction]:
    called = kernel(family, name)
    return {
        output: Fraction(float(value))
        for output, value in zip(called.outputs, called.function(argument), strict=True)
    }


def bounds(family: str, *names: str) -> Fraction:
    """The largest stated bound of some kernels, as a plain number."""
    return max(
        promise.error("float64")
        for name in names
        for promise in kernel(family, name).promises["float64"].values()
    )


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(8), deadline=None)
@given(index=MODERATE)
def test_predicted_and_updated_covariance_are_consistent(family: str, index: float) -> None:
    k = values(family, "gains", index)
    m = values(family, "predicted_covariance", index)
    x = values(family, "updated_covariance", index)
    u = bounds(family, "gains", "predicted_covariance", "updated_covariance")
    gain = (k["alpha"], k["beta"])
    predicted = ((m["predicted_11"], m["predicted_12"]), (m["predicted_12"], m["predicted_22"]))
    updated = ((x["updated_11"], x["updated_12"]), (x["updated_12"], x["updated_22"]))
    for i in range(2):
        # K = X H' / R and K (H M H' + R) = M H'
        assert near(gain[i], updated[i][0], 2 * u, [gain[i]])
        reached = gain[i] * (predicted[0][0] + 1)
        assert near(reached, predicted[i][0], 4 * u, [reached])
        for j in range(2):
            # X = M - K H M, as a sum M = X + K H M of positive terms
            terms = [updated[i][j], gain[i] * predicted[0][j]]
            assert near(predicted[i][j], sum(terms), 4 * u, terms)
    # M = F X F' + q Q0
    noise = STEADY_STATES[family]["process_noise"]
    q = Fraction(index) ** 2
    (a, b), (_, d) = updated
    carried = [[[a, 2 * b, d], [b, d]], [[b, d], [d]]]
    for i in range(2):
        for j in range(2):
            terms = [*carried[i][j], q * Fraction(noise[i][j])]
            assert near(predicted[i][j], sum(terms), 4 * u, terms)


def near(left: Fraction, right: Fraction | int, error: Fraction, terms: list[Fraction]) -> bool:
    return abs(left - right) <= error * sum(map(abs, terms))


@pytest.mark.parametrize("family", FAMILIES)
def test_an_inconsistent_covariance_is_noticed(family: str) -> None:
    x = values(family, "updated_covariance", 2.0)["updated_22"]
    m = values(family, "predicted_covariance", 2.0)["predicted_22"]
    added = 4 * Fraction(STEADY_STATES[family]["process_noise"][1][1])
    u = 4 * bounds(family, "updated_covariance", "predicted_covariance")
    assert near(m, x + added, u, [x, added])
    assert not near(m, x * (1 + Fraction(1, 10**12)) + added, u, [x, added])


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(3), deadline=None)
@given(
    interval=st.fractions(Fraction(1, 50), 50, max_denominator=50),
    sensor=st.fractions(Fraction(1, 50), 50, max_denominator=50),
    strength=st.fractions(Fraction(1, 50), 50, max_denominator=50),
)
def test_units_scale_as_the_index_says(
    family: str, interval: Fraction, sensor: Fraction, strength: Fraction
) -> None:
    """The steady state in seconds and metres, by doubling, against the dimensionless kernels.

    ``strength`` is the deviation of the acceleration (or velocity increment, or the density of
    the white acceleration), ``sensor`` that of the measurement.
    """
    t, r = interval, sensor**2
    cross = strength**2 * t**3 / 2
    physical: dict[str, tuple[list[list[Any]], Fraction]] = {
        "random_velocity": ([[0, 0], [0, strength**2]], (strength * t / sensor) ** 2),
        "random_acceleration": (
            [[strength**2 * t**4 / 4, cross], [cross, strength**2 * t**2]],
            (strength * t**2 / sensor) ** 2,
        ),
        "continuous_white_acceleration": (
            [[strength * t**3 / 3, strength * t**2 / 2], [strength * t**2 / 2, strength * t]],
            strength * t**3 / r,
        ),
    }
    noise, index_squared = physical[family]
    model = StateSpace(
        matrix([[1, t], [0, 1]], Fraction),
        matrix(noise, Fraction),
        matrix([[1, 0]], Fraction),
        ((r,),),
    )
    state = doubling.steady_state(model).state
    index = math.sqrt(index_squared)
    found = {
        name: value
        for kernel_name in ("gains", "predicted_covariance", "updated_covariance")
        for name, value in values(family, kernel_name, index).items()
    }
    # the index is rounded: its part is |index d(entry)/d(index)| <= 2 |entry| (see below), times
    # the rounding of the square root and of the conversion
    error = bounds(family, "gains", "predicted_covariance", "updated_covariance") + 8 * EPS
    scales = {"alpha": Fraction(1), "beta": 1 / t}
    for row, (name, unit) in enumerate(scales.items()):
        true = fraction(state.gain[row][0])
        assert abs(found[name] * unit - true) <= error * true, name
    for kind, rows in (("predicted", state.predicted), ("updated", state.updated)):
        for i, j in ((0, 0), (0, 1), (1, 1)):
            true = fraction(rows[i][j])
            name = f"{kind}_{i + 1}{j + 1}"
            assert abs(found[name] * r / t ** (i + j) - true) <= error * true, name


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(5), deadline=None)
@given(index=MODERATE)
def test_no_output_is_more_sensitive_than_the_square_of_the_index(
    family: str, index: float
) -> None:
    truth = truth_at(family, "tracking_index", index)
    for name, slope in truth.items():
        if name.startswith("d_"):
            condition = Fraction(index) * abs(distance.middle(slope.value))
            assert condition <= 2 * distance.middle(truth[name[2:]].value), name


INCREASING = ("gains", "predictor_gains", "predicted_covariance", "updated_covariance")


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(12), deadline=None)
@given(data=st.data())
def test_everything_grows_with_the_index(family: str, data: st.DataObject) -> None:
    exponents = st.floats(-300, 300)
    low = 10.0 ** data.draw(exponents)
    high = low * (1 + 10.0 ** data.draw(st.floats(-15, 3)))
    if not math.isfinite(high):
        return
    for name in INCREASING:
        before, after = (kernel(family, name).function(x) for x in (low, high))
        for output, x, y in zip(kernel(family, name).outputs, before, after, strict=True):
            promise: Promise = kernel(family, name).promises["float64"][output]
            # both values are off by their bound at most
            assert y >= x * (1 - 2 * float(promise.error("float64"))), f"{name}.{output}"
            if promise.holds_at(low) and promise.holds_at(high) and high > 2 * low and high < 1e6:
                assert y > x or output in {"alpha", "beta"}, f"{name}.{output}"


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(8), deadline=None)
@given(exponent=st.floats(-150, 12))
def test_round_trip_from_index_to_gain_and_back(family: str, exponent: float) -> None:
    index = 10.0**exponent
    truth = truth_at(family, "tracking_index", index)
    for gain in ("alpha", "beta"):
        value = float(values(family, "gains", index)[gain])
        back = kernel(family, f"index_from_{gain}")
        low, high = back.domain["float64"]
        if not low <= value <= high:
            assert exponent > 6  # the gain has reached its limit in float64
            continue
        (found,) = back.function(value)
        # how much a relative error of the gain moves the index
        condition = distance.middle(truth[gain].value) / (
            Fraction(index) * distance.middle(truth[f"d_{gain}"].value)
        )
        forward = kernel(family, "gains").promises["float64"][gain].error("float64")
        backward = back.promises["float64"]["tracking_index"].error("float64")
        if condition * forward < Fraction(1, 100):
            # 1.1: what a change of a hundredth leaves of the linear estimate
            allowed = (backward + condition * forward) * Fraction(11, 10)
            assert abs(Fraction(float(found)) - Fraction(index)) <= allowed * Fraction(index)


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(8), deadline=None)
@given(exponent=st.floats(-150, 4))
def test_each_gain_gives_the_other(family: str, exponent: float) -> None:
    gains = values(family, "gains", 10.0**exponent)
    truth = truth_at(family, "tracking_index", 10.0**exponent)
    # how much faster each gain moves with the index than in proportion
    pace = {
        gain: distance.middle(truth[f"d_{gain}"].value) / distance.middle(truth[gain].value)
        for gain in gains
    }
    for source, target in (("alpha", "beta"), ("beta", "alpha")):
        called = kernel(family, f"{target}_from_{source}")
        low, high = called.domain["float64"]
        if not low <= gains[source] <= high:
            continue
        (found,) = called.function(float(gains[source]))
        condition = pace[target] / pace[source]
        own = called.promises["float64"][target].error("float64")
        error = bounds(family, "gains")
        if condition * error < Fraction(1, 100):
            # 1.1: what a change of a hundredth leaves of the linear estimate
            allowed = (own + (condition + 1) * error) * Fraction(11, 10)
            assert abs(Fraction(float(found)) - gains[target]) <= allowed * gains[target]


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(8), deadline=None)
@given(index=MODERATE)
def test_poles_have_the_sum_and_product_that_the_gains_give(family: str, index: float) -> None:
    z = values(family, "closed_loop_poles", index)
    k = values(family, "gains", index)
    u = bounds(family, "gains", "closed_loop_poles")
    # the characteristic polynomial of F (I - K H), written out for two states
    total = z["first_real"] + z["second_real"]
    assert near(total, 2 - k["alpha"] - k["beta"], 2 * u, [Fraction(2), k["alpha"], k["beta"]])
    product = z["first_real"] * z["second_real"] - z["first_imaginary"] * z["second_imaginary"]
    assert near(product, 1 - k["alpha"], 4 * u, [Fraction(1), k["alpha"]])
    assert z["first_imaginary"] + z["second_imaginary"] == 0 <= z["first_imaginary"]
    # inside the unit circle, or beyond it by no more than the stated error
    assert abs(z["first_real"]) <= 1 + u


@pytest.mark.parametrize("family", FAMILIES)
def test_poles_turn_real_where_they_meet(family: str) -> None:
    indices = np.geomspace(1e-3, 1e6, 4001)
    poles = kernel(family, "closed_loop_poles").function(indices)
    complex_pair = poles.first_imaginary > 0
    if family == "random_velocity":
        assert complex_pair.all()
        return
    turn = int(np.argmin(complex_pair))
    assert complex_pair[:turn].all()
    assert not complex_pair[turn:].any()
    for index, expected in ((indices[turn - 1], True), (indices[turn], False)):
        truth = truth_at(family, "tracking_index", float(index))
        assert (truth["first_imaginary"].value > 0) == expected
