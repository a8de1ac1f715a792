"""Arrays of tracks: properties of the recursion, its guards, and sequences against the batch."""

from __future__ import annotations

from fractions import Fraction
from importlib import import_module

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from recursion_tracks import entries, move
from samples import samples

from gainproof.time_varying import (
    PROCESS_NOISES,
    Factors,
    covariance_of,
    factors_of,
    gain_sequence,
    predict,
    start,
    step,
    update,
)
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.trajectory import last_covariance

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize("name", cases(NAMES, {NAMES[0], NAMES[-1]}.__contains__))
SIZE = st.floats(-4, 4).map(lambda e: 10.0**e)
TIME = st.floats(-2, 2).map(lambda e: 10.0**e)
FACTORS = st.builds(Factors, SIZE, st.one_of(st.just(0.0), TIME), SIZE)
ROW = matrix([[1, 0]], Fraction)


@EVERY
@settings(max_examples=samples(6), deadline=None)
@given(FACTORS, st.lists(st.tuples(TIME, st.booleans()), min_size=1, max_size=30), SIZE, SIZE)
def test_covariances_stay_positive_definite(
    name: str, f: Factors, samples: list[tuple[float, bool]], q: float, r: float
) -> None:
    for interval, seen in samples:
        f = step(f, interval, q, r, seen, name).factors
        assert f.diagonal_1 > 0
        assert f.diagonal_2 > 0
        assert f.shear >= 0
        # the factors' own matrix, exactly: no rounding can have made it indefinite
        (a, b), (_, c) = entries(f)
        assert a * c - b * b > 0


@EVERY
@settings(max_examples=samples(8), deadline=None)
@given(FACTORS, TIME, SIZE, SIZE, st.integers(0, 5), st.integers(1, 5))
def test_a_missed_detection_only_raises_the_variance(
    name: str, f: Factors, t: float, q: float, r: float, missed: int, later: int
) -> None:
    """At the sample and at every later one, in every direction: P - X is not below zero."""
    count = missed + later
    seen = np.ones(count + 1, bool)
    less = seen.copy()
    less[missed] = False
    both = [gain_sequence(f, [t] * count, q, r, which, name).factors for which in (seen, less)]
    full, poor = (covariance_of(each) for each in both)
    room = 64 * 2.0**-52 * count  # of the entries, for the rounding of both runs
    for at in range(missed, count + 1):
        gap = poor[at] - full[at]
        size = np.sqrt(np.outer(np.diag(poor[at]), np.diag(poor[at]))) * room
        assert gap[0, 0] >= -size[0, 0]
        assert gap[1, 1] >= -size[1, 1]
        determinant = (gap[0, 0] + size[0, 0]) * (gap[1, 1] + size[1, 1]) - gap[0, 1] ** 2
        most = (gap[0, 0] + size[0, 0]) * size[1, 1] + (gap[1, 1] + size[1, 1]) * size[0, 0]
        assert determinant >= -4 * most


@pytest.mark.alike
@EVERY
@pytest.mark.parametrize(
    "index", cases([0.05, 0.3, 1.0, 4.0, 20.0], lambda index: index in {0.05, 1.0, 20.0})
)
@pytest.mark.parametrize("interval", cases([0.25, 1.0, 7.0], lambda interval: interval != 1))
def test_equal_intervals_come_to_the_steady_state(name: str, index: float, interval: float) -> None:
    noise = PROCESS_NOISES[name]
    r = 3.0
    q = index**2 * r / interval ** (2 + noise.power)
    assert noise.tracking_index(interval, q, r) == pytest.approx(index, rel=1e-15)
    found = step(Factors(50.0, 0.0, 20.0), interval, q, r, process_noise=name)
    f = found.factors
    for _ in range(600):
        found = step(f, interval, q, r, process_noise=name)
        f = found.factors
    module = import_module(f"gainproof.generated.{noise.name}")
    known, gains = module.updated_covariance(index), module.gains(index)
    # bounds of both kernels, and of an index that q and the interval give to 4 units
    assert found.position_gain == pytest.approx(gains.alpha, rel=1e-14)
    assert found.velocity_gain * interval == pytest.approx(gains.beta, rel=1e-14)
    p = covariance_of(f) / r
    assert p[0, 0] == pytest.approx(known.updated_11, rel=1e-14)
    assert p[0, 1] * interval == pytest.approx(known.updated_12, rel=1e-14)
    assert p[1, 1] * interval**2 == pytest.approx(known.updated_22, rel=1e-14)
    other = module.gains(index * 1.0001)
    assert abs(found.position_gain / other.alpha - 1) > 1e-9


