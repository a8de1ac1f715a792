"""riccati, stable, positive_definite: seen failing."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, refused, statement
from tests.verify.certificate.toy_writer import fraction

Data = dict[str, Any]

p, s = sp.symbols("p s")
SIGMA = (p**2 + 4 + 2 * p * s) / 4
P = [p, s]


@pytest.mark.parametrize(
    ("field", "new"),
    [
        ("process_noise", [["0", "0"], ["0", "1"]]),
        ("process_noise", [["1/3", "1/2"], ["1/2", "1"]]),
        ("process_noise", [["1/4", "1/2"], ["1/3", "1"]]),
        ("process_noise", [["1/4", "-1/2"], ["-1/2", "1"]]),
        ("transition", [["1", "0"], ["1", "1"]]),
        ("transition", [["1", "1"], ["0", "2"]]),
        ("measurement", [["0", "1"]]),
        ("measurement", [["1", "0"], ["0", "1"]]),
        ("measurement", [["2", "0"]]),
        ("measurement_noise", [["2"]]),
        ("measurement_noise", [["0"]]),
        ("measurement_noise", [["-1"]]),
        ("measurement_noise", [["1.0"]]),
        ("transition", [["1"]]),
        ("transition", []),
        ("transition", [[]]),
        ("transition", [["1", "1"], ["0"]]),
    ],
)
def test_another_model(acceleration: Data, field: str, new: Any) -> None:
    assert changed(acceleration, "steady_state", f"claim.model.{field}", new)
    if field in ("transition", "measurement"):
        assert changed(acceleration, "loop", f"claim.model.{field}", new)


def test_every_cofactor_counts(acceleration: Data) -> None:
    cofactors = statement(acceleration, "steady_state")["evidence"]["cofactors"]
    for key, polynomials in cofactors.items():
        for number in range(len(polynomials[0])):
            path = f"evidence.cofactors.{key}.0.{number}.0"
            assert "combination" in changed(acceleration, "steady_state", path, "7/3")


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.cofactors.1,1", [], "polynomials wanted"),
        ("evidence.cofactors.1,1.0", [], "combination"),
        ("evidence.cofactors.2,2", [[], []], "polynomials wanted"),
        ("evidence.cofactors", {}, "missing"),
        ("evidence.denominator", [], "not manifestly positive"),
        ("evidence.denominator", [["-1", [0, 0]]], "not manifestly positive"),
        ("evidence.denominator", [["2", [0, 0]]], "named element"),
        ("evidence.denominator", [["1", [1, 0]], ["-1", [0, 0]]], "not manifestly positive"),
        ("evidence.numerators.0.1", [], "not symmetric"),
        ("evidence.numerators.0", [], "rows of 2"),
        ("evidence.numerators", [], "rows of 2"),
        ("evidence.numerators.0.0", [["-3", [0, 0]]], "variance"),
        ("claim.gain", ["beta", "alpha"], "gain 1"),
        ("claim.gain", ["alpha"], "other sizes"),
        ("claim.gain", ["alpha", "alpha"], "gain 2"),
        ("claim.gain", ["alpha", "nothing"], "neither"),
        ("claim.gain", [], "names are wanted"),
        ("claim.updated", [["alpha", "beta"], ["beta", "m22"]], "updated 2,2"),
        ("claim.predicted", [["m11", "m12"], ["m12", "x22"]], "predicted 2,2"),
        ("claim.predicted", [["m11", "m12"], ["m11", "m22"]], "not symmetric"),
        ("claim.predicted", [["m11", "m12"]], "square"),
        ("claim.predicted", [], "square"),
        ("claim.index", "p", "combination"),
        ("claim.index", "alpha", "combination"),
        ("claim.index", "sigma", "combination"),
    ],
)
def test_riccati(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "steady_state", path, new)


def test_consistent_lie_about_the_covariance(acceleration: Data) -> None:
    """Element and numerators changed together: still no solution."""
    elements = acceleration["towers"]["main"]["elements"]
    numerators = statement(acceleration, "steady_state")["evidence"]["numerators"]
    for polynomial in (elements["m22"]["num"], numerators[1][1]):
        polynomial.append(["1", [0, 0]])
    elements["x22"] = fraction(4 * p**3 + 2 * s + p, 2 * s + p, P)
    assert "combination" in reason(acceleration, "steady_state")


def test_another_solution_of_the_equation_is_not_positive(acceleration: Data) -> None:
    """With -s in place of s the equation holds as well; the variance then shows no sign."""
    certificate = deepcopy(acceleration)

    def mirrored(polynomial: list[Any]) -> None:
        for term in polynomial:
            if term[1][1] % 2:
                term[0] = term[0][1:] if term[0].startswith("-") else "-" + term[0]

    entry = statement(certificate, "steady_state")
    elements = certificate["towers"]["main"]["elements"]
    for name in ("m11", "m12", "m22"):
        mirrored(elements[name]["num"])
    for row in entry["evidence"]["numerators"]:
        for polynomial in row:
            mirrored(polynomial)
    for polynomials in entry["evidence"]["cofactors"].values():
        mirrored(polynomials[0])
    assert "variance is not manifestly positive" in reason(certificate, "steady_state")


def test_index_of_both_statements_counts(acceleration: Data) -> None:
    acceleration["towers"]["main"]["elements"]["tracking_index"] = fraction(2 * p**2, 1, P)
    assert "combination" in reason(acceleration, "steady_state")


def test_generator_changed(acceleration: Data) -> None:
    acceleration["towers"]["main"]["generators"][0]["radicand"][1][0] = "9/4"
    assert reason(acceleration, "steady_state")


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.values.0", fraction(p, SIGMA, P), "another"),
        ("evidence.values.1", fraction(SIGMA**2 - 1, SIGMA**2, P), "another"),
        ("evidence.values.2", fraction(4 * p * s, SIGMA, P), "another"),
        ("evidence.values.3", fraction(-(p**3) * s, SIGMA**2, P), "positive"),
        ("evidence.values.3", fraction(p**3 * s, p - 1, P), "positive"),
        ("evidence.values", [], "4 values"),
        ("claim.gain", ["m11", "m12"], "another"),
        ("claim.gain", ["alpha"], "2 gains"),
    ],
)
def test_stable(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "loop", path, new)


def test_stable_wants_every_value_in_order(acceleration: Data) -> None:
    values = statement(acceleration, "loop")["evidence"]["values"]
    assert "4 values" in changed(acceleration, "loop", "evidence.values", values[:-1])
    assert "another" in changed(acceleration, "loop", "evidence.values", values[::-1])


def test_unstable_loop(acceleration: Data) -> None:
    """No gain at all leaves both eigenvalues at 1: 1 - a_0 = 0 is not positive."""
    elements = acceleration["towers"]["main"]["elements"]
    elements["zero"] = fraction(0, 1, P)
    entry = statement(acceleration, "loop")
    entry["claim"]["gain"] = ["zero", "zero"]
    entry["evidence"]["values"] = [
        fraction(0, 1, P),
        fraction(2, 1, P),
        fraction(0, 1, P),
        fraction(0, 1, P),
    ]
    assert "not manifestly positive" in reason(acceleration, "loop")


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("evidence.minors.0", fraction(p * s, 1, P), "another"),
        ("evidence.minors.1", fraction(-(p**4) * SIGMA, 1, P), "positive"),
        ("evidence.minors", [], "2 minors"),
        ("claim.matrix", [["alpha", "beta"], ["beta", "m22"]], "another"),
        ("claim.matrix", [["m11", "m12"], ["m11", "m22"]], "not symmetric"),
        ("claim.matrix", [["m11"]], "1 minors"),
        ("claim.matrix", [["m11", "m12"], ["m12"]], "square"),
    ],
)
def test_definite(acceleration: Data, path: str, new: Any, why: str) -> None:
    assert why in changed(acceleration, "definite", path, new)


def test_semidefinite_is_not_definite(acceleration: Data) -> None:
    entry = statement(acceleration, "definite")
    entry["claim"]["matrix"] = [["m11", "m11"], ["m11", "m11"]]
    entry["evidence"]["minors"][1] = fraction(0, 1, P)
    assert "not manifestly positive" in reason(acceleration, "definite")


def test_one_model_throughout(acceleration: Data) -> None:
    """Stability does not depend on the noise, so only the other statement's model tells."""
    model = deepcopy(statement(acceleration, "loop")["claim"]["model"])
    model["measurement_noise"] = [["2"]]
    statement(acceleration, "loop")["claim"]["model"] = model
    assert reason(acceleration, "loop") == ""
    assert "another model" in refused(acceleration)


def test_whole_certificate_with_another_noise(acceleration: Data) -> None:
    for identifier in ("steady_state", "loop"):
        model = statement(acceleration, identifier)["claim"]["model"]
        model["process_noise"] = [["0", "0"], ["0", "1"]]
    assert refused(acceleration).startswith("steady_state: the residual")
