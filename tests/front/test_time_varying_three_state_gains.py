"""Three states: when steady gains will do, and how long a fitted parabola does.

The oracles know the matrices: poles in balls from the innovation's spectrum, the Kalman recursion
of whole matrices in 60 digits or fractions, and least squares over all samples at once.
"""

from __future__ import annotations

import itertools
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from recursion_triples import model, three_positions, unit_noise
from samples import samples

from gainproof.time_varying.three_states import (
    PROCESS_NOISES,
    Factors,
    error_ratio,
    factors_of,
    samples_to_steady_gains,
    uncorrelated,
)
from gainproof.verify.oracles import ball, recursion
from gainproof.verify.oracles.doubling import steady_state
from gainproof.verify.oracles.matrices import (
    Matrix,
    identity,
    matrix,
    product,
    scale,
    subtract,
    transpose,
)
from gainproof.verify.oracles.multiprecision import context, fraction, number_in
from gainproof.verify.oracles.riccati import closed_loop, predict, update
from gainproof.verify.oracles.spectrum import spectrum

NAMES = sorted(PROCESS_NOISES)
EVERY = pytest.mark.parametrize(
    "name", cases(NAMES, {"acceleration-increments", "random-jerk"}.__contains__)
)
ONE = Fraction(1)


@EVERY
@settings(max_examples=samples(8), deadline=None)
@given(st.floats(-9, 7).map(lambda e: 10.0**e))
def test_error_ratio(name: str, index: float) -> None:
    """Against certified poles; beside a double one half of the digits are left."""
    exact = ball.enclose(spectrum(model(name, ONE)), Fraction(index), 30).poles
    truth = max(float((abs(z) ** 2).mid()) for z in exact)
    away = [complex(float((1 - z).real.mid()), float(z.imag.mid())) for z in exact]
    apart = min(abs(x - y) / max(abs(x), abs(y)) for i, x in enumerate(away) for y in away[:i])
    room = min(2.0**-47 / apart, 2.0**-24)
    assert float(error_ratio(index, name)) == pytest.approx(truth, rel=room)


@EVERY
def test_another_index_has_another_ratio(name: str) -> None:
    for index in (0.03, 0.3, 3.0):
        exact = ball.enclose(spectrum(model(name, ONE)), Fraction(index), 30).poles
        truth = max(float((abs(z) ** 2).mid()) for z in exact)
        assert abs(float(error_ratio(index * 1.0001, name)) / truth - 1) > 1e-6


def test_error_ratio_at_the_ends() -> None:
    for name in NAMES:
        found = np.asarray(error_ratio([[1e-300, 1e-60], [1e60, 1e300]], name))
        assert ((found > 0) & (found <= 1)).all()
        assert (found[0] == 1).all()
        # without a spectrum at half the sampling frequency a pole goes to -1
        assert (found[1] == 1).all() == (name in {"acceleration-increments", "wiener-acceleration"})


def test_noises_are_those_of_the_kernels() -> None:
    for name, noise in PROCESS_NOISES.items():
        wanted = np.array(model(name, ONE).process_noise, float)
        assert noise.unit_covariance == pytest.approx(wanted, rel=1e-16, abs=0)
        for t, q, r in ((2.0, 3.0, 5.0), (0.5, 0.1, 7.0)):
            whole = float(q * unit_noise(noise.name, Fraction(t))[2][2])
            assert noise.tracking_index(t, q, r) ** 2 == pytest.approx(whole * t**4 / r, rel=1e-14)


@EVERY
def test_the_distance_is_multiplied_by_closed_loops_exactly(name: str) -> None:
    """P_k - B_k = A(P_k-1)...A(P_0) (P_0 - B_0) (A(B_k-1)...A(B_0))', and one start stays above."""
    system = model(name, Fraction(2, 3))
    p = matrix([[9, 1, 1], [1, 5, 1], [1, 1, 4]], Fraction)
    b = matrix([[1, 0, 0], [0, "1/2", 0], [0, 0, "1/3"]], Fraction)
    left = right = identity(3, ONE)
    first = bound = subtract(p, b)
    for _ in range(5):
        one, other = update(system, p), update(system, b)
        left = product(closed_loop(system, one.gain), left)
        right = product(closed_loop(system, other.gain), right)
        bound = product(right, first, transpose(right))
        p, b = predict(system, one.updated), predict(system, other.updated)
        gap = subtract(p, b)
        assert gap == product(left, first, transpose(right))
        assert_not_below_zero(gap)
        assert_not_below_zero(subtract(bound, gap))


