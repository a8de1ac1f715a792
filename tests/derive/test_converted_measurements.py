"""The derivation of converted measurements, altered: what is false is refused."""

from __future__ import annotations

import copy
import json
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp
from catalogue_subjects import certificate, subject
from one_of_each import cases

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import PageError, Step
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, limit, monotone, positive, same_sign
from gainproof.derive.sensors.converted_measurements import graphs
from gainproof.derive.subject import Subject
from gainproof.verify.certificate import check, check_statement

Plain = dict[str, Any]
NAME = "converted-measurements"
R, SIGMA_R, SIGMA_A, KEPT = map(
    real, ("slant_range", "range_deviation", "azimuth_deviation", "kept_azimuth")
)
COS2, SIN2, COS_E, SIN_E, KEPT_E = map(
    real, ("cosine_square", "sine_square", "cos_elevation", "sin_elevation", "kept_elevation")
)
L, LE, BOTH = KEPT**2, KEPT_E**2, KEPT * KEPT_E
WHOLE = R**2 + SIGMA_R**2
RADIAL, CROSS = real("spread_radial"), real("spread_cross")
STATED = {
    name: (real(f"{name}_radial"), real(f"{name}_cross"))
    for name in ("classical", "debiased", "unbiased", "average")
}
MODIFIED, UNBIASED = (
    [real(f"space_{name}_{entry}") for entry in ("ahead", "across", "up", "tilt")]
    for name in ("modified", "unbiased")
)
ESTIMATE = R**2 / L - (R**2 - SIGMA_R**2) * (1 + L**2) / (2 * L**2)
"""Whose mean given the truth is the unbiased conversion's variance along the line of sight."""
TOGETHER, BESIDE = real("noise_covariance"), real("correlated_beside")
ENDS = {"0": End(), "infinity": End()}


@pytest.fixture(scope="module")
def original() -> Plain:
    found: Plain = json.loads(json.dumps(certificate(NAME)))
    return found


def test_as_derived_everything_is_decided(original: Plain) -> None:
    report = check(original)
    assert report.accepted
    found = [result.status for result in report.statements]
    assert found.count("proved") >= 105
    assert set(found) == {"proved", "cited", "definition"}
    assert found.count("cited") == 4


KERNELS = sorted(name for name in graphs() if not name.startswith("correlated_"))


@pytest.mark.parametrize("step", [29, pytest.param(1, marks=pytest.mark.thorough)])
@pytest.mark.parametrize("name", cases(KERNELS, KERNELS[::2].__contains__))
def test_an_altered_node_of_a_kernel_is_noticed(name: str, step: int, original: Plain) -> None:
    """Each sum turned into a product, each product into a sum, quotients turned round, signs
    dropped: one at a time.
    """
    statement = f"kernel-{name.replace('_', '-')}"
    assert check_statement(original, statement).status == "proved"
    nodes = original["programs"][name]["graph"]["nodes"]
    for at, node in list(enumerate(nodes))[len(name) % step :: step]:
        changed = list(node)
        if node[0] in ("add", "mul"):
            changed[0] = "mul" if node[0] == "add" else "add"
        elif node[0] == "neg":
            changed = ["add", node[1], node[1]]
        elif node[0] == "div":
            changed[1:] = reversed(node[1:])
        else:
            continue
        program = copy.deepcopy(original["programs"][name])
        program["graph"]["nodes"][at] = changed
        data = {**original, "programs": {**original["programs"], name: program}}
        assert check_statement(data, statement).status == "rejected", (name, at, node)


def status(relation: Relation, hint: Plain | None = None, tower: str = "main") -> str:
    """What becomes of one more statement in a tower; a sign that is not shown is none."""
    made: Subject = subject(NAME)
    step = Step("claimed", "", relation, "", tower, hint or {})
    alone = replace(
        made, derivation=replace(made.derivation, steps=(step,)), programs={}, settings={}
    )
    try:
        data = json.loads(json.dumps(alone.certificate()))
    except PageError:  # which names the step
        return "rejected"
    (result,) = check(data, claims=alone.claims()).statements
    return result.status


def test_a_true_statement_passes() -> None:
    assert status(equal(RADIAL, WHOLE * COS2 - (KEPT * R) ** 2)) == "proved"
    assert status(positive(STATED["average"][0])) == "proved"
    crossing = R**2 * (1 - L) - SIGMA_R**2 * L
    assert status(same_sign(CROSS - RADIAL, crossing), {"form": L}) == "proved"
    assert status(monotone(RADIAL, "increasing", "slant_range")) == "proved"