@settings(max_examples=samples(12), deadline=None)
@given(FACTORS, TIME, TIME, SIZE)
def test_two_predictions_add_their_intervals(f: Factors, s: float, t: float, q: float) -> None:
    """Of white acceleration, in any order; of the noises of the samples only without noise."""
    for name in NAMES:
        strength = q if name == "continuous-white-acceleration" else 0.0
        whole = predict(f, s + t, strength, name)
        for one, other in ((s, t), (t, s)):
            parts = predict(predict(f, one, strength, name), other, strength, name)
            # two predictions of at most 6 epsilon, one of as many, and the sum of intervals, which
            # enters by its cube
            assert parts == pytest.approx(whole, rel=40 * 2.0**-52)
    twice = predict(predict(f, s, q, "random-velocity"), t, q, "random-velocity")
    assert twice.diagonal_2 > predict(f, s + t, q, "random-velocity").diagonal_2
    cut = predict(predict(f, s, q, "random-acceleration"), t, q, "random-acceleration")
    assert cut.diagonal_2 < predict(f, s + t, q, "random-acceleration").diagonal_2 * (1 + 1e-14)


@EVERY
def test_a_sequence_of_tracks_is_that_of_each_and_of_the_batch(name: str) -> None:
    generator = np.random.default_rng(5)
    intervals = 10.0 ** generator.uniform(-1, 1, (6, 4))
    detected = generator.random((7, 4)) < 0.7
    f = Factors(*(10.0 ** generator.uniform(-1, 2, 4) for _ in range(3)))
    r = np.array([1.0, 2.0, 0.5, 30.0])
    q = np.array([0.1, 1.0, 3.0, 0.01])
    whole = gain_sequence(f, intervals, q, r, detected, name)
    assert whole.position_gain.shape == (7, 4)
    assert not whole.position_gain[~detected].any()
    assert not whole.velocity_gain[~detected].any()
    assert (whole.position_gain[detected] > 0).all()
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
        truth = last_covariance(entries(own), moves, seen, ROW, Fraction(float(r[track])))
        found = covariance_of(single.factors)[-1]
        for i, j in ((0, 0), (0, 1), (1, 1)):
            assert abs(Fraction(float(found[i, j])) / truth[i][j] - 1) < 7 * 17 * 2.0**-52


def test_the_start_from_two_positions_is_the_limit_of_an_unknown_velocity() -> None:
    for name in NAMES:
        f = start(2.0, 0.3, 5.0, name)
        vague = update(Factors(5.0 * (1 - 1e-12), 0.0, 1e14), 5e12)  # one position, no velocity
        second = step(vague.factors, 2.0, 0.3, 5.0, process_noise=name)
        assert second.factors == pytest.approx(f, rel=1e-10)


@settings(max_examples=samples(12), deadline=None)
@given(FACTORS)
def test_factors_and_entries(f: Factors) -> None:
    p = covariance_of(f)
    if float(p[0, 0]) > 1e6 * float(f.diagonal_1):
        return  # the entries do not hold enough digits of d1
    back = factors_of(p[0, 0], p[0, 1], p[1, 1])
    # the entries are rounded; what d1 is of entry 11 amplifies that
    assert back == pytest.approx(f, rel=8 * 2.0**-52 * float(p[0, 0] / f.diagonal_1))


def test_the_determinant_keeps_its_digits() -> None:
    p11, p12, p22 = 1.0 + 2.0**-52, 1.0, 1.0
    assert factors_of(p11, p12, p22).diagonal_1 == 2.0**-52
    p11, p12, p22 = 94906267.0, 94906266.0, 94906265.00000003
    exact = Fraction(p11) - Fraction(p12) ** 2 / Fraction(p22)
    assert float(factors_of(p11, p12, p22).diagonal_1) == pytest.approx(float(exact), rel=1e-15)


def test_what_is_refused() -> None:
    f = Factors(1.0, 0.0, 1.0)
    with pytest.raises(ValueError, match=r"positive definite; its determinant, got 0.0 at index 1"):
        factors_of([2.0, 1.0], 1.0, 1.0)
    with pytest.raises(ValueError, match=r"entry 12 .* must be 0 or above, got -1\.0"):
        factors_of(2.0, -1.0, 1.0)
    with pytest.raises(ValueError, match="positive definite"):
        factors_of(2.0, 1.0, np.nan)
    with pytest.raises(ValueError, match="process_noise must be one of"):
        predict(f, 1.0, 1.0, "jerk")
    with pytest.raises(ValueError, match="interval must be 0 or a number at least 1e-20"):
        predict(f, -1.0, 1.0)
    with pytest.raises(TypeError, match="detected must be true or false, got float64"):
        step(f, 1.0, 1.0, 1.0, 0.5)
    with pytest.raises(TypeError, match="detected must be true or false, got int"):
        gain_sequence(f, [], 1.0, 1.0, [1])
    with pytest.raises(ValueError, match="first axis"):
        gain_sequence(f, 1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="2 intervals need 3 samples, detected has 2"):
        gain_sequence(f, [1.0, 1.0], 1.0, 1.0, [True, False])


def test_single_precision_stays() -> None:
    f = Factors(*(np.float32(x) for x in (1.0, 0.5, 2.0)))
    found = step(f, np.float32(1), np.float32(0.1), np.float32(2), np.array([True, False]))
    assert {np.asarray(x).dtype for x in (*found.factors, *found[1:])} == {np.dtype(np.float32)}
