"""The page that the families of position and velocity share, with a mistake in it."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
import sympy as sp
from own_models import own_model

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.steady_state.two_state import PAGE, derive_two_state
from gainproof.derive.subject import Subject
from gainproof.verify.certificate import check_statement

NOISES = {
    "eta is 4": (Fraction(1, 4), Fraction(1, 2)),
    "poles turn real": (Fraction(1, 8), Fraction(1, 4)),
    "poles never real": (Fraction(1, 3), Fraction(1, 3)),
}
"""Q11 and Q12 where Q22 is 1."""


def derived(noise: str, folder: Path = FOLDER) -> Subject:
    first, cross = (sp.Rational(str(number)) for number in NOISES[noise])
    return derive_two_state(own_model([[1, 1], [0, 1]], [[first, cross], [cross, 1]]), (), folder)


@cache
def whole(noise: str) -> Subject:
    return derived(noise)


def status(subject: Subject, step: str) -> str:
    """What the checker says of a step's statement, alone."""
    steps = tuple(each for each in subject.derivation.steps if each.id == step)
    alone = replace(subject, derivation=replace(subject.derivation, steps=steps))
    return check_statement(json.loads(json.dumps(alone.certificate())), step).status


def edited(noise: str, folder: Path, file: str, right: str, wrong: str) -> Subject:
    """The subject of the page with one place of it, or of a part, changed."""
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, folder)
    text = (folder / f"{file}.md").read_text(encoding="utf-8")
    assert text.count(right) == 1
    (folder / f"{file}.md").write_text(text.replace(right, wrong), encoding="utf-8")
    return derived(noise, folder)


WRONG = [
    ("eta is 4", "root-s", PAGE, "((1 + e) Lambda + 2", "((1 - e) Lambda + 3"),
    ("eta is 4", "other-end", "other-end-without-eta", "Lambda = 4", "Lambda = 5"),
    ("eta is 4", "bend-by-ratios", PAGE, "chi = {chi}", "chi = 2 {chi}"),
    ("eta is 4", "large-updated-22", PAGE, "-> {end_of_updated_22} as", "-> {end} as"),
    ("poles turn real", "other-end", "other-end-with-eta", "2/sigma - Lambda", "2/sigma + Lambda"),
    ("poles turn real", "roots-in-the-index", "ratios-with-eta", "+ e/4,", "- e/4,"),
    ("poles turn real", "complex-poles", "complex-and-real-poles", "a^2 + b^2", "a^2 - b^2"),
    ("poles turn real", "noise-spectrum", PAGE, "[n - (1 - e)/4, n;", "[n + (1 - e)/4, n;"),
    ("poles turn real", "updated-covariance", PAGE, "(alpha - n beta)", "(alpha + n beta)"),
    ("poles never real", "pole-modulus", "complex-poles", "= 1/sigma^2", "= 1/sigma"),
    ("poles never real", "gain-relation", PAGE, "- 2 beta) + {last", "- 3 beta) + {last"),
    ("eta is 4", "concave-beta", PAGE, "concave-beta: 0 > d", "concave-beta: 0 > -d"),
    (
        "poles turn real",
        "discriminant",
        "complex-and-real-poles",
        "the sign of L",
        "the sign of -L",
    ),
    ("poles never real", "discriminant", "complex-poles", "4 beta > (", "5 beta > ("),
    ("poles never real", "alpha-radical", PAGE, "{alpha_radicand}\n", "{alpha_radicand} + 1\n"),
]


@pytest.mark.parametrize(("noise", "step", "file", "right", "wrong"), WRONG)
def test_what_is_not_true_is_rejected(
    tmp_path: Path, noise: str, step: str, file: str, right: str, wrong: str
) -> None:
    assert status(whole(noise), step) == "proved"
    assert status(edited(noise, tmp_path, file, right, wrong), step) == "rejected"


@pytest.mark.parametrize(
    ("file", "right", "wrong", "said"),
    [
        (PAGE, "alpha = p s/sigma\n", "alpha = p s/sigme\n", "'sigme' is neither a quantity nor"),
        (PAGE, "### deviation\n", "### index\n", "there is a step 'index' already"),
        (PAGE, "include {poles}", "include {pole}", "'{pole}' is no slot of words here"),
        (
            "complex-and-real-poles",
            "from 0 to {pole_limit}",
            "from 0 to {limit}",
            "no slot 'limit'",
        ),
        ("gains-by-index", "(in index_below, ", "(in index, ", "no setting 'index' above"),
    ],
)
def test_a_mistake_is_told_with_file_and_line(
    tmp_path: Path, file: str, right: str, wrong: str, said: str
) -> None:
    with pytest.raises(PageError) as caught:
        edited("poles turn real", tmp_path, file, right, wrong)
    lines = (tmp_path / f"{file}.md").read_text(encoding="utf-8").split("\n")
    line = max(number for number, text in enumerate(lines, 1) if wrong.strip() in text)
    assert f"/{file}.md, line {line}: " in str(caught.value)
    assert said in str(caught.value)