FALSE = {
    "printed with lambda^2 for lambda^4": equal(RADIAL, WHOLE * (1 + KEPT**2) / 2 - KEPT**2 * R**2),
    "without the noise of the range": equal(RADIAL, R**2 * (1 + KEPT**4) / 2 - KEPT**2 * R**2),
    "lambda once": equal(RADIAL, WHOLE * COS2 - KEPT * R**2),
    "unbiased states its covariance given the measurement": equal(STATED["unbiased"][0], RADIAL),
    "unbiased states its covariance given the truth": equal(STATED["unbiased"][0], RADIAL / L),
    "the other sign of 2": equal(
        STATED["unbiased"][0], (1 / L + 2) * R**2 + WHOLE * (1 + L**2) / 2
    ),
    "both transcriptions are one": equal(STATED["unbiased"][0], STATED["average"][0]),
    "debiased is unbiased given the truth": equal(real("factor_debiased") * KEPT, sp.Integer(1)),
    "debiased is unbiased given the measurement": equal(real("factor_debiased"), KEPT),
    "classical across is exact": equal(CROSS, R**2 * SIGMA_A**2),
    "(13a) with cosh of twice the noise once": equal(
        STATED["debiased"][0],
        L**2
        * (
            R**2 * ((L**2 + L**-2) / 2 - (L + 1 / L) / 2)
            + SIGMA_R**2 * ((L**2 + L**-2) / 2 - (L + 1 / L) / 2)
        ),
    ),
    "cosine and sine of the noise exchanged": equal(RADIAL, WHOLE * SIN2 - (KEPT * R) ** 2),
    "the estimate is always a variance": positive(ESTIMATE),
    "classical is too large": positive(STATED["classical"][0] - RADIAL),
    "across is always larger": positive(CROSS - RADIAL),
    "the modified place is beyond the measured": positive(KEPT - 1),
    "less with the range": monotone(RADIAL, "decreasing", "slant_range"),
    "less noise with more noise": monotone(CROSS, "increasing", "kept_azimuth"),
    "the classical along grows": monotone(STATED["classical"][0], "increasing", "slant_range"),
    "they cross at the classical range": same_sign(CROSS - RADIAL, R**2 * SIGMA_A**2 - SIGMA_R**2),
    "they cross without the noise": same_sign(CROSS - RADIAL, R - SIGMA_R),
}


FAR = limit(CROSS / RADIAL, "infinity", (1 + L) / (1 + L), "slant_range")
ELSEWHERE = {
    "a limit of 1": ("main", FAR, {"ends": ENDS}),
    "the height is less certain": ("signs", positive(MODIFIED[2] - MODIFIED[0]), {}),
    "upwards the bias of both angles": (
        "space",
        equal(UNBIASED[2], MODIFIED[2] + (1 / BOTH - BOTH) ** 2 * (R * SIN_E) ** 2),
        {},
    ),
    "the tilt's other sign": (
        "space",
        equal(MODIFIED[3], KEPT * COS_E * SIN_E * (LE * R**2 - LE**2 * WHOLE)),
        {},
    ),
    "the azimuth's noise tilts twice": (
        "space",
        equal(MODIFIED[3], L * COS_E * SIN_E * (LE**2 * WHOLE - LE * R**2)),
        {},
    ),
    "identities have no noise to speak of": ("space", positive(1 - LE), {}),
    "across nothing is off": ("correlated", equal(BESIDE, sp.Integer(0)), {}),
    "it is off to the other side": (
        "correlated",
        equal(BESIDE, -KEPT * TOGETHER),
        {},
    ),
    "correlation leaves the variance along": (
        "correlated",
        equal(real("correlated_radial"), (R**2 * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2),
        {},
    ),
    "correlated with the elevation it is ahead": (
        "space_correlated",
        equal(real("both_ahead"), BOTH * (R * COS_E + real("elevation_covariance") * SIN_E)),
        {},
    ),
}


@pytest.mark.parametrize("name", ELSEWHERE)
def test_a_false_statement_is_refused_in_other_towers(name: str) -> None:
    tower, relation, hint = ELSEWHERE[name]
    assert status(relation, hint, tower) == "rejected"


def test_a_true_statement_passes_in_other_towers() -> None:
    true = limit(CROSS / RADIAL, "infinity", (1 + L) / (1 - L), "slant_range")
    assert status(true, {"ends": ENDS}) == "proved"
    tilt = KEPT * COS_E * SIN_E * (LE**2 * WHOLE - LE * R**2)
    assert status(equal(MODIFIED[3], tilt), tower="space") == "proved"
    assert status(equal(BESIDE, KEPT * TOGETHER), tower="correlated") == "proved"


@pytest.mark.parametrize("name", FALSE)
def test_a_false_statement_is_refused(name: str) -> None:
    assert status(FALSE[name]) == "rejected"
