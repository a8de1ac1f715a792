"""Two parameters and a vector measurement: what holds is accepted, what does not is not."""

from __future__ import annotations

import random
from copy import deepcopy
from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, refused, statement
from tests.verify.certificate.toy_writer import expectations, fraction, poly
from tests.verify.certificate.two_parameter_toy import (
    ENDS,
    MODEL,
    PLAIN,
    C,
    L,
    M,
    S,
    U,
    certificate,
    tends,
    tower,
)

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.derivation import Step
from gainproof.derive.expression import graph_of, real
from gainproof.derive.relation import Relation, equal, increasing_onto, monotone
from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign

Data = dict[str, Any]

VARIABLES = [sp.Symbol(name) for name in ("tracking_index", "ratio", "c", "y")]


def why(step: Step) -> str:
    """Why a statement is rejected that the writer wrote; empty when it is not."""
    result = check(certificate([step]))
    assert len(result.statements) == 1, result.reason
    return result.statements[0].reason


def test_accepted(walk: Data) -> None:
    report = check(walk, **expectations(walk), model=MODEL)
    assert report.accepted, report.reason
    assert report.count("proved") == len(walk["statements"]) == 16


def test_altered(walk: Data) -> None:
    campaign = Campaign(walk)
    tally = campaign.run(random.Random(5).sample(campaign.alterations(), 700))
    assert tally.accepted == ()
    assert tally.refuted > 200


def test_one_parameter_tends_and_the_other_is_held(walk: Data) -> None:
    """E = U/(L S) tends to 1/sqrt(1 + S^2) for L -> 0 and to 0 for S -> 0: no joint limit."""
    joint = PLAIN / (L * S)
    assert why(tends("x", joint, "tracking_index", "0", 1 / sp.sqrt(1 + S**2))) == ""
    assert why(tends("x", joint, "ratio", "0", sp.Integer(0))) == ""
    assert "another" in why(tends("x", joint, "tracking_index", "0", sp.Integer(0)))
    assert "another" in why(tends("x", joint, "tracking_index", "0", sp.Integer(1)))
    assert "another" in why(tends("x", joint, "ratio", "0", sp.Integer(1)))
    altered = changed(walk, "small_index", "claim.variable", "predicted")
    assert "depends on 2 parameters" in altered


@pytest.mark.parametrize(
    ("identifier", "path", "new", "because"),
    [
        ("small_index", "claim.variable", "ratio", "not a root"),
        ("small_index", "claim.variable", "updated", "depends on 2"),
        ("small_index", "claim.variable", "c", "neither a parameter"),
        ("small_index", "claim.value", graph_of(1 / sp.sqrt(1 + L**2)), "that tends"),
        ("small_index", "claim.value", graph_of(1 / C), ""),
        ("small_index", "claim.value", graph_of(real("constant_c")), "neither a variable"),
        ("small_index", "claim.value", graph_of(real("variance")), "another"),
        ("small_index", "claim.value", "infinity", "finite"),
        ("small_index", "claim.value", graph_of(1 / sp.sqrt(2 + S**2)), "not known"),
        ("small_index", "claim.value", graph_of(sp.Derivative(S, S)), "derivative"),
        ("bad_second", "claim.value", graph_of(real("y")), "that tends"),
        ("bad_second", "claim.value", graph_of(M), "that tends"),
        ("bad_second", "evidence.weights.y", 0, "weight is too small"),
        ("bad_second", "evidence.weights.y", 2, "not a root"),
        ("bad_second", "evidence.boundary.c", [["1", [1, 0]]], "not a root"),
        ("bad_second", "evidence.constants.0.radicand", [["-1", [1, 0]]], "radicand"),
        ("bad_second", "evidence.constants.0.symbol", "ratio", "given twice"),
        ("bad_second", "evidence.constants.0.symbol", "tracking_index", "given twice"),
        ("large_noise", "evidence.form.num", [["1", [0, 0, 0, 0]]], "does not equal"),
        ("large_noise", "claim.value", graph_of(S**2), "another"),
    ],
)
def test_limits(walk: Data, identifier: str, path: str, new: Any, because: str) -> None:
    found = changed(walk, identifier, path, new)
    assert because in found
    assert bool(because) == bool(found)


def test_a_rescaled_generator_is_no_value() -> None:
    """Where c grows with S its value at the boundary is that of c/S: it may not pass for c."""
    end = ENDS["ratio", "infinity"]
    assert "that tends" in why(tends("x", C, "ratio", "infinity", C))
    assert end.weights["c"] == 1


def test_a_form_that_is_not_needed_is_rejected() -> None:
    step = tends("x", PLAIN, "ratio", "0", sp.Integer(0), limit_form=PLAIN)
    assert "not needed" in why(step)


