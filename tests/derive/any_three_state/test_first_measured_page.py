"""The page of models of a user's own with three states, with a mistake in it."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
import sympy as sp
from own_models import own_model

from gainproof.derive.any_three_state.any_three_state import PAGE, derive_any_three_state
from gainproof.derive.any_two_state import proved_module
from gainproof.derive.derivation import PageError
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.subject import Subject
from gainproof.verify.certificate import check_statement

Q = sp.Rational
FADING = [[1, 1, Q(9, 20)], [0, 1, Q(9, 10)], [0, 0, Q(3, 4)]]
TEXT = (FOLDER / f"{PAGE}.md").read_text(encoding="utf-8")


@pytest.fixture(autouse=True, scope="module")
def without_bounds() -> Iterator[None]:
    """Only what certificates hold is looked at here: bounds of kernels take their time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(proved_module, "prove", lambda _kernel, _form: None)
        yield


def derived(folder: Path = FOLDER) -> Subject:
    return derive_any_three_state(own_model(FADING, sp.diag(Q(1, 10), 0, 1).tolist()), folder)


@cache
def whole() -> Subject:
    return derived()


def status(subject: Subject, step: str) -> str:
    """What the checker says of a step's statement, alone."""
    steps = tuple(each for each in subject.derivation.steps if each.id == step)
    alone = replace(subject, derivation=replace(subject.derivation, steps=steps))
    return check_statement(json.loads(json.dumps(alone.certificate())), step).status


def edited(folder: Path, right: str, wrong: str) -> Subject:
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, folder)
    assert TEXT.count(right) == 1
    (folder / f"{PAGE}.md").write_text(TEXT.replace(right, wrong), encoding="utf-8")
    return derived(folder)


WRONG = [
    ("open-loop", "(1 - s)^3 {open_loop}", "(1 + s)^3 {open_loop}"),
    ("noise-spectrum", "- {n1} s^2", "+ {n1} s^2"),
    ("roots", "+ 2 d3 d1,", "- 2 d3 d1,"),
    ("deviation", "sigma = (d0 + d1 + d2 + d3)/8", "sigma = (d0 + d1 + d2 + d3)/4"),
    ("riccati-gain", "raised_gain = (M11 + 1) K", "raised_gain = (M11 + 2) K"),
    ("hidden-predicted", "X23 + beta gamma sigma^2", "X23 + beta^2 gamma sigma^2"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), WRONG)
def test_what_is_not_true_is_rejected(tmp_path: Path, step: str, right: str, wrong: str) -> None:
    assert status(whole(), step) == "proved"
    assert status(edited(tmp_path, right, wrong), step) == "rejected"


MISTAKES = [
    ("for any s\n    number-n0", "for any n\n    number-n0", 0, "'n' is no quantity"),
    ("    steps forms", "    steps form", 0, "no steps 'form' of the program"),
    ("{subtractions}", "{subtraction}", 1, "'{subtraction}' is no slot of words here"),
    ("(if minors_are_positive)", "(if minors)", 0, "no slot 'minors'"),
]
"""With how many lines above the step begins where it is told."""


@pytest.mark.parametrize(("right", "wrong", "above", "said"), MISTAKES)
def test_a_mistake_is_told_with_its_line(
    tmp_path: Path, right: str, wrong: str, above: int, said: str
) -> None:
    with pytest.raises(PageError) as caught:
        edited(tmp_path, right, wrong)
    line = TEXT[: TEXT.index(right)].count("\n") + 1 - above
    place, _, text = str(caught.value).partition(": ")
    assert place.endswith(f"/{PAGE}.md, line {line}")
    assert said in text
