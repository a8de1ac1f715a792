"""Steady states of three-state models: against an oracle, in claims, and false neighbours."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import flint
import pytest
from one_of_each import cases, further
from small_claims import check, judged

from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.witness import value_ball
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment
from gainproof.verify.judge.setting.quantities import steady_state
from gainproof.verify.judge.setting.three_states import EXCESS, SHARE
from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.state_space import state_space

Rows = list[list[str]]


def through(*direction: str) -> Rows:
    """The noise that enters the state in one direction."""
    entries = [Fraction(x) for x in direction]
    return [[str(a * b) for b in entries] for a in entries]


INCREMENTS = through("0", "0", "1")
NOISES: dict[str, Rows] = {
    "acceleration increments": INCREMENTS,
    "acceleration noise": through("1/2", "1", "1"),
    "jerk constant over each interval": through("1/6", "1/2", "1"),
    "continuous white jerk": [
        ["1/20", "1/8", "1/6"],
        ["1/8", "1/3", "1/2"],
        ["1/6", "1/2", "1"],
    ],
    "no motion's noise": [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]],
    "increments of the position too": [["3", "0", "0"], ["0", "0", "0"], ["0", "0", "2/7"]],
    "a velocity against the acceleration": through("0", "-1", "1"),
    "zero at a frequency of the circle": through("1/6", "-1/2", "1"),
}


def model(name: str) -> dict[str, Any]:
    return {
        "name": name,
        "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
        "process_noise": NOISES[name],
        "measurement": [["1", "0", "0"]],
        "measurement_noise": [["1"]],
    }


def at(expr: Expr, **values: Fraction) -> Any:
    """A ball round an expression with its symbols put in."""
    plain = roots_made_prime(substituted(expr, {n: number(v) for n, v in values.items()}))
    tower = build_tower([plain], None, (), frozenset())
    return value_ball(Local(tower, Place()), tower.element(plain), None, 600, ())


@cache
def solved_for(name: str) -> Environment:
    return steady_state(model(name))


@pytest.mark.parametrize("name", cases(NOISES, lambda name: name in list(NOISES)[::2]))
@pytest.mark.parametrize(
    "place",
    cases([Fraction(1, 20), Fraction(3, 4), Fraction(40)], lambda place: place == Fraction(3, 4)),
)
def test_agrees_with_doubling(name: str, place: Fraction) -> None:
    solved = solved_for(name)
    assert solved.parameter in (SHARE, EXCESS)
    value = place / (1 + place) if solved.parameter == SHARE else place
    point = {solved.parameter: value, INTERVAL: Fraction(1), DEVIATION: Fraction(1)}
    found = solved.quantities
    # the oracle's index is off by 1e-75 at most
    with flint.ctx.workprec(600):
        index = Fraction(int((at(found[INDEX], **point) * 10**75).mid().floor().fmpz()), 10**75)
    truth = doubling.steady_state(state_space(model(name), index), 80).state
    expected = {
        **{f"filter_gain.{i + 1}": truth.gain[i][0] for i in range(3)},
        **{f"predicted_covariance.{i + 1}.3": truth.predicted[i][2] for i in range(3)},
        "updated_covariance.2.2": truth.updated[1][1],
        "innovation_variance": truth.innovation[0][0],
    }
    for quantity, true in expected.items():
        ball = at(found[quantity], **point)
        with flint.ctx.workprec(300):
            assert abs(ball - flint.arb(str(true))) < abs(ball) * flint.arb("1e-30"), quantity


GAINS = {
    "a": "{ quantity = 'gain.1', meaning = 'gain' }",
    "b": "{ quantity = 'gain.2', meaning = 'gain' }",
    "c": "{ quantity = 'gain.3', meaning = 'gain' }",
}
SEARCH = "kind = 'steady_state'\nmodel = 'search'\ngain = 'filter'\n"
TWO: dict[str, Any] = {
    "name": "two states",
    "transition": [["1", "1"], ["0", "1"]],
    "process_noise": [["0", "0"], ["0", "1"]],
    "measurement": [["1", "0"]],
    "measurement_noise": [["1"]],
}
FAMILIES = [TWO, *[model(name) for name in list(NOISES)[:4]]]
INCREASING = "about = ['c', 'a']\ntrend = 'increasing'\ntext = 'c rises with a'"
DECREASING = "about = ['c', 'a']\ntrend = 'decreasing'\ntext = 'c falls with a'"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "fields", "wanted", "family"),
    [
        ("identity", r"b^2 = 2 a c", "proved", "acceleration increments"),
        ("identity", r"a (a + b + \frac{c}{2}) = 2 b", "proved", "acceleration increments"),
        ("identity", r"a (a + b + c) = 2 b", "refuted", ""),
        further("identity", r"2 a c - b^2 = \frac{1}{12} c^2", "proved", "jerk constant"),
        further("identity", r"2 a c - b^2 = \frac{1}{11} c^2", "refuted", ""),
        ("identity", r"2 a^2 + 2 a b - 4 b + a c = \frac{1}{18} c^2", "proved", "jerk constant"),
        further(
            "identity", r"2 a^2 + 2 a b - 4 b + a c = \frac{1}{60} c^2", "proved", "white jerk"
        ),
        further("identity", r"2 a^2 + 2 a b - 4 b - a c = \frac{1}{60} c^2", "refuted", ""),
        further("inequality", "c < b < 2 a", "proved", "acceleration increments"),
        ("inequality", "b < c", "refuted", ""),
        ("inequality", "b < a", "conditional", "acceleration increments"),
        further("monotone", INCREASING, "proved", "any of"),
        ("monotone", DECREASING, "refuted", ""),
        further("limit", r"\lim_{a \to 0} \frac{a c}{b^2} = \frac{1}{2}", "proved", "any of"),
        ("limit", r"\lim_{a \to 0} \frac{a c}{b^2} = \frac{1}{3}", "refuted", ""),
    ],
)
def test_family_is_found(kind: str, fields: str, wanted: str, family: str) -> None:
    found = judged(kind, fields, GAINS, SEARCH, FAMILIES)
    check(found, wanted)
    assert family in (found.convention or "")
    assert "two states" not in found.reason


@pytest.mark.parametrize(
    ("latex", "third"),
    [
        (r"2 a c - b^2 = \frac{1}{12} c^2", "process noise jerk constant over each interval"),
        (r"4 a c - b^2 = \frac{1}{3} c^2", "K_3 = 2 c/T^2"),
        further(r"a c - b^2 = \frac{1}{48} c^2", "K_3 = c/(2 T^2)"),
    ],
)
def test_meaning_of_the_third_gain_is_found(latex: str, third: str) -> None:
    found = judged("identity", latex, GAINS, f"{SEARCH}third_gain = 'search'", FAMILIES)
    check(found, "proved")
    assert found.convention is not None
    assert found.convention.startswith("process noise jerk constant over each interval")
    assert third in found.convention
    assert found.domain == "for tracking_index > 0"


def test_two_gains_mean_two_states() -> None:
    two = {token: GAINS[token] for token in "ab"}
    found = judged("identity", "a (a + b) = 2 b", two, SEARCH, FAMILIES)
    assert found.convention == "process noise two states"
    check(judged("inequality", "0 < a < 1", {"a": GAINS["a"]}, SEARCH, FAMILIES), "proved")
    found = judged("identity", "b^2 = 2 a c", GAINS, SEARCH, [TWO])
    assert (found.verdict, found.reason) == ("undecided", "no model with 3 states is known")


OWN = """kind = 'steady_state'
transition = [['1', 'T', '{half}'], ['0', '1', 'T'], ['0', '0', '1']]
process_noise = [{noise}]
measurement = [['1', '0', '0']]
measurement_noise = [['r']]
""".replace("{half}", r"\frac{T^2}{2}")
WHITE = OWN.replace(
    "{noise}",
    r"['\frac{q T^5}{20}', '\frac{q T^4}{8}', '\frac{q T^3}{6}'], "
    r"['\frac{q T^4}{8}', '\frac{q T^3}{3}', '\frac{q T^2}{2}'], "
    r"['\frac{q T^3}{6}', '\frac{q T^2}{2}', 'q T']",
)
OWN_SYMBOLS = {
    "T": "{ quantity = 'sampling_interval', meaning = 'interval' }",
    "q": "{ unit = 'm^2 s^-5', domain = 'q > 0', meaning = 'density' }",
    "r": "{ unit = 'm^2', domain = 'r > 0', meaning = 'variance' }",
    **{t: v.replace("gain.", "filter_gain.") for t, v in GAINS.items()},
}
RISES = "about = ['a', '{}']\ntrend = 'increasing'\ntext = 'a rises'"


OF_OWN_MODEL = [
    ("identity", r"\frac{c^2}{1 - a} = \frac{q T^5}{r}", "proved"),
    ("identity", r"\frac{c^2}{1 - a} = \frac{q T^5}{2 r}", "refuted"),
    ("monotone", RISES.format("q"), "proved"),
    ("monotone", RISES.format("T"), "proved"),
    ("monotone", RISES.format("T").replace("increasing", "decreasing"), "refuted"),
    ("limit", r"\lim_{q \to 0} b = 0", "proved"),
    ("limit", r"\lim_{q \to \infty} a = \frac{9}{10}", "refuted"),
    ("inequality", "a < 1", "proved"),
    ("inequality", r"a < \frac{9}{10}", "conditional"),
]
ONE_OF_A_KIND = [OF_OWN_MODEL[n] for n in (1, 4, 8)]


@pytest.mark.parametrize(
    ("kind", "fields", "wanted"), cases(OF_OWN_MODEL, lambda case: case in ONE_OF_A_KIND)
)
def test_own_model(kind: str, fields: str, wanted: str) -> None:
    check(judged(kind, fields, OWN_SYMBOLS, WHITE), wanted)


@pytest.mark.parametrize(
    ("old", "new", "wanted"),
    [
        (r"\frac{q T^3}{6}']", r"\frac{q T^3}{5}']", "row 1, column 3 and row 3, column 1"),
        (r"\frac{q T^5}{20}", r"\frac{q T^5}{80}", "it is not positive semidefinite"),
        ("'q T']", "'-q T']", "what is negative"),
        ("[['1', '0', '0']]", "[['0', '1', '0']]", "leaves out the first state"),
    ],
)
def test_matrices_that_are_no_model_say_why(old: str, new: str, wanted: str) -> None:
    assert old in WHITE
    said = judged("inequality", "a < 1", OWN_SYMBOLS, WHITE.replace(old, new))
    assert said.verdict == "undecided"
    assert wanted in said.reason


def test_states_may_be_counted_from_the_last() -> None:
    reversed_states = """kind = 'steady_state'
transition = [['1', '0'], ['1', '1']]
process_noise = [['q', '0'], ['0', '0']]
measurement = [['0', '1']]
measurement_noise = [['1']]
"""
    symbols = {
        "q": "{ unit = '1', domain = 'q > 0', meaning = 'variance' }",
        "a": "{ quantity = 'filter_gain.2', meaning = 'gain of the position' }",
        "b": "{ quantity = 'filter_gain.1', meaning = 'gain of the velocity' }",
    }
    check(judged("identity", r"b = \frac{a^2}{2 - a}", symbols, reversed_states), "proved")
    check(judged("identity", r"b = \frac{a^2}{3 - a}", symbols, reversed_states), "refuted")
