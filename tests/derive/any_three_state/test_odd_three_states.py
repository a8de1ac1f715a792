"""Three-state models far from any tracker: rotating, leaving, full of noise, with free numbers."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest
import sympy as sp
from one_of_each import cases
from own_models import free_number, own_model

from gainproof.derive.any_three_state.any_three_state import derive_any_three_state
from gainproof.derive.any_two_state import proved_module
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.certificate import check

R = real("r")
Q = sp.Rational
FULL = [[Q(1, 20), Q(1, 8), Q(1, 6)], [Q(1, 8), Q(1, 3), Q(1, 2)], [Q(1, 6), Q(1, 2), 1]]
LAST = [[0, 0, 0], [0, 0, 0], [0, 0, 1]]
SQUARE = [Q(1, 4), Q(1, 2), 1]

MODELS: dict[str, Model] = {
    "position noise too": own_model(
        [[1, 1, Q(9, 20)], [0, 1, Q(9, 10)], [0, 0, Q(3, 4)]], sp.diag(Q(1, 10), 0, 1).tolist()
    ),
    "full noise": own_model([[1, 1, Q(9, 20)], [0, 1, Q(9, 10)], [0, 0, Q(3, 4)]], FULL),
    # the only one whose coefficients g0, ..., g3 are all positive
    "forgetting": own_model([[Q(1, 2), 1, 0], [0, Q(1, 2), 1], [0, 0, Q(1, 2)]], LAST),
    "leaving": own_model([[Q(11, 10), 1, 0], [0, Q(1, 2), 1], [0, 0, Q(1, 4)]], LAST),
    "kinematic with a free ratio": own_model(
        [[1, 1, Q(1, 2)], [0, 1, 1], [0, 0, 1]],
        sp.diag(0, R, 1).tolist(),
        parameters=(free_number("r"),),
    ),
    "kinematic, noise by one vector": own_model(
        [[1, 1, Q(1, 2)], [0, 1, 1], [0, 0, 1]], [[a * b for b in SQUARE] for a in SQUARE]
    ),
    "all states remember all": own_model(
        [[Q(1, 2), 1, Q(1, 3)], [Q(1, 5), Q(1, 4), 2], [0, Q(1, 7), Q(1, 4)]],
        [[3, 1, 0], [1, 2, Q(1, 2)], [0, Q(1, 2), 1]],
    ),
}


LIKE_OTHERS = {"full noise", "all states remember all", "leaving", "position noise too"}


@pytest.fixture(autouse=True, scope="module")
def without_bounds() -> Iterator[None]:
    """Only what certificates hold is looked at here: bounds of kernels take their time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(proved_module, "prove", lambda _kernel, _form: None)
        yield


@cache
def certificate(name: str) -> tuple[Any, dict[str, Any]]:
    derived = plain_subject(derive_any_three_state(MODELS[name]))
    return json.loads(json.dumps(derived.certificate)), expected_of(derived)


@pytest.mark.parametrize("name", cases(MODELS, lambda name: name not in LIKE_OTHERS))
def test_everything_is_proved(name: str) -> None:
    report = recheck(*certificate(name))
    assert report["accepted"], report["reason"]
    statuses = {entry["id"]: entry["status"] for entry in report["statements"]}
    wanted = ("riccati", "stable", "hurwitz", "derivative-gamma", "kernel-gain-derivatives")
    assert {statuses[identifier] for identifier in wanted} == {"proved"}


def test_each_equation_altered_is_rejected() -> None:
    """Twice the right side of every equation; each must fail."""
    found, _ = certificate("position noise too")
    altered = copy.deepcopy(found)
    wanted = []
    for statement in altered["statements"]:
        if statement["kind"] != "equal":
            continue
        graph = statement["claim"]["right"]
        last = len(graph["nodes"])
        graph["nodes"] += [["number", "2"], ["mul", last, graph["outputs"]["value"]]]
        graph["outputs"]["value"] = last + 1
        wanted.append(statement["id"])
    assert len(wanted) > 20
    statuses = {entry.id: entry.status for entry in check(altered).statements}
    assert {statuses[name] for name in wanted} == {"rejected"}


def test_another_spectrum_in_the_tower_is_rejected() -> None:
    """A free term or a coupling altered: the steady state is then another model's."""
    found, _ = certificate("position noise too")
    for field in ("free", "slopes"):
        for place in (0, 1):
            altered = copy.deepcopy(found)
            pair = next(g for g in altered["towers"]["main"]["generators"] if "coupled" in g)
            pair[field][place][0][0] = "7/3"
            statuses = {entry.id: entry.status for entry in check(altered).statements}
            assert statuses["factorisation"] == "rejected"
            proof = [statuses[name] for name in statuses if name.startswith("riccati")]
            assert "rejected" in proof


def test_a_certificate_of_another_model_is_refused() -> None:
    mine, _ = certificate("kinematic, noise by one vector")
    _, other = certificate("position noise too")
    assert not recheck(mine, other)["accepted"]
