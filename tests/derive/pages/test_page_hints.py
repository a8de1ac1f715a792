"""Hints on pages: what lines say, what a proof makes of them, and mistakes with their lines."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.formula import FormulaError
from gainproof.derive.pages.hints import read_hint
from gainproof.derive.pages.page import read_page

LINES: dict[str, dict[str, Any]] = {
    "using nothing": {"using": []},
    "aside margin, poles": {"aside": ["margin", "poles"]},
    "numbers r' w": {"numbers": ["r' w"]},
    "square A by 1": {"squares": [("A", 1)]},
    "square A B by unit n, left inverse B^-1, through": {
        "squares": [("A B", ("unit", "n"), {"left_inverse": "B^-1", "through": True})]
    },
    "square f I by definite, weight 1/(2 f)": {
        "squares": [("f I", "definite", {"weight": "1/(2 f)"})]
    },
    "taken -I by inverse regular left on (A - B)'": {
        "taken": [("-I", ("inverse", "regular", "left"), "(A - B)'")]
    },
    "multiple E' by 2 on F": {"multiples": [("E'", 2, "F")]},
    "used J by blocks m on I": {"used": [("J", ("blocks", "m"), "I")]},
    "rank 3": {"rank": 3},
    "definite weight": {"definite": "weight"},
    "left inverse A - B": {"left_inverse": "A - B"},
    "limit form 1/L": {"limit_form": "1/L"},
    "form 2/L": {"form": "2/L"},
    "side right": {"side": "right"},
}


@pytest.mark.parametrize(("line", "entries"), LINES.items())
def test_a_line_says(line: str, entries: dict[str, Any]) -> None:
    assert read_hint([line]) == entries


def test_lines_of_one_word_are_listed() -> None:
    found = read_hint(["square A by 1", "rounds 1", "square B by 2"])
    assert found == {"squares": [("A", 1), ("B", 2)], "rounds": 1}


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("squared A by 1", "a hint that begins with using, aside"),
        ("rank first", "a hint that begins with using, aside"),
        ("square A", "'square F by SOURCE"),
        ("square A by 1, over B", "'square F by SOURCE"),
        ("taken A by 1", "'L by SOURCE on R' is wanted"),
        ("form", "a hint that begins with using, aside"),
    ],
)
def test_what_is_no_hint_is_refused(line: str, wanted: str) -> None:
    with pytest.raises(FormulaError, match=wanted):
        read_hint([line])


PAGE = """\
# An update
What it is about.

matrices update
    A: n by n

### sum (in update)
Two squares.

    A A' + A' A >= 0

because They are.

hint sum
    square A by unit n
    square A' by unit n
"""


def made(folder: Path, text: str, given: Given | None = None) -> Any:
    (folder / "page.md").write_text(text, encoding="utf-8")
    return written("page", given or Given(), folder)


def test_a_proof_takes_what_the_hint_says(tmp_path: Path) -> None:
    (step,) = made(tmp_path, PAGE).steps
    assert len(step.hint["evidence"]["squares"]) == 2
    assert str(read_page(PAGE, "page.md")) == PAGE


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("    square A' by unit n\n", "", "page.md, line 10: nothing shows"),
        (
            "hint sum",
            "hint some\n    rounds 1\n\nhint sum",
            "hints for steps that are not there: .'some'.",
        ),
        ("square A by", "squares A by", "page.md, line 14: a hint that begins with"),
        ("because They", "hint sum\n    rounds 1\n\nbecause They", "page.md, line 15: a block"),
        ("hint sum\n", "hint sum\n    rounds 1\n\nhint sum\n", "line 17: there is a hint for"),
    ],
)
def test_a_mistake_is_told_with_its_line(right: str, wrong: str, said: str, tmp_path: Path) -> None:
    assert right in PAGE
    with pytest.raises(PageError, match=said):
        made(tmp_path, PAGE.replace(right, wrong, 1))


def test_one_hint_is_enough(tmp_path: Path) -> None:
    hints = {"sum": {"squares": [("A", ("unit", "n"))]}}
    with pytest.raises(PageError, match="there is a hint for 'sum' already"):
        made(tmp_path, PAGE, Given(hints=hints))
