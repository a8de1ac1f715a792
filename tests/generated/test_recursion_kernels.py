"""Kernels of the recursion against the exact recursion, and against the whole track at once."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from printed_kernels import DTYPES, EPSILON
from printed_pairs import pairs_of
from recursion_tracks import NOISES, Sheared, entries, move, noise_of
from samples import samples

import gainproof.generated
from gainproof.generated import recursion_two_states as kernels
from gainproof.verify.oracles.matrices import Matrix, matrix
from gainproof.verify.oracles.riccati import predict, update
from gainproof.verify.oracles.state_space import StateSpace
from gainproof.verify.oracles.trajectory import last_covariance

ROW = matrix([[1, 0]], Fraction)
FACTORS = ("diagonal_1", "shear", "diagonal_2")
BOUNDS = {
    (kernel.name, output): stated.bound
    for folder in gainproof.generated.__path__
    for kernel in pairs_of("recursion_two_states", Path(folder))
    for output, stated in kernel.outputs.items()
}
SIZE = st.floats(-6, 6).map(lambda e: 10.0**e)
SHEAR = st.one_of(st.just(0.0), st.floats(-3, 3).map(lambda e: 10.0**e))


def predicted(name: str, p: Matrix, interval: float, strength: float) -> Matrix:
    step = move(name, Fraction(interval), Fraction(strength))
    return predict(StateSpace(step.transition, noise_of(step), ROW, ((Fraction(1),),)), p)


def updated(p: Matrix, variance: float) -> Any:
    return update(StateSpace(p, p, ROW, ((Fraction(variance),),)), p)


def held(kernel: str, found: Any, truth: dict[str, Fraction], dtype: str) -> None:
    """Every output within its stated bound, but for 60 digits of the oracle's noise."""
    for output, true in truth.items():
        value = Fraction(float(getattr(found, output)))
        allowed = BOUNDS[kernel, output][dtype] * EPSILON[dtype] + Fraction(1, 10**50)
        assert abs(value - true) <= allowed * abs(true), (kernel, output, float(value / true - 1))


def of_factors(p: Matrix) -> dict[str, Fraction]:
    return dict(zip(FACTORS, Sheared.of(p).values, strict=True))


def of_update(new: Any) -> dict[str, Fraction]:
    return {
        "position_gain": new.gain[0][0],
        "velocity_gain": new.gain[1][0],
        "innovation_variance": new.innovation[0][0],
    }


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("name", NOISES)
@settings(max_examples=samples(5), deadline=None)
@given(SIZE, SHEAR, SIZE, SHEAR, SIZE, SIZE)
def test_one_step(
    name: str, dtype: str, d1: float, u: float, d2: float, t: float, q: float, r: float
) -> None:
    kind = np.dtype(dtype).type
    d1, u, d2, t, q, r = (float(kind(x)) for x in (d1, u, d2, t, q, r))
    one = [kind(x) for x in (d1, u, d2, t, q, r)]
    if t == 0 and name != "random_velocity":
        q_at_zero = 0.0  # the noise of no interval is none, and its oracle divides by it
        p = predicted("random_velocity", entries((d1, u, d2)), t, q_at_zero)
    else:
        p = predicted(name, entries((d1, u, d2)), t, q)
    held(f"predict_{name}", getattr(kernels, f"predict_{name}")(*one[:5]), of_factors(p), dtype)
    new = updated(p, r)
    truth = of_factors(new.updated) | of_update(new)
    held(f"step_{name}", getattr(kernels, f"step_{name}")(*one), truth, dtype)


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(10), deadline=None)
@given(SIZE, SHEAR, SIZE, SIZE)
def test_update_and_gains(dtype: str, d1: float, u: float, d2: float, r: float) -> None:
    kind = np.dtype(dtype).type
    d1, u, d2, r = (float(kind(x)) for x in (d1, u, d2, r))
    one = [kind(x) for x in (d1, u, d2, r)]
    p = entries((d1, u, d2))
    new = updated(p, r)
    held("update", kernels.update(*one), of_factors(new.updated), dtype)
    held("gains", kernels.gains(*one), of_update(new), dtype)
    whole = {"covariance_11": p[0][0], "covariance_12": p[0][1], "covariance_22": p[1][1]}
    held("covariance", kernels.covariance(*one[:3]), whole, dtype)


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("name", NOISES)
@settings(max_examples=samples(5), deadline=None)
@given(SHEAR.filter(bool), SIZE, SIZE)
def test_start(name: str, dtype: str, t: float, q: float, r: float) -> None:
    """Two positions and a velocity of which nothing is known: the limit, by elimination."""
    kind = np.dtype(dtype).type
    t, q, r = (float(kind(x)) for x in (t, q, r))
    noise = noise_of(move(name, Fraction(t), Fraction(q)))
    # (z1 - z0)/t errs by both measurements and by what the noise did to position and velocity
    t_, r_ = Fraction(t), Fraction(r)
    rate = 2 * r_ / t_**2 + noise[0][0] / t_**2 - 2 * noise[0][1] / t_ + noise[1][1]
    truth = of_factors(((r_, r_ / t_), (r_ / t_, rate)))
    held(
        f"start_{name}", getattr(kernels, f"start_{name}")(kind(t), kind(q), kind(r)), truth, dtype
    )


INTERVALS = (1.0, 0.25, 3.0, 1.0, 10.0, 0.5, 0.125, 2.0, 4.0, 1.0)


@pytest.mark.parametrize(
    ("name", "missed"),
    cases(
        product(NOISES, [(), (3,), (4, 5, 6)]),
        lambda case: "random_acceleration" in case or (3,) in case,
    ),
)
def test_a_whole_track(name: str, missed: Sequence[int]) -> None:
    """Eleven measurements, intervals from 1/8 to 10, against the normal equations of all."""
    start, q, r = (100.0, 2.0, 9.0), 0.5, 4.0
    f: Any = kernels.update(*start, r)
    for number, interval in enumerate(INTERVALS):
        step = getattr(kernels, f"{'predict' if number in missed else 'step'}_{name}")
        f = step(*f[:3], interval, q, *([] if number in missed else [r]))
    moves = [move(name, Fraction(t), Fraction(q)) for t in INTERVALS]
    measured = [True, *(number not in missed for number in range(len(INTERVALS)))]
    truth = last_covariance(entries(start), moves, measured, ROW, Fraction(r))
    found = entries(f[:3])
    worst = max(abs(float(found[i][j] / truth[i][j] - 1)) for i, j in ((0, 0), (0, 1), (1, 1)))
    # ten steps of at most 17 epsilon in a factor, which later steps do not amplify but forget
    assert worst < 10 * 17 * 2.0**-52
    wrong = last_covariance(
        entries(start), moves, measured, ROW, Fraction(r) * (1 + Fraction(1, 10**12))
    )
    assert abs(float(found[0][0] / wrong[0][0] - 1)) > worst
