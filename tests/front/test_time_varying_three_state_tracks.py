"""Sequences of gains of three states, sample by sample, and covariances given by their entries.

The oracles: the recursion of whole matrices in fractions, which knows F, Q and H of each interval,
and the normal equations of the whole track, in which there is no recursion.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from recursion_tracks import noise_of
from recursion_triples import ROW, covariance, move
from samples import samples

from gainproof.time_varying.three_states import (
    PROCESS_NOISES,
    Factors,
    covariance_of,
    factors_of,
    gain_sequence,
    start,
    step,
    uncorrelated,
    update,
)
from gainproof.verify.oracles.riccati import predict as predicted_by
from gainproof.verify.oracles.riccati import update as updated_by
from gainproof.verify.oracles.state_space import StateSpace
from gainproof.verify.oracles.trajectory import last_covariance

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize(
    "name", cases(NAMES, {"acceleration-increments", "random-jerk"}.__contains__)
)
ONE = Fraction(1)
SIZE = st.floats(-3, 3).map(lambda e: 10.0**e)
SHEAR = st.floats(-2, 2).map(lambda e: 10.0**e)
FACTORS = st.builds(Factors, SIZE, SIZE, SIZE, SHEAR, SHEAR, SHEAR)
# of each sample: at most 17 and 8 epsilon in a factor, of which an entry or a gain takes up to six
ROOM = 6 * 25 * 2.0**-52


@EVERY
def test_a_sequence_of_tracks_is_that_of_each_and_of_the_batch(name: str) -> None:
    generator = np.random.default_rng(5)
    intervals = 10.0 ** generator.uniform(-1, 1, (6, 4))
    detected = generator.random((7, 4)) < 0.7
    f = Factors(*(10.0 ** generator.uniform(-1, 1, 4) for _ in range(6)))
    r, q = np.array([1.0, 2.0, 0.5, 30.0]), np.array([0.1, 1.0, 3.0, 0.01])
    whole = gain_sequence(f, intervals, q, r, detected, name)
    assert whole.position_gain.shape == (7, 4)
    for gain in whole[:3]:
        assert not gain[~detected].any()
        assert (gain[detected] > 0).all()
    assert (whole.innovation_variance > r).all()
    for track in range(4):
        own = Factors(*(np.asarray(x)[track] for x in f))
        chosen = q[track], r[track], detected[:, track], name
        single = gain_sequence(own, intervals[:, track], *chosen)
        for x, y in zip(single, whole, strict=True):
            assert x.tobytes() == y[:, track].tobytes()
        moves = [
            move(PROCESS_NOISES[name].name, Fraction(float(t)), Fraction(float(q[track])))
            for t in intervals[:, track]
        ]
        seen = [bool(each) for each in detected[:, track]]
        truth = last_covariance(covariance(own), moves, seen, ROW, Fraction(float(r[track])))
        found = covariance_of(single.factors)[-1]
        for i in range(3):
            for j in range(3):
                assert abs(Fraction(float(found[i, j])) / truth[i][j] - 1) < 7 * ROOM


@EVERY
def test_gains_of_every_sample(name: str) -> None:
    """From a chosen start covariance, against the recursion of whole matrices in fractions."""
    chosen, q, r = uncorrelated(400.0, 90.0, 4.0), 0.5, 9.0
    intervals, seen = [1.0, 0.25, 3.0, 10.0, 0.5, 1.0], [True, True, False, True, True, False, True]
    found = gain_sequence(chosen, intervals, q, r, seen, name)
    p = covariance(chosen)
    for number, detected in enumerate(seen):
        if number:
            one = move(PROCESS_NOISES[name].name, Fraction(intervals[number - 1]), Fraction(q))
            p = predicted_by(StateSpace(one.transition, noise_of(one), ROW, ((ONE,),)), p)
        new = updated_by(StateSpace(p, p, ROW, ((Fraction(r),),)), p)
        p = new.updated if detected else p
        pairs = [(found.innovation_variance, new.innovation[0][0])]
        if detected:
            pairs += [(gain, row[0]) for gain, row in zip(found[:3], new.gain, strict=True)]
        for values, true in pairs:
            assert abs(Fraction(float(values[number])) - true) <= 7 * ROOM * true
    other = gain_sequence(chosen, intervals, q * (1 + 1e-9), r, seen, name)
    assert abs(other.position_gain[-1] / found.position_gain[-1] - 1) > 7 * ROOM


def test_the_start_from_three_positions_is_the_limit_of_an_unknown_state() -> None:
    for name in NAMES:
        f = start(2.0, 3.0, 0.3, 5.0, name)
        vague = update(Factors(5.0 * (1 - 1e-12), 1e14, 1e14, 0.0, 0.0, 0.0), 5e12)
        second = step(vague.factors, 2.0, 0.3, 5.0, process_noise=name)
        third = step(second.factors, 3.0, 0.3, 5.0, process_noise=name)
        assert covariance_of(third.factors) == pytest.approx(covariance_of(f), rel=1e-9)


@settings(max_examples=samples(12), deadline=None)
@given(FACTORS)
def test_factors_and_entries(f: Factors) -> None:
    exact = covariance(f)
    p = np.array([[float(x) for x in row] for row in exact])
    try:
        back = factors_of(p)
    except ValueError:
        # rounded entries hold too few digits of what is left of the position's variance
        assert float(f.diagonal_1) < 1e-12 * p[0, 0] or float(f.diagonal_2) < 1e-12 * p[1, 1]
        return
    for found, true in zip(covariance(back), p.tolist(), strict=True):
        assert [float(x) for x in found] == pytest.approx(true, rel=2.0**-47)
    some = factors_of(np.stack([p, np.eye(3)]))
    assert [float(np.asarray(x)[0]) for x in some] == [float(x) for x in back]


def test_factors_are_rounded_once() -> None:
    p = np.array([[3.0, 2.0, 1.0], [2.0, 2.0, 1.0], [1.0, 1.0, 1.0 + 2.0**-52]])
    found = factors_of(p)
    last = Fraction(1) + Fraction(1, 2**52)
    minor = 2 * last - 1
    assert found.diagonal_3 == float(last)
    assert found.diagonal_2 == float(minor / last)
    assert found.first_shear == 1
    assert found.second_shear == float(1 / last)
    assert found.third_shear == 0
    assert found.diagonal_1 == float((3 * minor - 2 * (2 * last - 1)) / minor) == 1


def test_what_is_refused() -> None:
    f = uncorrelated(1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match=r"positive definite; .* at index 1"):
        factors_of(np.stack([np.eye(3), np.ones((3, 3))]))
    with pytest.raises(ValueError, match="must be finite and symmetric"):
        factors_of([[1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    with pytest.raises(ValueError, match="must be finite and symmetric"):
        factors_of(np.full((3, 3), np.nan))
    with pytest.raises(ValueError, match=r"must have shape \(\.\.\., 3, 3\), got \(2, 2\)"):
        factors_of(np.eye(2))
    for i, j in ((0, 1), (0, 2), (1, 2)):
        p = np.eye(3)
        p[i, j] = p[j, i] = -0.5
        with pytest.raises(ValueError, match="must be 0 or above, got"):
            factors_of(p)
    with pytest.raises(ValueError, match="must be 0 or above, got"):
        factors_of([[2.0, 0.0, 0.5], [0.0, 1.0, 0.0], [0.5, 0.0, 1.0]])
    with pytest.raises(ValueError, match="first axis"):
        gain_sequence(f, 1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="2 intervals need 3 samples, detected has 2"):
        gain_sequence(f, [1.0, 1.0], 1.0, 1.0, [True, False])
    with pytest.raises(TypeError, match="detected must be true or false, got int64"):
        gain_sequence(f, [1.0], 1.0, 1.0, [1, 1])
    with pytest.raises(ValueError, match="first_interval must be a number at least 1e-10"):
        start(0.0, 1.0, 1.0, 1.0)


def test_single_precision_stays() -> None:
    f = start(np.float32(1), np.float32(0.5), np.float32(0.1), np.float32(2))
    found = step(f, np.float32(1), np.float32(0.1), np.float32(2), np.array([True, False]))
    assert {np.asarray(x).dtype for x in (*found.factors, *found[1:])} == {np.dtype(np.float32)}
