"""The judge's own steady states and fits against oracles, and what it refuses to establish."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import flint
import pytest
from one_of_each import further

from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.witness import value_ball
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.setting import steady_state as module
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, NotEstablished
from gainproof.verify.judge.setting.quantities import memory, steady_state
from gainproof.verify.judge.setting.spectral_factor import Factor
from gainproof.verify.judge.setting.stable_factor import stable_factor
from gainproof.verify.judge.setting.three_states import SHARE
from gainproof.verify.oracles import doubling, least_squares
from gainproof.verify.oracles.state_space import state_space

NOISES = {
    "random-velocity": [["0", "0"], ["0", "1"]],
    "random-acceleration": [["1/4", "1/2"], ["1/2", "1"]],
    "continuous-white-acceleration": [["1/3", "1/2"], ["1/2", "1"]],
    "no kinematic noise": [["2", "-1/3"], ["-1/3", "5/7"]],
}

THREE: dict[str, Any] = {
    "name": "three states",
    "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
    "measurement": [["1", "0", "0"]],
    "measurement_noise": [["1"]],
}
INCREMENTS = [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "1"]]
THROUGH_POSITION = [["1/4", "1/2", "1/2"], ["1/2", "1", "1"], ["1/2", "1", "1"]]
UNIT = [["1", "0"], ["0", "1"]]
UNIT_OF_THREE = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
UNDRIVEN = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "0"]]
INDEFINITE = [["-3", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
NEGATIVE = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "-1"]]
DECAYING = [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1/2"]]


def model(name: str) -> dict[str, Any]:
    return {
        "name": name,
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": NOISES[name],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }


def at(expr: Expr, **values: Fraction) -> Any:
    """A ball round an expression with its symbols put in."""
    plain = roots_made_prime(substituted(expr, {n: number(v) for n, v in values.items()}))
    tower = build_tower([plain], None, (), frozenset())
    return value_ball(Local(tower, Place()), tower.element(plain), None, 300, ())


@pytest.mark.parametrize("name", NOISES)
@pytest.mark.parametrize("index", [Fraction(1, 1000), further(Fraction(1)), Fraction(400)])
def test_steady_state_agrees_with_doubling(name: str, index: Fraction) -> None:
    found = steady_state(model(name)).quantities
    truth = doubling.steady_state(state_space(model(name), index), 40).state
    expected = {
        "filter_gain.1": truth.gain[0][0],
        "filter_gain.2": truth.gain[1][0],
        "predicted_covariance.1.1": truth.predicted[0][0],
        "predicted_covariance.1.2": truth.predicted[0][1],
        "predicted_covariance.2.2": truth.predicted[1][1],
        "updated_covariance.2.2": truth.updated[1][1],
        "innovation_variance": truth.innovation[0][0],
    }
    for quantity, value in expected.items():
        ball = at(found[quantity], **{INDEX: index, INTERVAL: Fraction(1), DEVIATION: Fraction(1)})
        with flint.ctx.workprec(300):
            assert abs(ball - flint.arb(str(value))) < abs(ball) * flint.arb("1e-35"), quantity


@pytest.mark.parametrize(
    ("transition", "measurement"),
    [
        ([["1", "2"], ["0", "1"]], [["1", "0"]]),
        ([["1/2", "1"], ["0", "2/3"]], [["1", "0"]]),
        ([["1", "1"], ["-1/4", "1"]], [["1", "1/2"]]),
    ],
)
def test_other_transitions_and_observables(transition: Any, measurement: Any) -> None:
    data = {**model("random-acceleration"), "transition": transition, "measurement": measurement}
    found = steady_state(data).quantities
    truth = doubling.steady_state(state_space(data, 2), 40).state
    for i in (0, 1):
        ball = at(found[f"filter_gain.{i + 1}"], **{INDEX: Fraction(2)})
        with flint.ctx.workprec(300):
            assert abs(ball - flint.arb(str(truth.gain[i][0]))) < flint.arb("1e-30")


@pytest.mark.parametrize(
    ("transition", "measurement", "noise"),
    [("1", "1", "1"), ("1", "1", "1/4"), ("1/2", "1", "3"), ("-3/2", "2", "1"), ("5", "-1", "2/3")],
)
def test_one_state_agrees_with_doubling(transition: str, measurement: str, noise: str) -> None:
    data = {
        "transition": [[transition]],
        "process_noise": [[noise]],
        "measurement": [[measurement]],
        "measurement_noise": [["1"]],
    }
    found = steady_state(data).quantities
    for index in (Fraction(1, 50), Fraction(3)):
        truth = doubling.steady_state(state_space(data, index), 40).state
        ball = at(found["filter_gain.1"], **{INDEX: index})
        with flint.ctx.workprec(300):
            assert abs(ball - flint.arb(str(truth.gain[0][0]))) < flint.arb("1e-30")


@pytest.mark.parametrize("noise", [INCREMENTS, THROUGH_POSITION])
def test_three_states_agree_with_doubling(noise: Any) -> None:
    data = {**THREE, "process_noise": noise}
    found = steady_state(data).quantities
    for share in (Fraction(1, 10), Fraction(2, 3)):
        point = {SHARE: share, INTERVAL: Fraction(1), DEVIATION: Fraction(1)}
        index = found[INDEX]
        value = substituted(index, {SHARE: number(share)})
        exact = constant_value(value)
        assert exact is not None
        truth = doubling.steady_state(state_space(data, exact), 60).state
        for i in range(3):
            ball = at(found[f"filter_gain.{i + 1}"], **point)
            with flint.ctx.workprec(300):
                assert abs(ball - flint.arb(str(truth.gain[i][0]))) < flint.arb("1e-30")
        ball = at(found["predicted_covariance.2.3"], **point)
        with flint.ctx.workprec(300):
            assert abs(ball - flint.arb(str(truth.predicted[1][2]))) < flint.arb("1e-25")


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_fit_agrees_with_exact_least_squares(degree: int) -> None:
    found = memory(degree).quantities
    for k in (degree, degree + 1, 9, 100):
        expected = least_squares.gains(degree, k)
        for i, value in enumerate(expected):
            ball = at(found[f"filter_gain.{i + 1}"], sample_number=Fraction(k))
            with flint.ctx.workprec(300):
                exact = flint.arb(
                    flint.fmpq(Fraction(value).numerator, Fraction(value).denominator)
                )
                assert abs(ball - exact) < flint.arb("1e-60")


def test_wrong_factor_is_not_established(monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(*arguments: Any) -> Factor:
        true = stable_factor(*arguments)
        return replace(true, innovation=true.innovation * number(Fraction(10**12 + 1, 10**12)))

    monkeypatch.setattr(module, "stable_factor", wrong)
    with pytest.raises(NotEstablished):
        module.solve(model("random-velocity"))


def test_unstable_solution_is_not_established(monkeypatch: pytest.MonkeyPatch) -> None:
    """The other root of the spectrum solves the Riccati equation too."""

    def mirrored(*arguments: Any) -> Factor:
        true = stable_factor(*arguments)
        c0, c1 = true.coefficients
        return Factor((1 / c0, c1 / c0), true.innovation * c0 * c0)

    monkeypatch.setattr(module, "stable_factor", mirrored)
    with pytest.raises(NotEstablished, match=r"stable|positive"):
        module.solve(model("random-velocity"))


@pytest.mark.parametrize(
    ("change", "error"),
    [
        ({"measurement": [["0", "1"]]}, Undecided),
        ({"measurement_noise": [["2"]]}, Undecided),
        ({"process_noise": [["1", "1/2"]]}, Malformed),
        ({"process_noise": [["1.5", "0"], ["0", "1"]]}, Malformed),
        ({"measurement": [["1", "0"], ["0", "1"]], "measurement_noise": UNIT}, Undecided),
        ({**THREE, "process_noise": UNDRIVEN}, Undecided),
        ({**THREE, "process_noise": UNIT_OF_THREE, "transition": UNIT_OF_THREE}, Undecided),
        ({**THREE, "process_noise": UNIT_OF_THREE, "transition": DECAYING}, Undecided),
        ({**THREE, "process_noise": INDEFINITE}, NotEstablished),
        ({**THREE, "process_noise": NEGATIVE}, Undecided),
    ],
)
def test_models_it_cannot_solve(change: dict[str, Any], error: type[Exception]) -> None:
    with pytest.raises((error, NotEstablished)):
        steady_state({**model("random-velocity"), **change})


def test_what_is_no_fit() -> None:
    assert "first_updated_state.1" in memory(1).missing
    assert memory(0).quantities["first_updated_state.1"] == symbol("first_measurement")
    with pytest.raises(Undecided):
        memory(4)
