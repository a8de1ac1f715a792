"""Two-state models far from any tracker: unstable, alternating, with poles anywhere."""

from __future__ import annotations

import copy
import json
import math
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from one_of_each import cases
from own_models import free_number, own_model

from gainproof.derive.any_two_state import proved_module
from gainproof.derive.any_two_state.any_two_state import derive_any_two_state
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.certificate import check

R, S = real("r"), real("s_squared")
TENTH = sp.Rational(1, 10)
LAST = [[0, 0], [0, 1]]

MODELS: dict[str, Model] = {
    "alternating": own_model([[-8 * TENTH, 6 * TENTH], [0, -1]], [[9, 12], [12, 16]]),
    "unstable": own_model([[11 * TENTH, 1], [0, 9 * TENTH]], LAST),
    "second state leaves": own_model([[7 * TENTH, 4 * TENTH], [-TENTH, -12 * TENTH]], LAST),
    "pulling each other": own_model([[11 * TENTH, 1], [4 * TENTH, TENTH]], [[2, 3], [3, 9]]),
    "second is noise": own_model([[1, 1], [0, 0]], LAST),
    "second is noise with a part of the first": own_model([[1, 1], [0, 0]], [[1, 1], [1, 2]]),
    "second remembers the first": own_model(
        [[3 * sp.Rational(1, 2), 1], [-6 * TENTH, 0]], [[1, 0], [0, TENTH]]
    ),
    "without a trend": own_model([[0, 1], [-sp.Rational(1, 4), 0]], [[0, 0], [0, 1]]),
    # at a small index roots of roots of 1 + r, which no certificate states
    "free strength": own_model(
        [[1, 1], [0, 1]], [[0, 0], [0, 1 + R]], parameters=(free_number("r"),)
    ),
    # and 8 times the root of 2
    "free place": own_model([[1, 1], [0, 1]], [[R / 4, 0], [0, 2]], parameters=(free_number("r"),)),
    "decay and ratio": own_model(
        [[1, 1 - R], [0, R]],
        [[S, 0], [0, 1]],
        parameters=(free_number("r", below_one=True), free_number("s_squared")),
    ),
}


@pytest.fixture(autouse=True, scope="module")
def without_bounds() -> Iterator[None]:
    """Only what certificates hold is looked at here: bounds of kernels take their time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(proved_module, "prove", lambda _kernel, _form: None)
        yield


@cache
def certificate(name: str) -> tuple[Any, dict[str, Any]]:
    derived = plain_subject(derive_any_two_state(MODELS[name]))
    return json.loads(json.dumps(derived.certificate)), expected_of(derived)


LIKE_OTHERS = {
    "second state leaves",
    "pulling each other",
    "second remembers the first",
    "decay and ratio",
    "free strength",
}


@pytest.mark.alike
@pytest.mark.parametrize("name", cases(MODELS, lambda name: name not in LIKE_OTHERS))
def test_everything_is_proved(name: str) -> None:
    report = recheck(*certificate(name))
    assert report["accepted"], report["reason"]
    statuses = {entry["id"]: entry["status"] for entry in report["statements"]}
    assert statuses["riccati"] == statuses["stable"] == statuses["kernel-gains"] == "proved"


def test_each_equation_altered_is_rejected() -> None:
    """One more on the right side of every equation; each must fail."""
    found, _ = certificate("unstable")
    altered = copy.deepcopy(found)
    wanted = []
    for statement in altered["statements"]:
        if statement["kind"] != "equal":
            continue
        graph = statement["claim"]["right"]
        value = graph["outputs"]["value"]
        if graph["nodes"][value][0] == "matrix":
            value = graph["nodes"][value][3]
        last = len(graph["nodes"])
        graph["nodes"] += [["number", "1"], ["add", value, last]]
        top = graph["outputs"]["value"]
        if top == value:
            graph["outputs"]["value"] = last + 1
        else:
            graph["nodes"].append([*graph["nodes"][top][:3], last + 1, *graph["nodes"][top][4:]])
            graph["outputs"]["value"] = last + 2
            graph["nodes"][top] = ["neg", value]
            graph["nodes"][last + 1][1] = top
        wanted.append(statement["id"])
    assert len(wanted) > 15
    statuses = {entry.id: entry.status for entry in check(altered).statements}
    assert {statuses[name] for name in wanted} == {"rejected"}


def test_a_certificate_of_another_model_is_refused() -> None:
    mine, _ = certificate("unstable")
    _, other = certificate("alternating")
    assert not recheck(mine, other)["accepted"]


def test_a_noise_with_a_free_ratio_has_a_free_ratio_in_its_limits() -> None:
    found, _ = certificate("decay and ratio")
    claims = {entry["id"]: entry["claim"] for entry in found["statements"]}
    text = json.dumps(claims["large-innovation-deviation"]["value"])
    assert "s_squared" in text


@pytest.mark.alike
@pytest.mark.parametrize("name", [name for name in MODELS if not MODELS[name].parameters])
def test_the_lines_of_docstrings_are_true(name: str) -> None:
    """Read as they stand, at index 1, against the Riccati equation iterated; and reduced."""
    subject = derive_any_two_state(MODELS[name])
    lines = " ".join(subject.module.kernels[0].equations)
    assert "(0)" not in lines
    assert "(1) " not in lines
    assert subject.model is not None
    F = np.array(subject.model.transition, float)
    Q = np.array(subject.model.process_noise, float)
    P = np.eye(2)
    for _ in range(4000):
        gain = P[:, :1] / (P[0, 0] + 1)
        P = F @ (P - gain @ P[:1]) @ F.T + Q
    alpha, beta = P[0, 0] / (P[0, 0] + 1), P[1, 0] / (P[0, 0] + 1)
    at = {"alpha": alpha, "beta": beta, "q": 1.0, "sigma": math.sqrt(P[0, 0] + 1)}
    at |= {each: value(text, {}) for each, text in re.findall(r"([fn]\d) = ([^,;]+)[,;]", lines)}
    at["d0"] = math.sqrt(at["f0"] ** 2 + at["n0"])
    at["d2"] = math.sqrt(at["f2"] ** 2 + at["n1"])
    rest = at["n0"] + at["n1"] + 2 * at["d0"] * at["d2"]
    at["d1"] = math.sqrt(at["f1"] ** 2 - 2 * at["f0"] * at["f2"] + rest)
    for each, text in re.findall(r"(W) = ([^;]+);", lines):
        at[each] = value(text, at)
    (both,) = re.findall(r"([^,;]*beta[^=,;]*=[^,;]*)[,;]", lines.partition("predicted_11")[0])
    left, right = (value(side, at) for side in both.split("="))
    assert left == pytest.approx(right, rel=1e-9, abs=1e-12), both


def value(text: str, at: dict[str, float]) -> float:
    """A docstring's formula as a number: a space between factors is a product."""
    return float(eval(re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text.strip()), {}, at))  # noqa: S307


def test_a_sum_is_written_as_one_reads_it() -> None:
    terms = [(0, "a"), (1, "b"), (-1, "c"), (2, "q"), (R + 1, "s"), (-TENTH, "t"), (-TENTH, "")]
    assert proved_module.linear(*terms) == "b - c + 2 q + (r + 1) s - (1/10) t - 1/10"
    assert proved_module.linear((-1, "c"), (0, "")) == "-c"
    assert proved_module.linear((0, "c")) == "0"
