"""limit and increasing_onto: seen failing."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, statement
from tests.verify.certificate.toy_writer import fraction, graph
from tests.verify.certificate.toy_writer import statement as written

Data = dict[str, Any]

p, s, alpha, beta, sigma, index = sp.symbols("p s alpha beta sigma tracking_index")
SIGMA = (p**2 + 4 + 2 * p * s) / 4
P = [p, s]
HALF_AT_INFINITY: Data = {"weights": {"s": 1}, "constants": [], "boundary": {"s": [["1/2", []]]}}
ROOT_TWO_AT_ZERO: Data = {
    "weights": {"s": 0},
    "constants": [{"symbol": "c", "power": 2, "radicand": [["2", [0]]]}],
    "boundary": {"s": [["1", [1]]]},
}


def _limit(
    certificate: Data, expression: Any, point: str, value: Any, variable: str = "tracking_index"
) -> str:
    evidence = ROOT_TWO_AT_ZERO if point == "0" else HALF_AT_INFINITY
    claim = {
        "expression": graph(expression),
        "variable": variable,
        "point": point,
        "value": value if isinstance(value, str) else graph(value),
    }
    certificate = {
        **certificate,
        "statements": [written("x", "limit", claim, {**evidence, "nonzero": []})],
    }
    return reason(certificate, "x")


@pytest.mark.parametrize(
    ("expression", "point", "value"),
    [
        (beta, "infinity", sp.Integer(2)),
        (alpha, "infinity", sp.Integer(1)),
        (alpha, "0", sp.Integer(0)),
        (alpha / p, "0", sp.sqrt(2)),
        (beta / alpha**2, "0", sp.Rational(1, 2)),
        (1 / sigma, "infinity", sp.Integer(0)),
        (sigma, "infinity", "infinity"),
        (1 / p, "0", "infinity"),
        (p - p, "0", sp.Integer(0)),
        (-beta, "infinity", sp.Integer(-2)),
    ],
)
def test_true_limits(acceleration: Data, expression: Any, point: str, value: Any) -> None:
    assert _limit(acceleration, expression, point, value) == ""


@pytest.mark.parametrize(
    ("expression", "point", "value", "why"),
    [
        (beta, "infinity", sp.Integer(1), "another"),
        (beta, "infinity", sp.Integer(0), "another"),
        (beta, "infinity", "infinity", "finite"),
        (beta, "0", sp.Integer(2), "another"),
        (alpha / p, "0", -sp.sqrt(2), "another"),
        (alpha / p, "0", sp.sqrt(3), "not known"),
        (sigma, "infinity", sp.Integer(1), "infinity"),
        (-sigma, "infinity", "infinity", "not plus infinity"),
        (-1 / p, "0", "infinity", "not plus infinity"),
        (s - p / 2, "infinity", sp.Integer(0), "not determined"),
        (1 - alpha, "infinity", sp.Integer(0), "not determined"),
        (alpha, "minus infinity", sp.Integer(0), "is wanted"),
        (alpha, "infinity", sp.Symbol("alpha"), "depends on 'p'"),
        (alpha, "0", sp.Symbol("c"), "neither a variable"),
    ],
)
def test_false_or_undetermined_limits(
    acceleration: Data,
    expression: Any,
    point: str,
    value: Any,
    why: str,
) -> None:
    assert why in _limit(acceleration, expression, point, value)


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.boundary.s", [["-1", [1]]], "nonnegative"),
        ("evidence.boundary.s", [["1", [0]]], "not a root"),
        ("evidence.boundary.s", [], "not a root"),
        ("evidence.boundary.s", [["2", [1]]], "not a root"),
        ("evidence.boundary", {}, "missing"),
        ("evidence.boundary", {"s": [["1", [1]]], "p": []}, "not known"),
        ("evidence.constants.0.radicand", [["3", [0]]], "not a root"),
        ("evidence.constants.0.radicand", [["-2", [0]]], "not manifestly positive"),
        ("evidence.constants.0.radicand", [["2", [1]]], "earlier"),
        ("evidence.constants.0.power", 3, "not a root"),
        ("evidence.constants.0.symbol", "s", "twice"),
        ("evidence.constants", [], "exponents"),
        ("evidence.weights.s", -1, "negative power"),
        ("evidence.weights.s", 1, "from -64 to 0"),
        ("evidence.weights", {}, "missing"),
        ("evidence.weights.s", True, "bool"),
        ("claim.variable", "sigma", "parameter"),
        ("claim.variable", "s", "neither"),
        ("claim.variable", "nothing", "neither"),
        ("claim.variable", "beta", "generator that depends"),
    ],
)
def test_evidence_at_zero(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "start", path, new)


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.weights.s", 0, "negative power"),
        ("evidence.weights.s", 2, "not a root"),
        ("evidence.weights.s", -1, "from 0"),
        ("evidence.boundary.s", [["-1/2", []]], "nonnegative"),
        ("evidence.boundary.s", [["1/3", []]], "not a root"),
        ("evidence.constants", ROOT_TWO_AT_ZERO["constants"], "exponents"),
    ],
)
def test_evidence_at_infinity(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "end", path, new)


def test_vanishing_boundary_is_undetermined(acceleration: Data) -> None:
    """With weight 2 the rescaled generator tends to 0: a root, but it decides nothing."""
    evidence = statement(acceleration, "end")["evidence"]
    evidence["weights"]["s"], evidence["boundary"]["s"] = 2, []
    assert "not determined" in reason(acceleration, "end")


def test_unused_constant(acceleration: Data) -> None:
    evidence = statement(acceleration, "start")["evidence"]
    evidence["constants"].append({"symbol": "d", "power": 2, "radicand": [["3", [0, 0]]]})
    evidence["constants"][0]["radicand"] = [["2", [0, 0]]]
    evidence["boundary"]["s"] = [["1", [1, 0]]]
    assert "constants d not used" in reason(acceleration, "start")


def test_the_variable_must_run_with_the_parameter(acceleration: Data) -> None:
    elements = acceleration["towers"]["main"]["elements"]
    elements["bounded"] = fraction(p, p**2 + 1, P)
    elements["shifted"] = fraction(p + 1, 1, P)
    elements["reciprocal"] = fraction(1, p, P)
    elements["saturated"] = fraction(3 * p**2, 1 + p**2, P)
    elements["humped"] = fraction(p**2 + 1, p, P)
    assert "only" in _limit(acceleration, alpha, "0", sp.Integer(0), "bounded")
    assert "only" in _limit(acceleration, alpha, "0", sp.Integer(0), "shifted")
    assert "only" in _limit(acceleration, alpha, "0", sp.Integer(0), "reciprocal")
    assert _limit(acceleration, alpha, "0", sp.Integer(0), "saturated") == ""
    for name in ("bounded", "reciprocal", "saturated", "humped"):
        assert "only" in _limit(acceleration, alpha, "infinity", sp.Integer(1), name)
    assert _limit(acceleration, alpha, "infinity", sp.Integer(1), "shifted") == ""


def test_a_parameter_from_one_does_not_reach_zero(memory: Data) -> None:
    statement(memory, "tail")["claim"]["point"] = "0"
    assert "does not reach 0" in reason(memory, "tail")


def test_a_variable_depends_on_one_parameter(memory: Data) -> None:
    memory["towers"]["samples"] = {
        "parameters": [{"symbol": "k", "from": "1"}, {"symbol": "n", "from": "1"}],
        "generators": [],
        "elements": {"m": {"num": [["1", [1, 1]]], "den": [["1", [0, 0]]]}},
    }
    statement(memory, "tail")["claim"] |= {"expression": graph(sp.Symbol("k")), "variable": "m"}
    assert "depends on 2 parameters" in reason(memory, "tail")


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.derivative", fraction(2, SIGMA**2 * p * s, P), "does not equal"),
        ("evidence.derivative", fraction(-1, SIGMA**2 * p * s, P), "not manifestly positive"),
        ("evidence.derivative", fraction(1, SIGMA * p * s, P), "does not equal"),
        ("evidence.start", HALF_AT_INFINITY, "from -64 to 0"),
        ("evidence.end", ROOT_TWO_AT_ZERO, "negative power"),
        ("evidence.end.boundary.s", [["1", []]], "not a root"),
        ("claim.from", graph(sp.Rational(1, 2)), "another"),
        ("claim.to", graph(2), "another"),
        ("claim.to", "infinity", "finite"),
        ("claim.from", "infinity", "finite"),
        ("claim.variable", "p", "does not equal"),
        ("claim.variable", "sigma", "generator"),
        ("claim.expression", graph(-alpha), "does not equal"),
        ("claim.expression", graph(beta), "does not equal"),
    ],
)
def test_increasing(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "monotone", path, new)


def test_a_decreasing_expression(acceleration: Data) -> None:
    """1/p decreases: its derivative is negative, whatever is stated."""
    entry = statement(acceleration, "bijection")
    entry["claim"] |= {"expression": graph(1 / p), "from": "infinity", "to": graph(0)}
    entry["evidence"]["derivative"] = fraction(1, p**2, P)
    assert "does not equal" in reason(acceleration, "bijection")
    entry["evidence"]["derivative"] = fraction(-1, p**2, P)
    assert "not manifestly positive" in reason(acceleration, "bijection")


def test_a_constant_does_not_increase(acceleration: Data) -> None:
    entry = statement(acceleration, "bijection")
    entry["claim"] |= {"expression": graph(1), "from": graph(1), "to": graph(1)}
    entry["evidence"]["derivative"] = fraction(0, 1, P)
    assert "not manifestly positive" in reason(acceleration, "bijection")


def test_a_slope_that_vanishes_inside(memory: Data) -> None:
    """(g - 1)^3 increases, but its derivative shows no plain sign; g^3 from 0 does."""
    g = sp.Symbol("g")
    onto = statement(memory, "onto")
    onto["claim"] |= {"expression": graph((g - 1) ** 3), "from": graph(-1)}
    onto["evidence"]["derivative"] = fraction(3 * (g - 1) ** 2, 1, [g])
    assert "not manifestly positive inside" in reason(memory, "onto")
    onto["claim"] |= {"expression": graph(g**3), "from": graph(0)}
    onto["evidence"]["derivative"] = fraction(3 * g**2, 1, [g])
    assert reason(memory, "onto") == ""


def test_lower_end_other_than_zero(memory: Data) -> None:
    """k from 1: the lower end is k = 1, not 0."""
    k = sp.Symbol("k")
    nothing: Data = {"weights": {}, "constants": [], "boundary": {}}
    for start, accepted in ((1, True), (0, False)):
        memory["statements"] = [
            written(
                "x",
                "increasing_onto",
                {
                    "expression": graph(k**2),
                    "variable": "k",
                    "from": graph(start),
                    "to": "infinity",
                },
                {
                    "derivative": fraction(2 * k, 1, [k]),
                    "start": nothing,
                    "end": nothing,
                    "nonzero": [],
                },
                "samples",
            )
        ]
        assert (reason(memory, "x") == "") == accepted
