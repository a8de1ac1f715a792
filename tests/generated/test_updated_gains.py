"""Kernels of gains that follow the index, against Riccati solutions and matrices in balls."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from polar_points import misses
from samples import samples
from updated_gains_truth import WORKING, exact_gains, tangents, variances

from gainproof.generated import random_acceleration, updated_gains
from gainproof.verify.oracles.fixed_gain import ball

DTYPES = pytest.mark.parametrize("dtype", ["float64", "float32"])
Values = Mapping[str, flint.arb]


def tracking_index(deviation: float, interval: float, variance: float) -> Values:
    return {"tracking_index": ball(deviation) * ball(interval) ** 2 / ball(variance).sqrt()}


def first_order_gains(nominal: float, index: float) -> Values:
    start = Fraction(nominal)
    alpha, beta = tangents(exact_gains(start), start, ball(index))
    return {"alpha": alpha, "beta": beta}


def recursive_gains(alpha: float, beta: float, index: float, following: float) -> Values:
    at = exact_gains(Fraction(index))
    step = ball(following) - ball(index)
    return {
        "next_alpha": ball(alpha) + at.alpha_slope * step,
        "next_beta": ball(beta) + at.beta_slope * step,
    }


def recursive_terms(alpha: float, beta: float, index: float, following: float) -> Values:
    """The step of the index is a difference of inputs, rounded once: it is one term."""
    at = exact_gains(Fraction(index))
    step = abs(ball(following) - ball(index))
    return {
        "next_alpha": abs(ball(alpha)) + at.alpha_slope * step,
        "next_beta": abs(ball(beta)) + at.beta_slope * step,
    }


def first_order_errors(nominal: float, index: float) -> Values:
    start, here = Fraction(nominal), Fraction(index)
    alpha, beta = tangents(exact_gains(start), start, ball(here))
    at, square = exact_gains(here), (ball(here) - ball(start)) ** 2
    return {
        "alpha_excess_over_square": (alpha - at.alpha) / square,
        "beta_excess_over_square": (beta - at.beta) / square,
    }


def cycle_drift(nominal: float, index: float) -> Values:
    """There by the tangent at the nominal index, back by that at the other."""
    start, here = Fraction(nominal), Fraction(index)
    first, second = exact_gains(start), exact_gains(here)
    there = tangents(first, start, ball(here))
    back, square = ball(start) - ball(here), (ball(here) - ball(start)) ** 2
    return {
        "alpha_drift_over_square": (there[0] + second.alpha_slope * back - first.alpha) / square,
        "beta_drift_over_square": (there[1] + second.beta_slope * back - first.beta) / square,
    }


def mismatch_variances(nominal: float, index: float) -> Values:
    here = ball(index)
    held = variances(exact_gains(Fraction(nominal))[:2], here)
    least = variances(exact_gains(Fraction(index))[:2], here)
    return held | {f"{name}_ratio": held[name] / least[name] for name in held}


def line_of_sight_gains(along: float, across: float, cosine: float, sine: float) -> Values:
    """D diag(along, across) D', as matrices."""
    c, s = ball(cosine), ball(sine)
    turn = flint.arb_mat([[c, -s], [s, c]])
    own = flint.arb_mat([[ball(along), ball(0)], [ball(0), ball(across)]])
    found = turn * own * turn.transpose()
    return {"gain_xx": found[0, 0], "gain_xy": found[0, 1], "gain_yy": found[1, 1]}


TRUTHS: tuple[Callable[..., Values], ...] = (
    tracking_index,
    first_order_gains,
    recursive_gains,
    first_order_errors,
    cycle_drift,
    mismatch_variances,
    line_of_sight_gains,
)
EACH = pytest.mark.parametrize("truth", TRUTHS, ids=lambda truth: truth.__name__)


def places(name: str, dtype: str, count: int, seed: int) -> Any:
    """Inputs: indices over their domain and ordinary ones, near pairs among them."""
    generator = np.random.default_rng(seed)
    limit = 12.0 if dtype == "float64" else 5.0
    wide = 10 ** generator.uniform(-limit, limit, (2, count))
    usual = 10 ** generator.uniform(-2, 2, (2, count))
    pair = np.where(generator.random(count) < 0.4, wide, usual)
    pair[1] = np.where(generator.random(count) < 0.2, pair[0] * (1 + 2.0**-18), pair[1])
    pair = np.clip(pair, 10**-limit * 1.001, 10**limit * 0.999)
    signs = generator.choice([-1.0, 1.0], (2, count))
    if name == "tracking_index":
        return (10 ** generator.uniform(-5, 5, (3, count))).astype(dtype)
    if name == "recursive_gains":
        return np.vstack([signs * 10 ** generator.uniform(-6, 1, (2, count)), pair]).astype(dtype)
    if name == "line_of_sight_gains":
        angle = generator.uniform(-math.pi, math.pi, count)
        sides = [np.cos(angle), np.sin(angle)]
        return np.vstack([generator.uniform(0.01, 1, (2, count)), sides]).astype(dtype)
    return pair.astype(dtype)


@EACH
@DTYPES
@pytest.mark.parametrize("count", [25, pytest.param(400, marks=pytest.mark.thorough)])
def test_errors_are_as_promised(truth: Callable[..., Values], dtype: str, count: int) -> None:
    kernel = getattr(updated_gains, truth.__name__)
    given_ = places(truth.__name__, dtype, count, seed=4)
    if truth in (first_order_errors, cycle_drift):
        given_ = given_[:, given_[0] != given_[1]]
    with flint.ctx.workprec(WORKING):
        terms = recursive_terms if truth is recursive_gains else None
        assert misses(kernel, given_, truth, terms) == []


