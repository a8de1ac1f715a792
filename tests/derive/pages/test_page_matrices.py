"""Matrices of every size on a page: what is written is claimed, and what is false is not proved."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from gainproof.derive.derivation import PageError, Step
from gainproof.derive.pages.derivation import Given, Written, written
from gainproof.derive.words.expression import symbol

PAGE = """\
# An update
What it is about.

matrices update
    t: positive
    c: real
    P, Phi = transition: n by n
    K, K_o = best: n by m
    R, S: m by m
    H: m by n
    I: unit of n
    S: with inverse
    S = H P H' + R
    K_o = P H' S^-1

matrices other
    S, Q: k by k
    S: with inverse

### other-inverse (in other)
Another S.

    S is invertible if S is positive definite

### innovation (in update)
What is said.

    S > 0 if P is positive semidefinite, R is positive definite
    means-s: where S
    inverse: S is invertible if P is positive semidefinite, R is positive definite
    share: (I - K_o H) P = P - K_o S K_o' if P is positive semidefinite, R is positive definite
    own-transpose: t P' - c P'/2 = (t - c/2) P if P is symmetric
    traces: trace(Phi P) = trace(P Phi)
    cited: theorem: A theorem. [lancaster-rodman-1995]

because Reason.
"""
HINTS: dict[str, Any] = {
    "innovation": {"squares": [("H'", 1), ("unit(m)", 2, {"left_inverse": "unit(m)"})]},
    "share": {"rounds": 1},
}


def made(
    folder: Path, right: str = "", wrong: str = "", hints: Mapping[str, Any] = HINTS
) -> Written:
    """The page with one place changed."""
    assert right in PAGE
    (folder / "page.md").write_text(PAGE.replace(right, wrong, 1), encoding="utf-8")
    return written("page", Given(hints=hints), folder)


def steps(page: Written) -> dict[str, Step]:
    """By their ids."""
    return {step.id: step for step in page.steps}


def test_a_page_has_its_letters_and_what_they_stand_for(tmp_path: Path) -> None:
    page = made(tmp_path)
    setting = page.settings["update"]
    assert setting.matrices["transition"] == "n n"
    assert (setting.parameters, setting.free, dict(setting.units)) == (("t",), ("c",), {"I": "n"})
    p, h, s = map(symbol, "PHS")
    assert setting.elements["best"] == p @ h.T @ s.inverse
    assert page.latex["transition"] == r"\Phi"
    assert page.latex["best"] == "K_o"


def test_a_statement_claims_what_is_written_with_its_conditions(tmp_path: Path) -> None:
    found = steps(made(tmp_path))
    relation = found["innovation"].relation
    assert (relation.kind, relation.parts["relation"]) == ("matrix_order", ">")
    assert [x["kind"] for x in relation.parts["given"]] == ["semidefinite", "definite"]
    assert relation.parts["larger"] == symbol("S").graph
    kinds = {name: step.relation.kind for name, step in found.items()}
    assert kinds["inverse"] == "matrix_invertible"
    assert kinds["traces"] == "matrix_trace"
    assert (kinds["means-s"], kinds["cited"]) == ("definition", "cited")


def test_what_is_known_of_an_inverse_is_that_of_its_own_setting(tmp_path: Path) -> None:
    """Both settings have an S: the statement on one is no evidence in the other."""
    text = str(steps(made(tmp_path))["share"].hint["evidence"])
    assert "'inverse', 'inverse'" in text
    assert "other-inverse" not in text


WRONG = [
    (
        "P - K_o S K_o' if",
        "P + K_o S K_o' if",
        31,
        "nothing shows that this is so: share: left over -2 P H' S_inverse H P",
    ),
    ("(t - c/2) P if", "(t - c) P if", 32, "nothing shows that this is so"),
    ("(t - c/2) P if P is symmetric", "(t - c/2) P", 32, "nothing shows that this is so"),
    ("P - K_o S K_o' if P", "P - K_o S K_o' if Phi is symmetric, P", 31, "it needs P is positive"),
    ("    K_o = P H'", "    K_o = H P", 14, "is multiplied by"),
    ("    S: with inverse", "    Q: with inverse", 12, "'Q' has no shape above"),
    ("    I: unit of n", "    P: unit of n", 11, "'P' has a meaning already"),
    ("    I: unit of n", "    I: unit", 11, "'name = formula' is wanted"),
    ("P H' S^-1", "P H' R^-1", 14, "a letter 'with inverse' is wanted"),
    ("trace(Phi P) =", "trace((1/0) P) =", 33, "'1/0' divides by 0"),
    ("trace(Phi P)", "trace(Psi P)", 33, "'Psi' is no letter of setting update"),
    ("means-s: where S", "means-s: where P", 29, "'P' stands for nothing in setting update"),
    ("trace(Phi P) =", "sqrt(Phi P) =", 33, "is no formula of matrices of every size"),
    ("S > 0 if", "S falls with t if", 28, "on matrices of every size: L = R, L >= R"),
    ("S > 0 if P", "S > 0 if S falls with P, P", 28, "wanted"),
]


@pytest.mark.parametrize(("right", "wrong", "line", "said"), WRONG)
def test_what_is_false_or_misspelled_is_told_with_its_line(
    tmp_path: Path, right: str, wrong: str, line: int, said: str
) -> None:
    with pytest.raises(PageError) as caught:
        made(tmp_path, right, wrong)
    assert said in str(caught.value)
    assert f"page.md, line {line}: " in str(caught.value)


def test_an_order_without_squares_is_not_proved(tmp_path: Path) -> None:
    with pytest.raises(PageError, match="nothing shows that this is so: innovation: left over"):
        made(tmp_path, hints={})
