"""Alpha-beta filters: the page's towers, the region against eigenvalues, graphs without minus."""

from __future__ import annotations

import copy
import json
from fractions import Fraction
from typing import Any

import pytest
from catalogue_subjects import certificate, derived
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.derive.families.fixed_gain_alpha_beta import graphs
from gainproof.verify.certificate import check
from gainproof.verify.oracles.fixed_gain import root_moduli

NAME = "alpha-beta"
DIFFERENCES = {
    "coordinates": 2,
    "variances": 2,
    "lags": 1,
    "closed_loop_poles": 1,
    "variances_of_coordinates": 1,
    "minimum_variance_by_lag": 1,
    "random_acceleration_by_lag": 2,
    "minimum_variance_by_gain": 2,
    "minimum_smoothed_variance_by_lag": 1,
    "minimum_smoothed_variance_by_gain": 1,
    "random_acceleration_by_gain": 1,
    "random_velocity_by_gain": 3,
}
"""Exact differences of a number and an input; those of computed values have names."""


def test_every_step_is_of_a_tower_and_every_tower_is_spoken_of() -> None:
    found = derived(NAME)
    assert {step.tower for step in found.steps} == set(found.certificate["towers"])
    assert [kernel["name"] for kernel in found.kernels] == list(found.programs)


@settings(max_examples=samples(60), deadline=None)
@given(st.floats(-0.5, 2.5), st.floats(-1, 5))
def test_the_region_is_that_of_eigenvalues(alpha: float, beta: float) -> None:
    largest = root_moduli([alpha, beta])[0]
    margin = min(alpha, beta, 4 - 2 * alpha - beta)
    if abs(margin) > 1e-6:
        assert (largest < 1) == (margin > 0)


def test_only_named_differences_are_of_computed_values() -> None:
    """Every other minus sign stands before a number or an input, or one of them doubled."""
    for name, graph in graphs().items():
        nodes, names = graph["nodes"], set(graph.get("names", {}).values())
        plain = 0
        for number, node in enumerate(nodes):
            if node[0] != "add" or number in names:
                continue
            parts = [nodes[int(part)] for part in node[1:]]
            negated = [part for part in parts if part[0] == "neg" or _negative(part)]
            if negated:
                assert all(_exact(nodes, part) for part in parts), (name, node)
                plain += 1
        assert plain == DIFFERENCES.get(name, plain), name


def _negative(node: Any) -> bool:
    return node[0] == "number" and str(node[1]).startswith("-")


def _exact(nodes: Any, node: Any) -> bool:
    """A number, an input, an input times a power of 2, or a constant made of roots."""
    if node[0] in ("number", "symbol"):
        return True
    parts = [nodes[int(part)] for part in node[1:] if isinstance(part, int)]
    if node[0] == "mul":
        numbers = [part for part in parts if part[0] == "number"]
        powers = all(
            Fraction(str(x[1])).numerator & (Fraction(str(x[1])).numerator - 1) == 0
            for x in numbers
        )
        return powers and len(numbers) == len(parts) - 1 and all(_exact(nodes, x) for x in parts)
    return node[0] in ("neg", "add", "pow") and all(_exact(nodes, part) for part in parts)


@pytest.mark.alike
@pytest.mark.parametrize(
    ("step", "old", "new"),
    [
        ("stable", "alpha", "beta"),
        ("entries", "predicted_12", "predicted_22"),
        ("order-at-equal-lag", "velocity_variance", "minimum_variance"),
        ("random-velocity-stable", "root_two", "x"),
        ("held-bound", "updated_11", "predicted_11"),
        ("fitting-smoothed-worse", "updated_11", "beta"),
    ],
)
def test_a_false_statement_with_the_same_evidence_is_refused(step: str, old: str, new: str) -> None:
    data = json.loads(json.dumps(certificate(NAME)))
    (place,) = (n for n, entry in enumerate(data["statements"]) if entry["id"] == step)
    changed = copy.deepcopy(data)
    text = json.dumps(changed["statements"][place]["claim"]).replace(f'"{old}"', f'"{new}"')
    assert text != json.dumps(changed["statements"][place]["claim"])
    changed["statements"][place]["claim"] = json.loads(text)
    found = {result.id: result.status for result in check(changed).statements}
    assert found[step] == "rejected"
    assert sum(status == "rejected" for status in found.values()) == 1


def test_another_filters_gains_are_not_stable_by_this_evidence() -> None:
    """The tower's beta doubled: every statement about it falls, the stability first."""
    data = json.loads(json.dumps(certificate(NAME)))
    beta = data["towers"]["main"]["elements"]["beta"]
    beta["num"] = [[str(2 * Fraction(number)), powers] for number, powers in beta["num"]]
    report = check(data)
    rejected = {result.id for result in report.statements if result.status == "rejected"}
    assert {"stable", "coordinates", "lyapunov", "kernel-variances"} <= rejected