def assert_not_below_zero(g: Matrix) -> None:
    """Every principal minor, exactly."""
    for i in range(3):
        assert g[i][i] >= 0
        for j in range(i):
            assert g[i][i] * g[j][j] >= g[i][j] ** 2
    (a, b, c), (_, d, e), (_, _, f) = g
    assert a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d) >= 0


RUNS = list(itertools.product(NAMES, (0.01, 1.0), (50.0, 1e-3)))
"""Each family, to an index, from above and from below."""


@pytest.mark.alike
@pytest.mark.parametrize(
    ("name", "index", "first"),
    cases(RUNS, lambda run: run[0] == NAMES[0] or run[1:] in ((0.01, 50.0), (1.0, 1e-3))),
)
def test_the_ratio_is_that_of_the_run(name: str, index: float, first: float) -> None:
    """Over many samples, by multiprecision: complex poles make single quotients swing."""
    system = model(name, Fraction(index))
    steady = steady_state(system, 60).state.predicted
    own = context(400)
    number = number_in(own)
    ratio = float(error_ratio(index, name))
    count = int(12 / -np.log(ratio))
    begin = matrix(scale(Fraction(first), identity(3, ONE)), number)
    states = recursion.transient(system, begin, 3 * count + 1, number)
    far, near = (
        max(
            abs(x - number(fraction(y)))
            for row, known in zip(each.predicted, steady, strict=True)
            for x, y in zip(row, known, strict=True)
        )
        for each in (states[count], states[3 * count])
    )
    measured = float(own.log(near / far)) / (2 * count)
    assert measured == pytest.approx(np.log(ratio), rel=0.15)


@EVERY
@pytest.mark.parametrize("share", cases([0.1, 1e-3], lambda share: share == 1e-3))
def test_samples_to_steady_gains(name: str, share: float) -> None:
    """Against a recursion of whole matrices that starts from the batch of three positions."""
    indices = np.array([0.02, 0.7, 9.0])
    found = samples_to_steady_gains(indices, share, name)
    assert found.dtype == np.int64
    own = context(200)
    number = number_in(own)
    for index, count in zip(indices.tolist(), found.tolist(), strict=True):
        system = model(name, Fraction(index))
        known = [fraction(row[0]) for row in steady_state(system, 30).state.gain]
        begin = predict(system, three_positions(name, Fraction(index)))
        states = recursion.transient(system, matrix(begin, number), 2 * count + 30, number)
        outside = [
            at
            for at, state in enumerate(states, 1)
            if any(
                abs(float(row[0]) / float(wanted) - 1) > share
                for row, wanted in zip(state.gain, known, strict=True)
            )
        ]
        assert max(outside, default=0) == count


def test_a_start_of_ones_own() -> None:
    p = np.array(steady_state(model("random-jerk", Fraction(1, 2)), 30).state.updated, object)
    own = factors_of(np.vectorize(lambda x: float(fraction(x)))(p))
    assert samples_to_steady_gains(0.5, 1e-6, "random-jerk", own) == 0
    assert samples_to_steady_gains(0.5, 1e-6, "random-jerk") > 5
    many = Factors(*(np.full(3, x) for x in own))
    assert samples_to_steady_gains(0.5, 1e-6, "random-jerk", many).tolist() == [0, 0, 0]
    assert samples_to_steady_gains(0.5, 1e-3, after=uncorrelated(1e6, 1e6, 1e6)) > 2


def test_what_is_refused() -> None:
    with pytest.raises(ValueError, match="share must lie above 1e-12 and below 1, got 1"):
        samples_to_steady_gains(1.0, 1)
    with pytest.raises(ValueError, match=r"may take .* samples, over 2000000"):
        samples_to_steady_gains(1e-18, 0.01)
    with pytest.raises(ValueError, match="process_noise must be one of"):
        error_ratio(1.0, "jerk")
