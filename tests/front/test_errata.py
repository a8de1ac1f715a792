"""Errata sheets: what cannot stand, with its witness; other people's files are left alone."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli, errata
from gainproof.bad_input import BadInputError

Capture = pytest.CaptureFixture[str]
CLAIMS = Path(__file__).parents[2] / "verify" / "claims"

SOURCE: dict[str, Any] = {
    "key": "notes",
    "title": "Notes_on 50% of filters",
    "authors": ["A. Reader", "B. Other"],
    "publication": "unpublished",
    "year": 2001,
}
WITNESS = {
    "point": {r"\beta_k": "1"},
    "left": {"midpoint": "0.5", "radius": "0"},
    "operator": "=",
    "right": {"midpoint": "4.5", "radius": "0"},
    "exact": False,
}


def claim(name: str, verdict: str, **fields: Any) -> dict[str, Any]:
    return {
        "id": name,
        "place": f"equation ({name})",
        "kind": "identity",
        "latex": r"\beta = \alpha",
        "verdict": verdict,
        "domain": None,
        "evidence": {"method": "", "certificate": None, "witness": fields.pop("witness", None)},
        "repair": None,
        "convention": None,
        "reading": None,
        "undefined": [],
        "reason": "",
        "seconds": 0.0,
    } | fields


JUDGED: dict[str, Any] = {
    "source": SOURCE,
    "claims": [
        claim("1", "proved"),
        claim("2", "refuted", witness=WITNESS, repair={"latex": r"\beta = 2", "verdict": "proved"}),
        claim("3", "conditional", domain="for r > 1", witness=WITNESS),
        claim("4", "undefined", reason="c is never defined by the source", place="page 7"),
        claim("5", "undecided", reason="too long"),
    ],
}


@pytest.mark.parametrize("suffix", [".md", ".tex"])
def test_a_sheet_has_what_cannot_stand_and_nothing_else(suffix: str) -> None:
    text = errata.sheet([JUDGED], [{}], suffix)
    assert text.startswith(errata.MARKS[suffix])
    for part in ("(2)", "(3)", "page 7, 4", r"\beta = 2", "for r", "c is never defined"):
        assert part in text
    assert "(1)" not in text
    assert "(5)" not in text


def test_text_is_escaped() -> None:
    markdown, latex = errata.sheet([JUDGED], [{}], ".md"), errata.sheet([JUDGED], [{}], ".tex")
    assert r"# Errata: Notes\_on 50% of filters" in markdown
    assert r"\section*{Errata: Notes\_on 50\% of filters}" in latex
    assert r"at \textbackslash{}beta\_k = 1" in latex
    assert "\n$$\n\\beta = 2\n$$\n" in markdown
    assert "\\[\n  \\beta = 2\n\\]" in latex


def test_a_claim_in_words_shows_them() -> None:
    judged = {"source": SOURCE, "claims": [claim("1", "refuted", latex="")]}
    for suffix in errata.MARKS:
        assert "gains grow" in errata.sheet([judged], [{"1": "gains grow"}], suffix)


def test_nothing_found_is_said() -> None:
    clean = {"source": SOURCE, "claims": [claim("1", "proved")]}
    assert "No errata were found." in errata.sheet([clean], [{}])
    assert "No errata were found." in errata.sheet([clean], [{}], ".tex")


@pytest.mark.parametrize("name", ["paper.toml", "sheet", "sheet.txt"])
def test_other_kinds_of_files_are_refused(name: str) -> None:
    with pytest.raises(BadInputError, match=r"\.md or \.tex"):
        errata.target(name)


def test_a_paper_is_not_overwritten(tmp_path: Path, capsys: Capture) -> None:
    paper = tmp_path / "paper.tex"
    paper.write_text("\\documentclass{article}\n")
    assert cli.main(["check", "kosuge-slides", "--errata", str(paper)]) == 2
    assert "is left as it is" in capsys.readouterr().err
    assert paper.read_text() == "\\documentclass{article}\n"


@pytest.mark.usefixtures("lecture_known")
def test_a_sheet_is_written_and_renewed(tmp_path: Path, capsys: Capture) -> None:
    sheet = tmp_path / "sheets" / "errata.tex"
    for _ in range(2):
        assert cli.main(["check", "kosuge-slides", "--errata", str(sheet)]) == 0
        assert sheet.read_text().endswith("\\end{document}\n")
    claims = tomllib.loads((CLAIMS / "kosuge-slides.toml").read_text(encoding="utf-8"))["claims"]
    assert f"{len(claims)} claims" in capsys.readouterr().out


@pytest.mark.usefixtures("lecture_known")
def test_a_sheet_to_standard_output(capsys: Capture) -> None:
    assert cli.main(["check", "kosuge-slides", "--errata"]) == 0
    assert capsys.readouterr().out.startswith("<!-- errata sheet")
