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
from gainproof.derive.three_state.excess import Surds, positive_terms
from gainproof.derive.three_state.names import XI
from gainproof.derive.three_state.spectrum import Spectrum
from gainproof.verify.certificate import check_statement

JERK = "continuous-white-jerk"
FAMILIES = ("acceleration-increments", "wiener-acceleration", "random-jerk", JERK)
ONE_OF_EACH = ("acceleration-increments", "random-jerk")  # by the towers of their kernels
NOISES = ((1, 0), (Fraction(2, 3), Fraction(1, 9)), (1, Fraction(2, 15)))


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


@pytest.mark.parametrize("numbers", NOISES)
def test_positive_terms_add_up_with_few_powers_of_the_difference(
    numbers: tuple[Fraction, Fraction],
) -> None:
    m1, m2 = (Fraction(number) for number in numbers)
    empty = sp.Integer(0)
    spectrum = Spectrum(empty, empty, m1, m2)
    surds = Surds(spectrum)
    least = surds.least.as_expr()
    polynomial = 7 * (XI - least) ** 3 + 2 * XI * (XI - least) + XI**3
    terms = positive_terms(spectrum, polynomial)
    total = sum(value * (XI - least) ** i * XI**j for (i, j), value in terms.items())
    by_power = sp.Poly(sp.expand(total - polynomial), XI).all_coeffs()
    assert all(surds.of(value) == 0 for value in by_power)
    assert all(surds.size(surds.of(value)) > 0 for value in terms.values())
    assert min(i for i, _ in terms) == 0
    with pytest.raises(ArithmeticError, match="without subtraction"):
        positive_terms(spectrum, XI - 2 * least)


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
