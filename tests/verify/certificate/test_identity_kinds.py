"""equal, positive, same_sign, definition, cited: seen failing."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, statement
from tests.verify.certificate.toy_writer import fraction, graph
from tests.verify.certificate.toy_writer import statement as written

from gainproof.verify.certificate import check

Data = dict[str, Any]

p, s, alpha, sigma, f = sp.symbols("p s alpha sigma f")
SIGMA = (p**2 + 4 + 2 * p * s) / 4
P = [p, s]


def _added(certificate: Data, kind: str, claim: Data, evidence: Data) -> str:
    """Why a further statement is rejected."""
    certificate = {**certificate, "statements": [written("extra", kind, claim, evidence)]}
    return reason(certificate, "extra")


def _equal(certificate: Data, left: Any, right: Any, free: Any = (), nonzero: Any = ()) -> str:
    return _added(
        certificate,
        "equal",
        {"left": graph(left), "right": graph(right), "free": list(free)},
        {"nonzero": list(nonzero)},
    )


def test_false_identity(acceleration: Data) -> None:
    beta = sp.Symbol("beta")
    assert "not shown equal" in _equal(acceleration, 4 * alpha**2 + 4 * alpha * beta, 8 * beta)


@pytest.mark.parametrize("numerator", [0, 2, -1])
def test_listed_fraction_must_equal_the_divisor(acceleration: Data, numerator: int) -> None:
    reply = changed(
        acceleration, "quotient", "evidence.nonzero.0", fraction(numerator, SIGMA**2, P)
    )
    assert "positive" in reply or "not shown to be nonzero" in reply


def test_listed_fraction_must_be_needed(acceleration: Data) -> None:
    listed = fraction(p, 1, P)
    assert "not needed" in _equal(acceleration, p / p, 1, nonzero=[listed])
    statement(acceleration, "quotient")["evidence"]["nonzero"] *= 2
    assert "entry 1 is not needed" in reason(acceleration, "quotient")


def test_divisor_without_evidence(acceleration: Data) -> None:
    assert "not shown to be nonzero" in changed(acceleration, "quotient", "evidence.nonzero", [])


def test_negative_of_a_divisor_is_enough(acceleration: Data) -> None:
    listed = fraction(1, SIGMA**2, P)
    assert _equal(acceleration, 1 / (alpha - 1), -(sigma**2), nonzero=[listed]) == ""


@pytest.mark.parametrize("divisor", [p - 1, p - p, s**2 - (p**2 + 8) / 4, 2 * s - 3 * p, f - f])
def test_divisor_that_vanishes(acceleration: Data, divisor: Any) -> None:
    nodes = graph(divisor)["nodes"]
    last = len(nodes) - 1
    left = {"nodes": [*nodes, ["div", last, last]], "outputs": {"value": last + 1}}
    claim = {"left": left, "right": graph(1), "free": []}
    assert "nonzero" in _added(acceleration, "equal", claim, {"nonzero": []})


def test_hidden_zero_times_pole(acceleration: Data) -> None:
    """0 * 1/(s^2 - radicand) = 1 or anything: the divisor is zero in the tower."""
    assert "nonzero" in _equal(acceleration, 1 / (s**2 - p**2 / 4 - 2), 1 / p)


def test_free_symbol_clashes(acceleration: Data) -> None:
    for name in ("alpha", "p", "s"):
        symbol = sp.Symbol(name)
        assert "already has a meaning" in _equal(acceleration, symbol, symbol, [name])
    assert "already has a meaning" in _equal(acceleration, f, f, ["f", "f"])


def test_free_symbol_must_be_declared_and_used(acceleration: Data) -> None:
    assert "neither" in _equal(acceleration, f, f)
    assert "not used" in _equal(acceleration, p, p, ["f"])


def test_free_divisor_must_not_vanish_for_some_parameter(acceleration: Data) -> None:
    """f (p - 1) is the zero polynomial in f where p = 1."""
    assert "nonzero" in _equal(acceleration, 1 / (f * (p - 1)), 1 / (f * p - f), ["f"])


def test_free_divisor(acceleration: Data) -> None:
    assert _equal(acceleration, (f**2 - p**2) / (f - p), f + p, ["f"]) == ""


def test_free_symbols_have_no_sign(acceleration: Data) -> None:
    listed = {"num": [["1", [0, 0, 1]]], "den": [["1", [0, 0, 0]]]}
    assert "not manifestly positive" in _equal(acceleration, f, f, ["f"], [listed])


def test_root_of_a_free_square_is_not_known(acceleration: Data) -> None:
    assert "not known" in _equal(
        acceleration,
        sp.Pow(sp.Pow(f, 2, evaluate=False), sp.Rational(1, 2), evaluate=False),
        f,
        ["f"],
    )


def test_root_of_a_square_may_be_negative(memory: Data) -> None:
    """sqrt(k^2) = k is wrong where k may be negative."""
    k = sp.Symbol("k")
    claim = {
        "left": {
            "nodes": [["symbol", "k"], ["pow", 0, "2"], ["pow", 1, "1/2"]],
            "outputs": {"value": 2},
        },
        "right": graph(k),
        "free": [],
    }
    memory["statements"] = [written("x", "equal", claim, {"nonzero": []}, "samples")]
    assert reason(memory, "x") == ""
    memory["towers"]["samples"] = {
        "parameters": [{"symbol": "k", "from": "-1"}],
        "generators": [],
        "elements": {},
    }
    assert "not known" in reason(memory, "x")


def test_matrix_shapes(acceleration: Data) -> None:
    row, column = sp.Matrix([[p, p]]), sp.Matrix([[p], [p]])
    assert "compared" in _equal(acceleration, row, column)
    assert "compared with a number" in _equal(acceleration, row, p)


def test_matrix_entry(acceleration: Data) -> None:
    assert "entry 2" in _equal(acceleration, sp.Matrix([[p, p]]), sp.Matrix([[p, s]]))


@pytest.mark.parametrize(
    "value",
    [
        fraction(2, SIGMA**2, P),
        fraction(1, SIGMA, P),
        fraction(-1, SIGMA**2, P),
        fraction(4 - 2 * p * s + p**2, 4 * SIGMA, P),
        fraction(0, 1, P),
        fraction(1, p - 1, P),
        fraction(1, 0, P),
    ],
)
def test_positive_evidence(acceleration: Data, value: Data) -> None:
    assert changed(acceleration, "updated", "evidence.value", value)


def test_positive_claim(acceleration: Data) -> None:
    for expression in (alpha - 1, 2 - alpha, p - 1, sp.Integer(0)):
        assert changed(acceleration, "updated", "claim.expression", graph(expression))


def test_positive_only_on_a_smaller_domain(memory: Data) -> None:
    """k - 1/2 is positive from k = 1 on, and not from k = 0 on; 2k - 2 vanishes at k = 1."""
    k = sp.Symbol("k")
    for expression, above in ((k - sp.Rational(1, 2), True), (2 * k - 2, False)):
        memory["statements"] = [
            written(
                "x",
                "positive",
                {"expression": graph(expression)},
                {"value": fraction(expression, 1, [k]), "nonzero": []},
                "samples",
            )
        ]
        assert (reason(memory, "x") == "") == above
    memory["statements"] = [
        written(
            "x",
            "positive",
            {"expression": graph(k - sp.Rational(1, 2))},
            {"value": fraction(k - sp.Rational(1, 2), 1, [k]), "nonzero": []},
            "samples",
        )
    ]
    memory["towers"]["samples"]["parameters"][0]["from"] = "0"
    assert "not manifestly positive" in reason(memory, "x")


def test_same_sign(acceleration: Data) -> None:
    for factor in (fraction(p, SIGMA, P), fraction(-p * s, SIGMA, P), fraction(0, 1, P)):
        assert changed(acceleration, "sign", "evidence.factor", factor)
    assert changed(acceleration, "sign", "claim.right", graph(1 - p))
    assert changed(acceleration, "sign", "claim.right", graph(p - 2))
    zero = {"nodes": [["symbol", "p"], ["neg", 0], ["add", 0, 1]], "outputs": {"value": 2}}
    statement(acceleration, "sign")["claim"] = {"left": zero, "right": zero}
    assert "vanish everywhere" in reason(acceleration, "sign")


def test_definition_pins_the_tower(acceleration: Data) -> None:
    assert changed(acceleration, "root", "claim.right", graph(sp.sqrt((p**2 + 9) / 4)))
    assert changed(acceleration, "sigma", "claim.right", graph(sigma + 1))
    assert changed(acceleration, "index", "claim.right", graph(sp.Symbol("tracking_index")))
    acceleration["towers"]["main"]["generators"][0]["radicand"][1][0] = "9/4"
    assert reason(acceleration, "root")


def test_definition_of_something_outside(acceleration: Data) -> None:
    claim = {"left": graph(sp.Symbol("T")), "right": graph(sp.Symbol("unknown"))}
    assert _added(acceleration, "definition", claim, {}) == ""


def test_evidence_where_none_belongs(acceleration: Data) -> None:
    for identifier in ("unique", "units", "sigma"):
        assert "not known here" in changed(acceleration, identifier, "evidence", {"nonzero": []})


@pytest.mark.parametrize("new", ["", "   ", "a\x1b[31mb", 3, ["text"], None, True])
def test_text_of_a_citation(acceleration: Data, new: Any) -> None:
    statement(acceleration, "unique")["claim"]["theorem"] = new
    assert reason(acceleration, "unique")


def test_citation_and_definition_prove_nothing(acceleration: Data) -> None:
    acceleration["statements"] = [statement(acceleration, i) for i in ("unique", "units")]
    assert check(acceleration).reason == "nothing is proved"
