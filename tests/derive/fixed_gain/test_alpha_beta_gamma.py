"""Alpha-beta-gamma filters: the page's towers, the region against eigenvalues, false statements."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from catalogue_subjects import certificate, derived
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.verify.certificate import check
from gainproof.verify.oracles.fixed_gain import root_moduli

NAME = "alpha-beta-gamma"


def test_every_step_is_of_a_tower_and_every_tower_is_spoken_of() -> None:
    found = derived(NAME)
    assert {step.tower for step in found.steps} == set(found.certificate["towers"])
    assert [kernel["name"] for kernel in found.kernels] == list(found.programs)


@settings(max_examples=samples(80), deadline=None)
@given(st.floats(-0.5, 2.5), st.floats(-1, 5), st.floats(-1, 8))
def test_the_region_is_that_of_eigenvalues(alpha: float, beta: float, gamma: float) -> None:
    largest = root_moduli([alpha, beta, gamma])[0]
    conditions = (alpha, beta, 4 - 2 * alpha - beta, gamma, alpha * beta - gamma * (1 - alpha / 2))
    if abs(min(conditions)) > 1e-6:
        assert (largest < 1) == (min(conditions) > 0)


@settings(max_examples=samples(40), deadline=None)
@given(st.floats(0.01, 1.99), st.floats(0.01, 0.99), st.floats(0.01, 1.2))
def test_its_inner_border_too(alpha: float, part: float, share: float) -> None:
    """Where the last inequality decides: gamma as a share of what it admits."""
    beta = part * (4 - 2 * alpha)
    gamma = share * alpha * beta / (1 - alpha / 2)
    if abs(share - 1) > 1e-6:
        assert (root_moduli([alpha, beta, gamma])[0] < 1) == (share < 1)


@pytest.mark.parametrize(
    ("step", "old", "new"),
    cases(
        [
            ("stable", "gamma", "beta"),
            ("entries", "predicted_12", "predicted_22"),
            ("implicit", "alpha", "beta"),
            ("order-at-equal-lag", "bound_variance", "bound_lag"),
            ("implicit-second", "alpha", "gamma"),
            ("minimum-variance-value", "predicted_11", "alpha"),
        ],
        lambda case: case[0] in ("stable", "order-at-equal-lag"),
    ),
)
def test_a_false_statement_with_the_same_evidence_is_refused(step: str, old: str, new: str) -> None:
    data = json.loads(json.dumps(certificate(NAME)))
    (place,) = (n for n, entry in enumerate(data["statements"]) if entry["id"] == step)
    claim = data["statements"][place]["claim"]
    text = json.dumps(claim).replace(f'"{old}"', f'"{new}"')
    assert text != json.dumps(claim)
    data["statements"][place]["claim"] = json.loads(text)
    found = {result.id: result.status for result in check(data).statements}
    assert found[step] == "rejected"
    assert sum(status == "rejected" for status in found.values()) == 1


def test_another_filters_gains_fail_by_this_evidence() -> None:
    data = json.loads(json.dumps(certificate(NAME)))
    gamma = data["towers"]["main"]["elements"]["gamma"]
    gamma["num"] = [[str(2 * Fraction(number)), powers] for number, powers in gamma["num"]]
    rejected = {r.id for r in check(data).statements if r.status == "rejected"}
    assert {"stable", "coordinates", "lyapunov", "kernel-variances"} <= rejected
