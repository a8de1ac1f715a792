"""Three-state recursion kernels against the exact recursion and the whole track at once."""

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
from recursion_tracks import transition
from recursion_triples import NOISES, ROW, covariance, factors, move, unit_noise
from samples import samples

import gainproof.generated
from gainproof.generated import recursion_three_states
from gainproof.verify.oracles.matrices import identity, scale
from gainproof.verify.oracles.riccati import predict, update
from gainproof.verify.oracles.state_space import StateSpace
from gainproof.verify.oracles.trajectory import last_covariance

kernels: Any = recursion_three_states
BOUNDS = {
    (kernel.name, output): stated.bound
    for folder in gainproof.generated.__path__
    for kernel in pairs_of("recursion_three_states", Path(folder))
    for output, stated in kernel.outputs.items()
}
SIZE = st.floats(-3, 3).map(lambda e: 10.0**e)
SHEAR = st.one_of(st.just(0.0), st.floats(-2, 2).map(lambda e: 10.0**e))
TIME = st.floats(-1.9, 1.9).map(lambda e: 10.0**e)


def held(kernel: str, found: Any, truth: dict[str, Fraction], dtype: str) -> None:
    """Every output within its stated bound, but for 60 digits of the oracle's noise."""
    for output, true in truth.items():
        value = Fraction(float(getattr(found, output)))
        allowed = BOUNDS[kernel, output][dtype] * EPSILON[dtype] + Fraction(1, 10**40)
        assert abs(value - true) <= allowed * abs(true), (kernel, output, float(value / true - 1))


@pytest.mark.parametrize(
    ("name", "dtype"),
    cases(product(NOISES, DTYPES), lambda case: "random_jerk" in case or "float64" in case),
)
@settings(max_examples=samples(5), deadline=None)
@given(st.tuples(SIZE, SIZE, SIZE), st.tuples(SHEAR, SHEAR, SHEAR), TIME, SIZE)
def test_prediction(
    name: str,
    dtype: str,
    sizes: tuple[float, ...],
    shears: tuple[float, ...],
    t: float,
    q: float,
) -> None:
    kind = np.dtype(dtype).type
    given_ = [kind(x) for x in (*sizes, *shears)]
    step, strength = kind(t), kind(q)
    t_, q_ = Fraction(float(step)), Fraction(float(strength))
    p = covariance([float(x) for x in given_])
    system = StateSpace(transition(t_, 3), scale(q_, unit_noise(name, t_)), ROW, ((Fraction(1),),))
    found = getattr(kernels, f"predict_{name}")(*given_, step, strength)
    held(f"predict_{name}", found, factors(predict(system, p)), dtype)


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(12), deadline=None)
@given(st.tuples(SIZE, SIZE, SIZE), st.tuples(SHEAR, SHEAR, SHEAR), SIZE)
def test_update(dtype: str, sizes: tuple[float, ...], shears: tuple[float, ...], r: float) -> None:
    kind = np.dtype(dtype).type
    given_, variance = [kind(x) for x in (*sizes, *shears)], kind(r)
    p = covariance([float(x) for x in given_])
    new = update(StateSpace(p, p, ROW, ((Fraction(float(variance)),),)), p)
    truth = factors(new.updated)
    if shears[1] == 0:  # a and c stand for their sum where b is 0
        for name in ("first_shear", "third_shear"):
            del truth[name]
    held("update", kernels.update(*given_, variance), truth, dtype)
    gains = ("position_gain", "velocity_gain", "acceleration_gain")
    wanted = {name: row[0] for name, row in zip(gains, new.gain, strict=True)}
    wanted["innovation_variance"] = new.innovation[0][0]
    held("gains", kernels.gains(*given_, variance), wanted, dtype)
    places = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
    entries = {f"covariance_{i + 1}{j + 1}": p[i][j] for i, j in places}
    held("covariance", kernels.covariance(*given_), entries, dtype)


INTERVALS = (1.0, 0.25, 3.0, 1.0, 10.0, 0.5, 0.125, 2.0)


@pytest.mark.parametrize(
    ("name", "missed"),
    cases(product(NOISES, [(), (3,), (4, 5)]), lambda case: "random_jerk" in case or (3,) in case),
)
def test_a_whole_track(name: str, missed: Sequence[int]) -> None:
    """Nine measurements from an uncorrelated start against the normal equations of all."""
    start, q, r = (100.0, 9.0, 4.0, 0.0, 0.0, 0.0), 0.5, 4.0
    f: Any = kernels.update(*start, r)
    moves = []
    for number, interval in enumerate(INTERVALS):
        f = getattr(kernels, f"predict_{name}")(*f, interval, q)
        if number not in missed:
            f = kernels.update(*f, r)
        moves.append(move(name, Fraction(interval), Fraction(q)))
    measured = [True, *(number not in missed for number in range(len(INTERVALS)))]
    truth = last_covariance(covariance(start), moves, measured, ROW, Fraction(r))
    found = covariance([float(x) for x in f])
    worst = max(abs(float(found[i][j] / truth[i][j] - 1)) for i in range(3) for j in range(3))
    # eight steps of at most 17 and 7 epsilon in a factor, which later steps forget
    assert worst < 8 * 24 * 2.0**-52
    nearly = Fraction(r) * (1 + Fraction(1, 10**12))
    wrong = last_covariance(covariance(start), moves, measured, ROW, nearly)
    assert abs(float(found[0][0] / wrong[0][0] - 1)) > worst


@pytest.mark.alike
@pytest.mark.parametrize(
    ("name", "dtype"),
    cases(product(NOISES, DTYPES), lambda case: "random_jerk" in case or "float64" in case),
)
@settings(max_examples=samples(5), deadline=None)
@given(TIME, TIME, st.one_of(st.just(0.0), SIZE), SIZE)
def test_start(name: str, dtype: str, s: float, t: float, q: float, r: float) -> None:
    """Against the normal equations of three positions and a state of which nothing is known."""
    kind = np.dtype(dtype).type
    given_ = [kind(x) for x in (s, t, q, r)]
    s_, t_, q_, r_ = (Fraction(float(x)) for x in given_)
    found = getattr(kernels, f"start_{name}")(*given_)
    unknown = scale(Fraction(10) ** 70, identity(3, Fraction(1)))
    least = q_ or Fraction(1, 10**70)  # the normal equations divide by it
    moves = [move(name, s_, least), move(name, t_, least)]
    held(
        f"start_{name}", found, factors(last_covariance(unknown, moves, [True] * 3, ROW, r_)), dtype
    )


def test_a_start_of_something_else_is_seen() -> None:
    """Of another noise, and with the intervals the other way round."""
    found = kernels.start_random_jerk(1.0, 2.0, 1.0, 1.0)
    unknown = scale(Fraction(10) ** 70, identity(3, Fraction(1)))
    for name, times in (("wiener_acceleration", (1, 2)), ("random_jerk", (2, 1))):
        moves = [move(name, Fraction(t), Fraction(1)) for t in times]
        truth = factors(last_covariance(unknown, moves, [True] * 3, ROW, Fraction(1)))
        with pytest.raises(AssertionError):
            held("start_random_jerk", found, truth, "float64")
