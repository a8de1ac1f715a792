"""The derivation of gains that follow the index: all proved, and altered it is refused."""

from __future__ import annotations

import copy
import json
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp
from catalogue_subjects import certificate
from numpy.typing import NDArray
from one_of_each import cases

from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, same_sign
from gainproof.generated import random_acceleration
from gainproof.verify.certificate import check, check_statement

Plain = dict[str, Any]
Reals = NDArray[np.float64]


@pytest.fixture(scope="module")
def original() -> Plain:
    found: Plain = json.loads(json.dumps(certificate("updated-gains")))
    return found


def test_as_derived_everything_is_decided(original: Plain) -> None:
    report = check(original)
    assert report.accepted
    found = [result.status for result in report.statements]
    assert found.count("proved") >= 120
    assert found.count("cited") == 1


def scaled(data: Plain, tower: str, name: str, factor: int) -> None:
    """An element of a tower multiplied by a number."""
    fraction = data["towers"][tower]["elements"][name]
    for term in fraction["num"]:
        term[0] = str(Fraction(term[0]) * factor)


WRONG = [
    ("main", "alpha", {"riccati", "gains"}),
    ("main", "alpha_slope", {"nominal-slopes", "first-order"}),
    ("main", "first_order_beta", {"first-order", "excess"}),
    ("main", "alpha_excess", {"excess", "excess-value"}),
    ("main", "backward_beta_excess", {"backward", "halves"}),
    ("main", "held_updated_11", {"held-updated", "held-updated-value"}),
    ("main", "nominal_variance", {"variance", "convex"}),
    ("within", "followed_updated_22", {"followed-updated"}),
    ("within", "first_order_alpha", {"within-first-order"}),
    ("bounds", "variance_ratio", {"variance-bound", "variance-bound-ratio"}),
    ("bounds", "alpha_bound", {"bound-indices", "alpha-bound-small"}),
    ("axis", "axis_index", {"axis-index", "axis-index-root"}),
    ("circle", "cosine", {"circle", "sight-decoupled", "sight-loop", "mixture"}),
    ("circle", "later_sine", {"later-circle", "sight-turning"}),
    ("main", "following_variance", {"between", "between-variances"}),
    ("main", "index_ratio", {"held-predicted", "held-predicted-value"}),
    ("within", "index_ratio", {"followed-ratio"}),
    ("sight", "cosine", {"sight-signs"}),
]


ONE_OF_EACH_TOWER = list({case[0]: case for case in WRONG}.values())


@pytest.mark.parametrize(("tower", "name", "refused"), cases(WRONG, ONE_OF_EACH_TOWER.__contains__))
def test_a_wrong_quantity_is_refused(
    original: Plain, tower: str, name: str, refused: set[str]
) -> None:
    data = copy.deepcopy(original)
    scaled(data, tower, name, 3)
    assert {check_statement(data, each).status for each in refused} == {"rejected"}


E, N = real("e"), real("n")
INDEX, NOMINAL = real("tracking_index"), real("nominal_index")
ALPHA, BETA, ALPHA_EXCESS = real("alpha"), real("beta"), real("alpha_excess")
FIRST_ALPHA, FIRST_BETA = real("first_order_alpha"), real("first_order_beta")
FALSE: dict[str, Relation] = {
    "never-below": same_sign(ALPHA_EXCESS, INDEX - NOMINAL),
    "never-below-beta": same_sign(-sp.Symbol("beta_excess", real=True), (INDEX - NOMINAL) ** 2),
    "beyond-one": same_sign(FIRST_ALPHA - 1, INDEX - NOMINAL - N * (2 + N)),
    "unstable": same_sign(
        4 - 2 * FIRST_ALPHA - FIRST_BETA, N * (2 + N) / (1 + N) - (INDEX - NOMINAL)
    ),
    "rising-alpha": same_sign(ALPHA - ALPHA_EXCESS, (INDEX - NOMINAL) * (N + E - E**2)),
    "second": equal(sp.Derivative(ALPHA, (INDEX, 2)), sp.Derivative(BETA, (INDEX, 2))),
    "cycle-grows": same_sign(sp.Symbol("alpha_slope", real=True), NOMINAL - INDEX),
    "between": same_sign(
        sp.Symbol("alpha", real=True), sp.Symbol("nominal_variance", real=True) - 1
    ),
    "followed-updated-11": same_sign(
        sp.Symbol("held_updated_11", real=True) - sp.Symbol("followed_updated_11", real=True),
        (INDEX - NOMINAL) ** 2,
    ),
}
"""Statements that are not true, in place of those proved; the last: updating always helps."""


@pytest.mark.parametrize("name", FALSE)
def test_a_false_statement_is_refused(original: Plain, name: str) -> None:
    data = copy.deepcopy(original)
    (entry,) = (each for each in data["statements"] if each["id"] == name)
    entry.update(kind=FALSE[name].kind, claim=json.loads(json.dumps(FALSE[name].claim())))
    assert check_statement(original, name).status == "proved"
    assert check_statement(data, name).status == "rejected"


def turned(angle: float, state: int = 1) -> Reals:
    """D, or D for the state."""
    c, s = math.cos(angle), math.sin(angle)
    return np.asarray(np.kron([[c, -s], [s, c]], np.eye(state)), np.float64)


@pytest.mark.parametrize("angle", [0.0, 0.4, math.pi / 2, -2.0, 3.0])
def test_a_turned_filter_has_the_poles_of_both(angle: float) -> None:
    """In numbers: the loop of the turned gain, at angles of both signs."""
    along, across = (np.array(random_acceleration.gains(index)) for index in (0.2, 1.5))
    own = np.zeros((4, 2))
    own[:2, 0], own[2:, 1] = along, across
    gain = turned(angle, 2) @ own @ turned(angle).T
    move = np.kron(np.eye(2), [[1.0, 1.0], [0.0, 1.0]])
    seen = np.kron(np.eye(2), [[1.0, 0.0]])
    poles = np.linalg.eigvals((np.eye(4) - gain @ seen) @ move)
    alone = [
        np.linalg.eigvals((np.eye(2) - np.outer(g, [1, 0])) @ [[1, 1], [0, 1]])
        for g in (along, across)
    ]
    wanted = np.concatenate(alone)
    assert all(np.abs(wanted - pole).min() < 1e-7 for pole in poles)
    decoupled = bool(abs(gain[0, 1]) < 1e-12)
    assert decoupled is (abs(math.sin(2 * angle)) < 1e-9)


def test_an_axis_between_is_slower_than_the_mixture() -> None:
    """Step @mixture in numbers: variances mixed, and gains of the mixture below the mixture."""
    generator = np.random.default_rng(3)
    first, second = 10 ** generator.uniform(-2, 2, (2, 500))
    share = generator.uniform(0.01, 0.99, 500)
    mixed = share * first + (1 - share) * second
    axis = random_acceleration.gains(1 / np.sqrt(mixed))
    ends = [random_acceleration.gains(1 / np.sqrt(each)) for each in (first, second)]
    for own, one, other in zip(axis, *ends, strict=True):
        assert np.all(own <= (share * one + (1 - share) * other) * (1 + 1e-12))
