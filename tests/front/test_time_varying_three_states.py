"""Arrays of tracks of three states: what the recursion keeps, and where it comes to."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.time_varying.three_states import (
    PROCESS_NOISES,
    Factors,
    covariance_of,
    predict,
    step,
    uncorrelated,
    update,
)
from gainproof.verify.oracles import noise
from gainproof.verify.oracles.doubling import steady_state
from gainproof.verify.oracles.matrices import matrix, product, scale, transpose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import StateSpace

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize(
    "name", cases(NAMES, {"acceleration-increments", "random-jerk"}.__contains__)
)
SIZE = st.floats(-3, 3).map(lambda e: 10.0**e)
TIME = st.floats(-1.5, 1.5).map(lambda e: 10.0**e)
SHEAR = st.one_of(st.just(0.0), TIME)
FACTORS = st.builds(Factors, SIZE, SIZE, SIZE, SHEAR, SHEAR, SHEAR)


@EVERY
@settings(max_examples=samples(6), deadline=None)
@given(FACTORS, st.lists(st.tuples(TIME, st.booleans()), min_size=1, max_size=30), SIZE, SIZE)
def test_covariances_stay_positive_definite(
    name: str, f: Factors, samples: list[tuple[float, bool]], q: float, r: float
) -> None:
    """A factorisation with positive diagonal is definite, whatever the shears."""
    for interval, seen in samples:
        f = step(f, interval, q, r, seen, name).factors
        assert min(f[:3]) > 0
        assert min(f[3:]) >= 0
        assert np.isfinite(np.array(f)).all()


@EVERY
@settings(max_examples=samples(8), deadline=None)
@given(FACTORS, TIME, SIZE, SIZE, st.integers(0, 4), st.integers(1, 4))
def test_a_missed_detection_only_raises_the_variances(
    name: str, f: Factors, t: float, q: float, r: float, missed: int, later: int
) -> None:
    full = poor = f
    for number in range(missed + later):
        full = step(full, t, q, r, True, name).factors
        poor = step(poor, t, q, r, number != missed, name).factors
        variances = (np.diag(covariance_of(each)) for each in (full, poor))
        for less, more in zip(*variances, strict=True):
            assert more >= less * (1 - 64 * 2.0**-52 * (missed + later))


@settings(max_examples=samples(12), deadline=None)
@given(FACTORS, TIME, TIME, SIZE)
def test_two_predictions_add_their_intervals(f: Factors, s: float, t: float, q: float) -> None:
    for name in NAMES:
        strength = q if name == "continuous-white-jerk" else 0.0
        whole = covariance_of(predict(f, s + t, strength, name))
        for one, other in ((s, t), (t, s)):
            parts = covariance_of(predict(predict(f, one, strength, name), other, strength, name))
            # three predictions of at most 17 epsilon in a factor, of which an entry takes up to
            # five, and the sum of the intervals, which enters by its fifth power
            assert parts == pytest.approx(whole, rel=5 * 3 * 17 * 2.0**-52)
    cut = predict(predict(f, s, q, "random-jerk"), t, q, "random-jerk")
    assert cut.diagonal_3 < predict(f, s + t, q, "random-jerk").diagonal_3


@pytest.mark.alike
@EVERY
@pytest.mark.parametrize("strength", cases([0.01, 1.0, 30.0], lambda strength: strength != 1))
def test_equal_intervals_come_to_the_steady_state(name: str, strength: float) -> None:
    """Against the doubling algorithm, which knows the matrices only."""
    a, b = noise.chain(3)
    move = matrix(noise.transition(a, 1, 60), fraction)
    carried = tuple((row[2],) for row in move)
    unit = {
        "acceleration-increments": lambda: product(matrix(b), transpose(matrix(b))),
        "wiener-acceleration": lambda: product(carried, transpose(carried)),
        "random-jerk": lambda: matrix(noise.held(a, b, 1, 60), fraction),
        "continuous-white-jerk": lambda: matrix(noise.white(a, b, 1, 60), fraction),
    }[name]()
    noisy = scale(Fraction(strength), matrix(unit, Fraction))
    system = StateSpace(move, noisy, matrix([[1, 0, 0]], Fraction), ((Fraction(1),),))
    known = steady_state(system, 40).state
    found = step(uncorrelated(10.0, 20.0, 5.0), 1.0, strength, 1.0, process_noise=name)
    f = found.factors
    for _ in range(300):
        found = step(f, 1.0, strength, 1.0, process_noise=name)
        f = found.factors
    for gain, row in zip(found[1:4], known.gain, strict=True):
        assert abs(Fraction(float(gain)) / fraction(row[0]) - 1) < Fraction(1, 10**13)
    p = covariance_of(f)
    for i in range(3):
        for j in range(3):
            true = fraction(known.updated[i][j])
            assert abs(Fraction(float(p[i, j])) / true - 1) < Fraction(1, 10**13)


@EVERY
def test_arrays_are_their_tracks(name: str) -> None:
    generator = np.random.default_rng(3)
    start = uncorrelated([1.0, 10.0, 100.0], 4.0, [1.0, 2.0, 3.0])
    intervals, seen = 10.0 ** generator.uniform(-1, 1, 3), np.array([True, False, True])
    found = step(start, intervals, 0.5, [1.0, 2.0, 4.0], seen, name)
    assert covariance_of(found.factors).shape == (3, 3, 3)
    assert np.asarray(found.acceleration_gain).tolist()[1] == 0
    for track in range(3):
        own = Factors(*(np.asarray(x)[track] for x in start))
        single = step(own, intervals[track], 0.5, float(2**track), bool(seen[track]), name)
        for x, y in zip((*single.factors, *single[1:]), (*found.factors, *found[1:]), strict=True):
            assert float(x) == np.asarray(y)[track]


def test_what_is_refused() -> None:
    f = uncorrelated(1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="process_noise must be one of acceleration-increments"):
        predict(f, 1.0, 1.0, "jerk")
    with pytest.raises(ValueError, match="interval must be a number at least 1e-10"):
        predict(f, 0.0, 1.0)
    with pytest.raises(ValueError, match="diagonal_1 must be"):
        update(uncorrelated(-1.0, 1.0, 1.0), 1.0)
    with pytest.raises(TypeError, match="detected must be true or false, got int64"):
        step(f, 1.0, 1.0, 1.0, 1)
