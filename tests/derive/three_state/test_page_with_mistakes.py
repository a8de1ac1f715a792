"""The page that the families of three kinematic states share, with a mistake in it."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
import sympy as sp
from own_models import own_model

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import PAGE, derive_three_state
from gainproof.verify.certificate import check_statement

TEXT = (FOLDER / f"{PAGE}.md").read_text(encoding="utf-8")
MOTION = [[1, 1, sp.Rational(1, 2)], [0, 1, 1], [0, 0, 1]]
SHAPES = {
    "rational": (sp.Rational(1, 2), sp.Integer(1), sp.Integer(1)),
    "rooted": (sp.Rational(1, 6), sp.Rational(1, 2), sp.Integer(1)),
}
"""What one number shakes position, velocity and acceleration by."""


def derived(noise: str, folder: Path = FOLDER) -> Subject:
    shape = SHAPES[noise]
    return derive_three_state(
        own_model(MOTION, [[a * b for a in shape] for b in shape]), (), folder=folder
    )


@cache
def whole(noise: str) -> Subject:
    return derived(noise)


def status(subject: Subject, step: str) -> str:
    """What the checker says of a step's statement, alone."""
    steps = tuple(each for each in subject.derivation.steps if each.id == step)
    alone = replace(subject, derivation=replace(subject.derivation, steps=steps))
    return check_statement(json.loads(json.dumps(alone.certificate())), step).status


def edited(noise: str, folder: Path, right: str, wrong: str) -> Subject:
    assert TEXT.count(right) == 1
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, folder)
    (folder / f"{PAGE}.md").write_text(TEXT.replace(right, wrong), encoding="utf-8")
    return derived(noise, folder)


WRONG = [
    ("rooted", "closed-loop", "(-beta - gamma) (1 - z)", "(-beta + gamma) (1 - z)"),
    ("rooted", "line-spectrum", "(1 + m1 u + m2 u^2)", "(1 + m1 u + m2 u^3)"),
    ("rooted", "index-of-xi", "{index_to_a_power} = {index", "{index_to_a_power} = 2 {index"),
    ("rooted", "predicted-33", "{Q33} - {Q23})", "{Q33} + {Q23})"),
    ("rooted", "derivative-beta", "beta_slope = 4 (", "beta_slope = 5 ("),
    ("rooted", "second-derivative-updated-22", "- 2 bend_of_eta)/8", "- 3 bend_of_eta)/8"),
    ("rooted", "large-beta", "beta -> {end_of_beta} as", "beta -> {end_of_gamma} as"),
    ("rooted", "small-second-updated-33", "X_33, Lambda, 2) Lambda/alpha^2 -> 5/9", None),
    ("rooted", "factor-a", "a^2 = m1 + 2 g - G", "a^2 = m1 + 2 g + G"),
    ("rational", "index-in-w", "(w (1 + w))", "(1 + w)"),
    ("rational", "poles-in-w", "z^2 - 2 mean z + w", "z^2 + 2 mean z + w"),
    ("rational", "modulus-of-pair", "rho^2 = w", "rho = w"),
    ("rooted", "increasing-updated-23", "X_23 grows with Lambda", "X_23 falls with Lambda"),
    ("rooted", "concave-beta", "    concave-beta: -d", "    concave-beta: d"),
    ("rational", "discriminant", "the sign of Lambda^2 - {", "the sign of {"),
]


@pytest.mark.parametrize(("noise", "step", "right", "wrong"), WRONG)
def test_what_is_not_true_is_rejected(
    tmp_path: Path, noise: str, step: str, right: str, wrong: str | None
) -> None:
    assert status(whole(noise), step) == "proved"
    subject = edited(noise, tmp_path, right, wrong or right.replace("5/9", "4/9"))
    assert status(subject, step) == "rejected"


MISTAKES = [
    ("rational", "{noise_in_place}]", "{noise_in_plaice}]", 0, "no slot 'noise_in_plaice'"),
    ("rational", "(if nested)", "(if nestled)", 0, "no slot 'nestled'"),
    ("rooted", "equation-eta: ", "equation-xi: ", 0, "there is a step 'equation-xi' already"),
    ("rooted", "M_33 = Lambda^2 (", "M_33 = Lamda^2 (", 0, "'Lambda' is one"),
    ("rooted", "alpha^3/Lambda -> 8 as {run", "alpha^3/Lambda -> 8 as {ran", 0, "no slot 'ran"),
    ("rooted", "### factors-of-d (in poles,", "### factors-of-d (in main,", 3, "'a' has no value"),
    ("rooted", "d(s) = 1 + xi s + eta s^2 + delta s^3\n", "d(s) = 1 + q s\n", 0, "'q' is neither"),
]


@pytest.mark.parametrize(("noise", "right", "wrong", "beneath", "said"), MISTAKES)
def test_a_mistake_is_told_with_its_line(
    tmp_path: Path, noise: str, right: str, wrong: str, beneath: int, said: str
) -> None:
    with pytest.raises(PageError) as caught:
        edited(noise, tmp_path, right, wrong)
    line = TEXT[: TEXT.index(right)].count("\n") + 1 + beneath
    place, _, text = str(caught.value).partition(": ")
    assert place.endswith(f"/{PAGE}.md, line {line}")
    assert said in text
