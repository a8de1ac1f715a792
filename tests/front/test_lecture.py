"""Lecture pages: each step with sentence, formula, reason and the checker's word."""

from __future__ import annotations

import re

import pytest

from gainproof import cli
from gainproof.formulas.prose import numbered, plain_prose
from gainproof.jobs.session import open_session
from gainproof.pages import lecture
from gainproof.pages.lecture_items import items, numbers
from gainproof.subjects import derivations
from gainproof.subjects.derived import Derived, derived_from

SUBJECTS = ("random-velocity", "random-acceleration", "least-squares-line")
Capture = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def subjects() -> dict[str, Derived]:
    found = derivations.derive(SUBJECTS, open_session(quiet=True))
    return {derived.name: derived for derived in found}


@pytest.mark.parametrize("name", SUBJECTS)
def test_page_shows_every_step_in_order(
    name: str, subjects: dict[str, Derived], capsys: Capture
) -> None:
    assert cli.main(["derive", name, "--steps"]) == 0
    text = capsys.readouterr().out
    found = items(subjects[name].steps)
    printed = [int(n) for n in re.findall(r"^ {0,2}(\d+)\. \S", text, flags=re.MULTILINE)]
    assert printed == list(range(1, len(found) + 1))
    flat = " ".join(text.split())
    for item in found:
        for words in (item.first.sentence, item.first.reason):
            said = plain_prose(numbered(words, numbers(found)))
            assert " ".join(said.split()) in flat, item.first.id
    marks = re.findall(r"\[(proved|cited|definition)\]$", text, flags=re.MULTILINE)
    assert len(marks) == len(found)


@pytest.mark.parametrize("name", SUBJECTS)
@pytest.mark.parametrize("option", [[], ["--steps"]])
def test_page_is_readable_in_a_terminal(name: str, option: list[str], capsys: Capture) -> None:
    cli.main(["derive", name, *option])
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 100
    assert all(line == line.rstrip() for line in lines)
    assert "  -  " not in "\n".join(lines)


@pytest.mark.parametrize("columns", [80, 100])
def test_page_fits_the_columns_it_is_given(columns: int, subjects: dict[str, Derived]) -> None:
    report = {"accepted": True, "statements": []}
    for derived in subjects.values():
        text = lecture.page(derived, report, columns=columns)
        assert max(map(len, text.splitlines())) <= columns


def test_a_rejected_step_is_marked_and_the_reason_given(subjects: dict[str, Derived]) -> None:
    derived = subjects["random-velocity"]
    report = {
        "accepted": False,
        "given_up": False,
        "reason": "gain-relation: the sides differ",
        "statements": [
            {"id": step.id, "status": "rejected" if step.id == "gain-relation" else "proved"}
            for step in derived.steps
        ],
    }
    text = lecture.page(derived, report)
    assert len(re.findall(r"\[rejected\]$", text, flags=re.MULTILINE)) == 1
    assert "REJECTED: gain-relation: the sides differ" in " ".join(text.split())


def test_steps_that_were_not_checked_are_never_marked_proved(subjects: dict[str, Derived]) -> None:
    report = {"accepted": False, "given_up": False, "reason": "malformed", "statements": []}
    text = lecture.page(subjects["random-velocity"], report)
    assert "[proved]" not in text
    assert "[not checked]" in text


def test_plain_data_comes_back_as_it_was(subjects: dict[str, Derived]) -> None:
    for derived in subjects.values():
        assert derived_from(derived.plain()) == derived


@pytest.mark.parametrize("name", SUBJECTS)
def test_latex_is_balanced(name: str, capsys: Capture) -> None:
    assert cli.main(["derive", name, "--latex"]) == 0
    text = capsys.readouterr().out
    assert text.startswith(r"\documentclass")
    assert text.rstrip().endswith(r"\end{document}")
    for kind in ("align*", "enumerate", "document", "pmatrix"):
        assert text.count(rf"\begin{{{kind}}}") == text.count(rf"\end{{{kind}}}")
    bare = text.replace(r"\{", "").replace(r"\}", "")
    assert bare.count("{") == bare.count("}")
    assert text.count(r"\left") == text.count(r"\right")
