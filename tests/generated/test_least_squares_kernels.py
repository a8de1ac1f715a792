"""Growing-memory kernels as filters: their gains, run over a track, give the batch fit."""

from __future__ import annotations

import importlib
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import FITS
from samples import samples

from gainproof.verify.oracles import least_squares

EPS = Fraction(1, 2**52)
FAMILIES = sorted(FITS, key=lambda family: FITS[family])


def kernels(family: str) -> Any:
    return importlib.import_module(f"gainproof.generated.{family}")


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(8), deadline=None)
@given(samples=st.lists(st.integers(-1000, 1000), min_size=6, max_size=40))
def test_the_filter_with_printed_gains_is_the_batch_fit(family: str, samples: list[int]) -> None:
    """Exact arithmetic on the printed gains: only their rounding separates the two.

    The filter and the batch differ by K's error times the innovation, carried on by the fit's own
    transition, whose entries stay below 4 while it forgets like 1/k: bounded by 16 bounds times
    the sum of the innovations' sizes, each at most 8 times the largest sample.
    """
    degree = FITS[family]
    first = degree + 1
    start = least_squares.fit(degree, samples[:first])

    def gain_at(k: int) -> tuple[Fraction, ...]:
        return tuple(Fraction(float(x)) for x in kernels(family).gains(k))

    states = least_squares.run(gain_at, samples, first, start)
    room = 16 * 8 * EPS * len(samples) * (max(map(abs, samples)) * 8 + 1)
    for k, state in enumerate(states, first):
        batch = least_squares.fit(degree, samples[: k + 1])
        for found, true in zip(state, batch, strict=True):
            assert abs(found - true) <= room
    # a gain that is off by a millionth leaves that room by far
    if len(set(samples)) > degree + 2:
        last = len(samples) - 1
        spoiled = least_squares.run(
            lambda k: tuple(g * (1 + Fraction(k == last, 10**6)) for g in gain_at(k)),
            samples,
            first,
            start,
        )
        moved = abs(spoiled[-1][0] - states[-1][0])
        assert moved > room or moved == 0 or last > 30


@pytest.mark.parametrize("family", FAMILIES)
def test_small_sample_numbers_are_correctly_rounded_or_nearly(family: str) -> None:
    degree = FITS[family]
    for k in range(degree, 200):
        exact = least_squares.gains(degree, k)
        for found, true in zip(kernels(family).gains(k), exact, strict=True):
            assert abs(Fraction(float(found)) - true) <= 2 * EPS * true


@pytest.mark.parametrize("family", FAMILIES)
def test_the_first_gain_takes_the_sample_itself(family: str) -> None:
    # as many samples as coefficients: the fit passes through the newest one
    assert kernels(family).gains(FITS[family]).alpha == 1.0


@pytest.mark.parametrize("family", FAMILIES)
def test_gains_fall_with_the_sample_number(family: str) -> None:
    k = np.arange(FITS[family], 3000)
    for values in kernels(family).gains(k):
        assert (np.diff(values) <= 0).all()


def test_too_few_samples_are_refused() -> None:
    for family, degree in FITS.items():
        with pytest.raises(ValueError, match=f"at least {degree}"):
            kernels(family).gains(degree - 1)
        with pytest.raises(ValueError, match=f"at least {degree + 1}"):
            kernels(family).predicted_covariance(degree)
        with pytest.raises(ValueError, match="whole number"):
            kernels(family).gains(degree + 0.5)
