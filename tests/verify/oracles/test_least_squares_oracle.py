"""Batch least squares: known fits, and the recursion from its own gains."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.oracles import least_squares, recursion
from gainproof.verify.oracles.matrices import matrix, product, transpose
from gainproof.verify.oracles.riccati import predict
from gainproof.verify.oracles.state_space import StateSpace

SAMPLES = st.lists(st.fractions(-100, 100, max_denominator=12), min_size=5, max_size=12)


@settings(max_examples=samples(10), deadline=None)
@given(SAMPLES)
def test_degree_zero_is_the_arithmetic_mean(samples: list[Fraction]) -> None:
    assert least_squares.fit(0, samples) == (sum(samples) / len(samples),)


@settings(max_examples=samples(10), deadline=None)
@given(st.lists(st.fractions(-9, 9, max_denominator=6), min_size=3, max_size=3), st.integers(2, 12))
def test_a_parabola_is_returned_exactly(state: list[Fraction], newest: int) -> None:
    value, velocity, acceleration = state
    samples = [
        value + velocity * t + acceleration * t * t / 2
        for t in (Fraction(j - newest) for j in range(newest + 1))
    ]
    assert least_squares.fit(2, samples) == tuple(state)


@settings(max_examples=samples(10), deadline=None)
@given(SAMPLES, st.integers(0, 2))
def test_residuals_are_orthogonal_to_every_power(samples: list[Fraction], degree: int) -> None:
    newest = len(samples) - 1
    fitted = least_squares.fit(degree, samples)
    for power in range(degree + 1):
        total = Fraction(0)
        for j, sample in enumerate(samples):
            t = Fraction(j - newest)
            parts = (1, t, t * t / 2)
            curve = sum((c * part for c, part in zip(fitted, parts, strict=False)), Fraction(0))
            total += (sample - curve) * t**power
        assert total == 0


@settings(max_examples=samples(10), deadline=None)
@given(SAMPLES, st.integers(0, 2))
def test_the_recursion_with_batch_gains_reproduces_the_batch(
    samples: list[Fraction], degree: int
) -> None:
    first = degree + 1
    start = least_squares.fit(degree, samples[:first])
    states = least_squares.run(lambda k: least_squares.gains(degree, k), samples, first, start)
    for k, state in enumerate(states, first):
        assert state == least_squares.fit(degree, samples[: k + 1])


@pytest.mark.parametrize("degree", [0, 1, 2, 3])
def test_gains_and_covariance_are_those_of_the_weights(degree: int) -> None:
    for newest in range(degree, 14):
        rows = least_squares.weights(degree, newest)
        assert least_squares.gains(degree, newest) == tuple(row[-1] for row in rows)
        assert least_squares.covariance(degree, newest) == product(rows, transpose(rows))


def test_sums_of_powers() -> None:
    for power in range(7):
        for last in (0, 1, 5, 30):
            assert least_squares.power_sum(power, last) == sum(j**power for j in range(last + 1))
    assert least_squares.power_sum(1, 10**20) == 10**20 * (10**20 + 1) // 2


def test_a_wrong_gain_is_noticed() -> None:
    samples = [Fraction(x) for x in (3, 1, 4, 1, 5, 9)]
    start = least_squares.fit(1, samples[:2])
    states = least_squares.run(
        lambda k: tuple(g + Fraction(k == 4, 10**9) for g in least_squares.gains(1, k)),
        samples,
        2,
        start,
    )
    agree = [s == least_squares.fit(1, samples[: k + 1]) for k, s in enumerate(states, 2)]
    assert agree == [True, True, False, False]


def test_the_filter_without_process_noise_has_these_gains() -> None:
    for degree in (0, 1, 2):
        n = degree + 1
        model = StateSpace(
            least_squares.taylor(degree),
            matrix([[0] * n] * n, Fraction),
            ((Fraction(1), *[Fraction(0)] * degree),),
            ((Fraction(1),),),
        )
        known = least_squares.covariance(degree, n)
        ahead = predict(model, known)
        states = recursion.transient(model, ahead, 6)
        for k, state in enumerate(states, n + 1):
            assert tuple(row[0] for row in state.gain) == least_squares.gains(degree, k)
            assert state.updated == least_squares.covariance(degree, k)


def test_too_few_samples_are_refused() -> None:
    with pytest.raises(ValueError, match="newest sample number >= degree"):
        least_squares.weights(2, 1)
    with pytest.raises(ValueError, match="degree >= 0"):
        least_squares.weights(-1, 1)
