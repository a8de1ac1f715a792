"""The pages that several families and models of a user's own share, with mistakes in them."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
import sympy as sp
from own_models import free_number, own_model

from gainproof.derive.any_two_state import proved_module
from gainproof.derive.any_two_state.any_two_state import PAGE as FIRST
from gainproof.derive.any_two_state.any_two_state import derive_any_two_state
from gainproof.derive.derivation import PageError
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.steady_state.two_state import PAGE, derive_two_state
from gainproof.derive.subject import Subject
from gainproof.verify.certificate import check_statement

R, Q = real("r"), sp.Rational
KINEMATIC: Mapping[str, Model] = {
    name: own_model([[1, 1], [0, 1]], [[first, cross], [cross, 1]])
    for name, first, cross in (
        ("eta is 4", Q(1, 4), Q(1, 2)),
        ("poles turn real", Q(1, 8), Q(1, 4)),
        ("poles stay complex", Q(1, 3), Q(1, 3)),
    )
}
OTHERS: Mapping[str, Model] = {
    "decay": own_model([[1, Q(1, 2)], [0, Q(1, 2)]], [[0, 0], [0, 1]]),
    "any decay": own_model(
        [[1, 1 - R], [0, R]], [[0, 0], [0, 1]], parameters=(free_number("r", below_one=True),)
    ),
}


@pytest.fixture(autouse=True, scope="module")
def without_bounds() -> Iterator[None]:
    """Bounds of kernels take their time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(proved_module, "prove", lambda _kernel, _form: None)
        yield


def derived(model: str, folder: Path = FOLDER) -> Subject:
    if model in OTHERS:
        return derive_any_two_state(OTHERS[model], folder)
    return derive_two_state(KINEMATIC[model], (), folder)


@cache
def whole(model: str) -> Subject:
    return derived(model)


def status(subject: Subject, step: str) -> str:
    """What the checker says of a step's statement, alone."""
    steps = tuple(each for each in subject.derivation.steps if each.id == step)
    alone = replace(subject, derivation=replace(subject.derivation, steps=steps))
    return check_statement(json.loads(json.dumps(alone.certificate())), step).status


def edited(model: str, folder: Path, file: str, right: str, wrong: str) -> Subject:
    """The subject of the page with one place of it, or of a part, changed."""
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, folder)
    text = (folder / f"{file}.md").read_text(encoding="utf-8")
    assert text.count(right) == 1
    (folder / f"{file}.md").write_text(text.replace(right, wrong), encoding="utf-8")
    return derived(model, folder)


WRONG = [
    ("eta is 4", "root-s", PAGE, "((1 + e) Lambda + 2", "((1 - e) Lambda + 3"),
    ("eta is 4", "other-end", PAGE, "Lambda = 4", "Lambda = 5"),
    ("eta is 4", "bend-by-ratios", PAGE, "chi = (kappa + 1/2)", "chi = 2 (kappa + 1/2)"),
    ("eta is 4", "large-updated-22", PAGE, "X22/Lambda -> 2 as", "X22/Lambda -> 3 as"),
    ("eta is 4", "concave-beta", PAGE, "concave-beta: 0 > d", "concave-beta: 0 > -d"),
    ("poles turn real", "other-end", PAGE, "sigma - Lambda = eta", "sigma + Lambda = eta"),
    ("poles turn real", "roots-in-the-index", PAGE, "+ e/4, kappa", "- e/4, kappa"),
    ("poles turn real", "complex-poles", PAGE, "a^2 + b^2", "a^2 - b^2"),
    ("poles turn real", "noise-spectrum", PAGE, "[n - (1 - e)/4, n;", "[n + (1 - e)/4, n;"),
    ("poles turn real", "updated-covariance", PAGE, "(alpha - n beta)", "(alpha + n beta)"),
    ("poles turn real", "discriminant", PAGE, "the sign of Lambda - {pole", "the sign of -{pole"),
    (
        "poles stay complex",
        "pole-modulus",
        PAGE,
        "  1 - alpha = 1/sigma^2\n",
        "  1 - alpha = 1/sigma\n",
    ),
    ("poles stay complex", "gain-relation", PAGE, "- 2 beta) + {last", "- 3 beta) + {last"),
    ("poles stay complex", "discriminant", PAGE, "    4 beta > (", "    5 beta > ("),
    ("poles stay complex", "alpha-radical", PAGE, "{alpha_radicand}\n", "{alpha_radicand} + 1\n"),
    ("decay", "roots", FIRST, "+ 2 d0 d2]", "+ 3 d0 d2]"),
    ("decay", "stable-beta", FIRST, "stable-beta: beta =", "stable-beta: 2 beta ="),
    ("decay", "covariances", FIRST, "X22 + beta^2 sigma^2]", "X22 + beta sigma^2]"),
    ("any decay", "riccati", "riccati-by-entries", "transition}' + entering", "transition}'"),
    ("any decay", "scaled-transition", "model-in-units", " {units} = {sc", " {units} = 2 {sc"),
]


@pytest.mark.parametrize(("model", "step", "file", "right", "wrong"), WRONG)
def test_what_is_not_true_is_rejected(
    tmp_path: Path, model: str, step: str, file: str, right: str, wrong: str
) -> None:
    assert status(whole(model), step) == "proved"
    assert status(edited(model, tmp_path, file, right, wrong), step) == "rejected"


@pytest.mark.parametrize(
    ("model", "file", "right", "wrong", "said"),
    [
        ("eta is 4", PAGE, "alpha = p s/sigma\n", "alpha = p s/sigme\n", "'sigme' is neither a"),
        ("eta is 4", PAGE, "### deviation\n", "### index\n", "there is a step 'index' already"),
        ("eta is 4", PAGE, "### eta (if e_above_0)", "### eta (if e_above)", "no slot 'e_above'"),
        ("poles turn real", PAGE, "from 0 to {pole_limit}", "from 0 to {pole}", "no slot 'pole'"),
        ("poles turn real", PAGE, "(in index_below, ", "(in index, ", "no setting 'index' above"),
        ("decay", FIRST, "steps large-index", "steps large", "no steps 'large' of the program"),
        (
            "decay",
            "model-in-units",
            "`x` {measured} measured",
            "`x` {number} measured",
            "'{number}' is",
        ),
    ],
)
def test_a_mistake_is_told_with_file_and_line(
    tmp_path: Path, model: str, file: str, right: str, wrong: str, said: str
) -> None:
    with pytest.raises(PageError) as caught:
        edited(model, tmp_path, file, right, wrong)
    lines = (tmp_path / f"{file}.md").read_text(encoding="utf-8").split("\n")
    place = max(number for number, text in enumerate(lines, 1) if wrong.strip() in text)
    told = str(caught.value).partition(f"/{file}.md, line ")[2]
    # of a sentence the line of its step is told
    assert place - 1 <= int(told.partition(":")[0]) <= place
    assert said in str(caught.value)