def test_a_limit_for_part_of_the_other_domain() -> None:
    """1/(1 + L k) tends to 0 for L -> infinity unless k = 0, which the closed domain holds."""
    parameters = [{"symbol": "L", "above": "0"}, {"symbol": "k", "from": "0"}]
    claim = {
        "expression": graph_of(1 / (1 + real("L") * real("k"))),
        "variable": "L",
        "point": "infinity",
        "value": graph_of(sp.Integer(0)),
    }
    proof: Data = {"weights": {}, "constants": [], "boundary": {}, "nonzero": []}
    data = {
        "format": "gainproof certificate 1",
        "subject": "part",
        "towers": {"main": {"parameters": parameters, "generators": [], "elements": {}}},
        "programs": {},
        "statements": [
            {"id": "x", "kind": "limit", "tower": "main", "claim": claim, "evidence": proof}
        ],
    }
    assert "not determined" in reason(data, "x")
    parameters[1] = {"symbol": "k", "above": "0"}
    assert reason(data, "x") == ""


def test_a_trend_that_stops_at_an_end_of_the_other_domain() -> None:
    """k L grows with L unless k = 0; (k + 1) L does for every k >= 0."""
    index, k = sp.symbols("L k")
    parameters = [{"symbol": "L", "from": "0"}, {"symbol": "k", "from": "0"}]
    for expression, slope, because in (
        (k * index, k, "not manifestly"),
        ((k + 1) * index, k + 1, ""),
    ):
        claim = {"expression": graph_of(expression), "variable": "L", "trend": "increasing"}
        proof = {"derivative": fraction(slope, 1, [index, k]), "nonzero": []}
        data = {
            "format": "gainproof certificate 1",
            "subject": "trend",
            "towers": {"main": {"parameters": parameters, "generators": [], "elements": {}}},
            "programs": {},
            "statements": [
                {"id": "x", "kind": "monotone", "tower": "main", "claim": claim, "evidence": proof}
            ],
        }
        assert because in reason(data, "x")
        assert bool(because) == bool(reason(data, "x"))


def test_trends_and_derivatives(walk: Data) -> None:
    assert changed(walk, "grows", "claim.trend", "decreasing")
    assert changed(walk, "grows", "claim.variable", "tracking_index")
    assert "depends on 2" in changed(walk, "grows", "claim.variable", "updated")
    assert "is wanted" in changed(walk, "grows", "claim.trend", "constant")
    assert changed(walk, "falls", "claim.trend", "increasing")
    assert changed(walk, "falls", "claim.expression", graph_of(U))


def test_the_derivative_variable_counts() -> None:
    for variable in (L, real("variance")):
        step = Step("x", "", equal(sp.Derivative(U, variable), 2 * L * S / (C**3 * real("y"))), "")
        assert "not shown equal" in why(step)
    step = Step("x", "", equal(sp.Derivative(U, real("product")), L), "")
    assert "depends on 2 parameters" in why(step)
    step = Step("x", "", equal(sp.Derivative(U, real("predicted")), L), "")
    assert "depends on 2 parameters" in why(step)


def test_a_range_holds_for_every_fixed_value() -> None:
    ends = {point: ENDS["tracking_index", point] for point in ("0", "infinity")}
    hint = {"ends": ends, "limit_form": PLAIN, "differentiated": PLAIN}
    for end in (sp.Integer(1), S**2, 1 / (1 + S**2)):
        step = Step("x", "", increasing_onto(U, sp.Integer(0), end), "", hint=hint)
        assert "another" in why(step)


@pytest.mark.parametrize(
    ("path", "new", "because"),
    [
        ("claim.model.measurement_noise.1.1", graph_of(S), "precision"),
        ("claim.model.measurement_noise.1.1", graph_of(S**2 - 1), "not positive"),
        ("claim.model.measurement_noise.1.1", graph_of(-(S**2)), "not positive"),
        ("claim.model.measurement_noise.1.1", graph_of(real("nothing")), "neither"),
        ("claim.model.measurement_noise.1.1", graph_of(L**2), "precision"),
        ("claim.model.measurement_noise", [["1", "1"], ["1", "1"]], "not positive"),
        (
            "claim.model.measurement_noise",
            [["1", graph_of(S)], [graph_of(S), graph_of(S**2)]],
            "not positive",
        ),
        ("claim.model.measurement_noise", [["1", "0"], ["1", graph_of(S**2)]], "not symmetric"),
        ("claim.model.measurement_noise", [["1"]], "shape"),
        ("claim.model.measurement", [["1"]], "shape"),
        ("claim.model.measurement", [["1"], ["2"]], "gain"),
        ("claim.model.process_noise", [["2"]], "combination"),
        ("claim.model.process_noise", [["-1"]], "not a covariance"),
        ("claim.model.process_noise", [[graph_of(S - 1)]], "not a covariance"),
        ("claim.model.process_noise", [[graph_of(S)]], "combination"),
        ("claim.model.transition", [["2"]], "combination"),
        ("claim.model.transition", [[graph_of(1 / S)]], "not a polynomial"),
        ("claim.gain", ["first_gain"], "model of numbers"),
        ("claim.gain", [["first_gain"]], "other sizes"),
        ("claim.gain", [["second_gain", "first_gain"]], "gain 1,1"),
        ("claim.gain", [["first_gain", "first_gain"]], "gain 1,2"),
        ("claim.predicted", [["updated"]], "predicted 1,1"),
        ("claim.updated", [["predicted"]], "updated 1,1"),
        ("claim.index", "ratio", "combination"),
        ("claim.index", "noise", "combination"),
        ("evidence.prediction", {}, "missing"),
        ("evidence.update.1,1", [[], []], "combination"),
        ("evidence.innovation", [], "2 minors"),
        ("evidence.denominator", [["-1", [0, 0, 0, 0]]], "not manifestly positive"),
        ("evidence.precision.denominator", [["1", [0, 0, 0, 0]]], "precision"),
        ("evidence.precision.numerators", [[[["1", [0, 2, 0, 0]]], []]], "rows of 2"),
    ],
)
def test_steady_state(walk: Data, path: str, new: Any, because: str) -> None:
    assert because in changed(walk, "steady", path, new)


