"""A page that somebody has edited: what is said changes, and what is not true is not proved."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.subject import Subject
from gainproof.derive.updated_gains.subject import NAME, build
from gainproof.verify.certificate import check_statement

TEXT = (FOLDER / f"{NAME}.md").read_text(encoding="utf-8")
DOCUMENT = (FOLDER.resolve().parents[1] / "docs" / "edit-a-page.md").read_text(encoding="utf-8")
(ADDED,) = re.findall(r"```text\n(### sum.*?)```", DOCUMENT, re.DOTALL)


def edited(folder: Path, right: str, wrong: str) -> Subject:
    """The subject of the page with one place changed."""
    assert TEXT.count(right) == 1
    (folder / f"{NAME}.md").write_text(TEXT.replace(right, wrong), encoding="utf-8")
    return build(folder)


def status(subject: Subject, step: str) -> str:
    """What the checker says of a step's statement."""
    found: dict[str, Any] = json.loads(json.dumps(subject.certificate()))
    return check_statement(found, step).status


def test_a_sentence_is_the_teachers(tmp_path: Path) -> None:
    subject = edited(tmp_path, "Both gains bend down at every index;", "Neither gain is convex:")
    (step,) = (step for step in subject.derivation.steps if step.id == "second")
    assert step.sentence == "Neither gain is convex: neither ever bends up."
    assert status(subject, "second") == "proved"


def test_the_documentation_adds_a_step_that_is_proved(tmp_path: Path) -> None:
    subject = edited(tmp_path, "### second\n", f"{ADDED}\n### second\n")
    assert [step.id for step in subject.derivation.steps if step.essential] == ["sum"]
    assert (status(subject, "sum"), status(subject, "sum-grows")) == ("proved", "proved")


def test_the_documentation_shows_the_error_of_a_misprint(tmp_path: Path) -> None:
    misprint = ADDED.replace("    alpha + beta =", "    alpha + bta =")
    with pytest.raises(PageError) as caught:
        edited(tmp_path, "### second\n", f"{misprint}\n### second\n")
    place, _, said = str(caught.value).partition(", ")
    assert place.endswith(f"/{NAME}.md")
    assert f"gainproof: derive/pages/{NAME}.md, {said}" in DOCUMENT


WRONG = [
    ("direction", "beta_0' = 2 n alpha_0'\n", "beta_0' = 3 n alpha_0'\n"),
    ("margin", "4 - 2 alpha - beta = 4/(1 + e)\n", "4 - 2 alpha + beta = 4/(1 + e)\n"),
    ("alpha-bound-small", "Lambda_alpha/Lambda_0 -> 9 as", "Lambda_alpha/Lambda_0 -> 8 as"),
    ("held-updated", "    held-updated: Y = rest(alpha_0,", "    held-updated: Y = rest(alpha,"),
    ("kernel-first-order-gains", "    beta = b\n", "    beta = 2 b\n"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), WRONG)
def test_a_formula_that_is_not_true_is_rejected(
    tmp_path: Path, step: str, right: str, wrong: str
) -> None:
    assert status(edited(tmp_path, right, wrong), step) == "rejected"


NOT_FOUND = [
    ("within-stable", "gain [a, b] is stable", "gain [b, a] is stable"),
    ("limits-fall", "    1 + (1 + 2/n)/2 falls with", "    1 + (1 + 2/n)/2 grows with"),
    ("never-below", "    E_alpha has the sign of (", "    -E_alpha has the sign of ("),
    ("alpha-place-beyond", ": e_alpha > n\n", ": n > e_alpha\n"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), NOT_FOUND)
def test_a_sign_that_is_not_there_is_not_found(
    tmp_path: Path, step: str, right: str, wrong: str
) -> None:
    with pytest.raises(PageError, match=f"step {step}: nothing shows that this is so"):
        edited(tmp_path, right, wrong).certificate()


def test_a_name_with_another_meaning_is_seen(tmp_path: Path) -> None:
    """The meaning of a quantity changes for the statements too: what was true is true no more."""
    subject = edited(tmp_path, "    R_i = sigma_i^2\n", "    R_i = 2 sigma_i^2\n")
    assert status(subject, "axis-index") == "rejected"
    assert status(subject, "axis-index-root") == "proved"