@EACH
def test_a_promise_that_is_too_good_would_be_noticed(
    truth: Callable[..., Values], monkeypatch: pytest.MonkeyPatch
) -> None:
    import polar_points

    kernel = getattr(updated_gains, truth.__name__)
    better = {
        name: type(each)(
            {dtype: bound / 100 for dtype, bound in each.bound.items()},
            dict.fromkeys(each.bound, 0.0),
            each.by_terms,
        )
        for name, each in polar_points.promises(kernel).items()
    }
    monkeypatch.setattr(polar_points, "promises", lambda _: better)
    terms = recursive_terms if truth is recursive_gains else None
    with flint.ctx.workprec(WORKING):
        assert misses(kernel, places(truth.__name__, "float64", 12, seed=5), truth, terms)


INDICES = st.floats(-3, 3).map(lambda x: 10.0**x)


@settings(max_examples=samples(30), deadline=None)
@given(INDICES, INDICES)
def test_properties_of_updates(nominal: float, index: float) -> None:
    room = 60 * 2.0**-52
    exact = random_acceleration.gains(index)
    first = updated_gains.first_order_gains(nominal, index)
    errors = updated_gains.first_order_errors(nominal, index)
    square = (index - nominal) ** 2
    for kind in ("alpha", "beta"):
        excess = getattr(errors, f"{kind}_excess_over_square")
        assert excess > 0
        found, true = getattr(first, kind), getattr(exact, kind)
        assert found - true == pytest.approx(excess * square, abs=room * found)
    losses = updated_gains.mismatch_variances(nominal, index)
    assert all(
        value >= 1 - room for name, value in losses._asdict().items() if name.endswith("_ratio")
    )
    drift = updated_gains.cycle_drift(nominal, index)
    same = updated_gains.cycle_drift(index, nominal)
    assert drift.alpha_drift_over_square == pytest.approx(same.alpha_drift_over_square, rel=room)
    back = updated_gains.first_order_errors(index, nominal)
    total = errors.beta_excess_over_square + back.beta_excess_over_square
    assert drift.beta_drift_over_square == pytest.approx(total, rel=room)


def test_a_cycle_leaves_the_drift_behind() -> None:
    """The recursive form in a loop: after each cycle the same more, until it is not stable."""
    low, high = 0.5, 1.5
    start = random_acceleration.gains(low)
    drift = updated_gains.cycle_drift(low, high)
    gains, cycles = (start.alpha, start.beta), 0
    while 2 * gains[0] + gains[1] < 4:
        there = updated_gains.recursive_gains(*gains, low, high)
        back = updated_gains.recursive_gains(*there, high, low)
        gains, cycles = (back.next_alpha, back.next_beta), cycles + 1
        expected = start.alpha + cycles * drift.alpha_drift_over_square * (high - low) ** 2
        assert gains[0] == pytest.approx(expected, rel=1e-13)
    margin = 4 - 2 * start.alpha - start.beta
    each = 2 * drift.alpha_drift_over_square + drift.beta_drift_over_square
    assert cycles == math.ceil(margin / each)


@pytest.mark.parametrize("nominal", [0.01, 0.3, 2.0, 30.0])
def test_limits_are_where_they_are_said_to_be(nominal: float) -> None:
    limits = updated_gains.update_limits(nominal)
    for sign in (-1, 1):
        near = 1 + sign * 1e-9

        def at(ratio: Any, near: float = near) -> Any:
            return updated_gains.first_order_gains(nominal, nominal * float(ratio) * near)

        assert (at(limits.alpha_one_ratio).alpha > 1) is (sign > 0)
        first = at(limits.unstable_ratio)
        assert (2 * first.alpha + first.beta > 4) is (sign > 0)
    assert limits.alpha_one_ratio < limits.variance_ratio < limits.unstable_ratio
    step = limits.variance_ratio
    assert step - 1 / step == pytest.approx(math.sqrt(1 + 8 / nominal), rel=1e-14)


def test_arrays_of_tracks() -> None:
    """Two axes of many tracks at once, with one nominal index each; nothing else is touched."""
    nominal = np.array([[0.5], [0.2]])
    index = np.random.default_rng(2).uniform(0.1, 2, (2, 1000))
    found = updated_gains.first_order_gains(nominal, index)
    assert np.shape(found.alpha) == (2, 1000)
    one = updated_gains.first_order_gains(0.2, index[1, 7])
    assert np.asarray(found.alpha)[1, 7] == one.alpha
    assert np.asarray(found.beta)[1, 7] == one.beta
    single = updated_gains.first_order_gains(np.float32(0.5), index[0].astype(np.float32))
    assert np.asarray(single.alpha).dtype == np.float32


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: updated_gains.tracking_index(1, 1, 0.0), "variance must be a number at least"),
        (lambda: updated_gains.tracking_index(1, -1, 1), "interval must be a number at least"),
        (lambda: updated_gains.update_limits(math.nan), "nominal_index must be a number"),
        (lambda: updated_gains.first_order_gains(1, [1, 0.0]), r"tracking_index .* at index 1"),
        (lambda: updated_gains.recursive_gains(math.inf, 1, 1, 1), "alpha must be 0 or of"),
        (lambda: updated_gains.line_of_sight_gains(1, 1, 3, 0), "cosine must be of magnitude"),
    ],
)
def test_outside_the_domain(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()
