"""Second derivatives: what is printed of them, and that altered forms are noticed."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import product

import pytest
import sympy as sp
from catalogue_subjects import certificate, derived, subject
from kernel_truth import truth_at
from one_of_each import cases

from gainproof.derive.expression import real
from gainproof.verify.certificate import check_statement

JERK = "continuous-white-jerk"
FAMILIES = ("acceleration-increments", "wiener-acceleration", "random-jerk", JERK)
ONE_OF_EACH = ("acceleration-increments", "random-jerk")  # by the towers of their kernels


@pytest.mark.parametrize("name", cases(FAMILIES, lambda name: name in ONE_OF_EACH))
def test_an_altered_kernel_is_rejected(name: str) -> None:
    data = json.loads(json.dumps(certificate(name)))
    for kernel in ("gain_second_derivatives", "updated_covariance_derivatives"):
        entry = f"kernel-{kernel.replace('_', '-')}"
        assert check_statement(data, entry).status == "proved"
        nodes = data["programs"][kernel]["graph"]["nodes"]
        last = max(n for n, node in enumerate(nodes) if node[0] == "number" and node[1] != "1")
        nodes[last][1] = "17/16"
        assert check_statement(data, entry).status == "rejected"


def test_an_altered_claim_of_a_sign_is_rejected() -> None:
    data = json.loads(json.dumps(certificate("random-jerk")))
    (entry,) = (x for x in data["statements"] if x["id"] == "second-derivative-updated-33")
    node = next(n for n in entry["claim"]["right"]["nodes"] if n[0] == "number")
    node[1] = "5/7"
    assert check_statement(data, entry["id"]).status == "rejected"


def test_a_root_in_a_root_has_the_same_kernels() -> None:
    one, other = (
        {kernel["name"] for kernel in derived(name).kernels}
        for name in ("continuous-white-jerk", "random-jerk")
    )
    assert one == other
    assert "updated_covariance_second_derivatives" in one


@pytest.mark.parametrize(
    ("name", "word"),
    cases(
        product(ONE_OF_EACH, ("small", "large")),
        lambda case: case in zip(ONE_OF_EACH, ("small", "large"), strict=True),
    ),
)
def test_another_limit_of_a_second_derivative_is_rejected(name: str, word: str) -> None:
    data = json.loads(json.dumps(certificate(name)))
    found = [x for x in data["statements"] if x["id"].startswith(f"{word}-second-")]
    assert len(found) == 12
    for entry in found[::5]:
        assert check_statement(data, entry["id"]).status == "proved"
        number = next(node for node in entry["claim"]["value"]["nodes"] if node[0] == "number")
        number[1] = str(Fraction(number[1]) * Fraction(10, 9))
        assert check_statement(data, entry["id"]).status == "rejected"


def test_small_indices_bend_as_is_said() -> None:
    """The limits against the true values at one small index."""
    index = sp.Float("1e-24")
    truth = truth_at("continuous_white_jerk", "tracking_index", float(index))
    known = {real(name): sp.Float(truth[name].value) for name in ("alpha",)}
    steps = [step for step in subject(JERK).derivation.steps if "small-second" in step.id]
    assert len(steps) == 12
    for step in steps:
        (bend,) = (expression := step.relation.parts["expression"]).atoms(sp.Derivative)
        true = sp.Float(truth[f"dd_{bend.expr}"].value)
        share = expression.subs(bend, true).subs({**known, real("tracking_index"): index})
        number = float(step.relation.parts["value"])
        assert float(share) == pytest.approx(number, rel=1e-6), step.id