def test_another_solution_is_not_definite(walk: Data) -> None:
    """With -w in place of w the equations hold as well; the innovation then shows no sign."""
    assert changed(walk, "steady", "evidence.innovation.1", fraction(-1, 1, VARIABLES))
    assert changed(walk, "steady", "evidence.innovation.0", fraction(1, 1, VARIABLES))


@pytest.mark.parametrize(
    ("path", "new", "because"),
    [
        ("claim.gain", ["first_gain", "second_gain"], "not known here"),
        ("claim.gain", [["first_gain"]], "1 gains wanted"),
        ("claim.gain", [["second_gain", "second_gain"]], "coefficients"),
        ("evidence.coefficients", [], "1 coefficients"),
        ("evidence.coefficients.0", fraction(0, 1, VARIABLES), "has another one"),
        ("evidence.values.0", fraction(1, 1, VARIABLES), "another one"),
        ("claim.model.transition", [["2"]], "coefficients"),
    ],
)
def test_stable(walk: Data, path: str, new: Any, because: str) -> None:
    assert because in changed(walk, "loop", path, new)


def test_asymmetric_covariances() -> None:
    """Two independent walks, measured each: names that are not symmetric are refused."""
    model = {**MODEL, "transition": [["1", "0"], ["0", "1"]]}
    claim = {
        "model": model
        | {"process_noise": [["1", "0"], ["0", "1"]], "measurement": [["1", "0"], ["0", "1"]]},
        "predicted": [["predicted", "noise"], ["updated", "predicted"]],
        "updated": [["updated", "noise"], ["noise", "updated"]],
        "gain": [["noise", "noise"], ["noise", "noise"]],
        "index": "tracking_index",
    }
    step = Step("x", "", Relation("riccati", claim), "")
    data = certificate([tends("x", real("noise"), "ratio", "0", L**2)])
    full = certificate()["towers"]["main"]
    data["towers"]["main"] = full
    data["statements"][0] |= {
        "kind": "riccati",
        "claim": step.relation.claim(),
        "evidence": statement(certificate(), "steady")["evidence"],
    }
    assert "not symmetric" in reason(data, "x")


def test_weakened_domain(walk: Data) -> None:
    expected = expectations(walk)
    for bound in ({"from": "1"}, {"from": "0"}):
        altered = deepcopy(walk)
        altered["towers"]["main"]["parameters"][1] = {"symbol": "ratio", **bound}
        report = check(altered, **expected)
        assert not report.accepted
        assert "domain" in report.reason or "manifestly" in report.reason


def test_certificate_of_another_family(walk: Data) -> None:
    """The same walk shaken four times as much has y^2 = 4 L^2 (1 + S^2) + 4 S^2."""
    other = deepcopy(walk)
    generator = other["towers"]["main"]["generators"][1]
    generator["radicand"] = poly(
        4 * VARIABLES[0] ** 2 * (1 + VARIABLES[1] ** 2) + 4 * VARIABLES[1] ** 2, VARIABLES
    )
    assert refused(other)
    noisy = deepcopy(walk)
    for entry in noisy["statements"]:
        if "model" in entry["claim"]:
            entry["claim"]["model"]["process_noise"] = [["4"]]
    assert refused(noisy).startswith("steady: the residual")


def test_program_inputs_count(walk: Data) -> None:
    inputs = walk["programs"]["predicted"]["inputs"]
    inputs["index"], inputs["deviation"] = inputs["deviation"], inputs["index"]
    assert "root" in reason(walk, "kernel")


def test_an_element_of_two_parameters_has_no_parameter() -> None:
    with pytest.raises(ValueError, match=r"\['ratio', 'tracking_index'\], not on one"):
        tower().parameter_of("product")
    with pytest.raises(ValueError, match="not on one"):
        evidence(Step("x", "", monotone(U, "increasing", "product"), ""), tower())
