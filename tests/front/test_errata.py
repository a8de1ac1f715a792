"""Errata sheets: what cannot stand, with its witness; other people's files are left alone."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.claims.source_words import Said, claims_said
from gainproof.errata import errata_sheet
from gainproof.errata.errata_entries import entries
from gainproof.verify.judge.claim.usual_meanings import ORIGINS

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
    text = errata_sheet.sheet([JUDGED], [{}], suffix)
    assert text.startswith(errata_sheet.MARKS[suffix])
    for part in ("(2)", "(3)", "page 7, 4", r"\beta = 2", "$r > 1$", "c is never defined"):
        assert part in text
    assert "(1)" not in text
    assert "(5)" not in text


def test_text_is_escaped() -> None:
    markdown, latex = (
        errata_sheet.sheet([JUDGED], [{}], ".md"),
        errata_sheet.sheet([JUDGED], [{}], ".tex"),
    )
    assert r"# Errata: Notes\_on 50% of filters" in markdown
    assert r"\section*{Errata: Notes\_on 50\% of filters}" in latex
    assert r"at $\beta_k = 1$ the left side" in latex
    assert r"at $\beta_k = 1$ the left side" in markdown
    assert "\n$$\n\\beta = 2\n$$\n" in markdown
    assert "\\[\n  \\beta = 2\n\\]" in latex


def sheets(*claims: dict[str, Any], **said: Said) -> tuple[str, str]:
    judged = {"source": SOURCE, "claims": list(claims)}
    both = tuple(errata_sheet.sheet([judged], [said], suffix) for suffix in errata_sheet.MARKS)
    assert len(both) == 2
    return both[0], both[1]


def in_order(text: str, *parts: str) -> bool:
    places = [text.find(part) for part in parts]
    return -1 not in places and places == sorted(places)


@pytest.mark.parametrize("origin", ["words", "reconstructed"])
def test_printed_stands_over_nothing_that_is_not_printed(origin: str) -> None:
    said = Said(origin, "gains grow quickly", note="no number is given", under=("k > 1",))
    for text in sheets(claim("a", "refuted", witness=WITNESS), a=said):
        assert "Only what stands under" in text
        body = text.split("are ours.", 1)[1]
        assert "printed" not in body.lower()
        label = "Read as (refuted)" if origin == "words" else "Reconstructed by us (refuted)"
        wanted = ("gains grow quickly", label, r"\beta = \alpha", "k > 1", "Why:", "no number is")
        assert in_order(body, *wanted)


def test_a_claim_without_a_formula_says_as_what_its_words_are_read() -> None:
    said = Said("words", "gains grow", reading="K is increasing in S")
    for text in sheets(claim("a", "refuted", latex="", kind="monotone"), a=said):
        assert in_order(text, "In words: gains grow", "Read as (refuted):", "K is increasing in S")


def test_an_excerpt_is_shown_as_seen_before_what_was_read() -> None:
    said = Said(quoted="q = pow(dt, 3) & 1;\n  r_1 *= 2;", note="R is constant")
    markdown, latex = sheets(claim("a", "refuted"), a=said)
    assert in_order(
        markdown, "As printed:", "    q = pow(dt, 3) & 1;\n      r_1", "Read as (refuted)"
    )
    assert in_order(
        latex, r"pow(dt, 3) \& 1;\\", r"r\_1 *= 2;", "Read as (refuted)", "R is constant"
    )


def test_what_is_ours_is_no_erratum_of_the_source() -> None:
    for text in sheets(claim("a", "refuted"), claim("b", "proved"), a=Said("ours"), b=Said("ours")):
        assert "No errata were found." in text
        assert r"\beta = \alpha" not in text
        assert "No errata of the source: 1 statement of ours" in text


@pytest.mark.parametrize("copies", [2, 5])
def test_claims_that_are_read_alike_are_one_entry(copies: int) -> None:
    names = [f"c{n}" for n in range(copies)]
    alike = [claim(n, "refuted", place=f"part {n}", latex="", kind="monotone") for n in names]
    other = claim("x", "refuted", latex=r"\alpha > 1")
    said = {n: Said("words", f"sentence {n}", reading="G is falling") for n in names}
    for text in sheets(alike[0], other, *alike[1:], **said, x=Said("words", "another")):
        assert text.count("G is falling") == 1
        assert text.count("Read as") == 2
        assert in_order(text, "; ".join(f"part {n}" for n in names), "(part c0): sentence c0")
        assert in_order(text, f"(part {names[-1]}): sentence {names[-1]}", "G is falling")


def test_several_readings_of_one_sentence_are_one_entry() -> None:
    here = {"place": "page 9"}
    first, second = (claim(n, "refuted", latex=rf"\alpha > {n}", **here) for n in "12")
    elsewhere = claim("3", "refuted", latex=r"\alpha > 3", place="page 8")
    said = dict.fromkeys("123", Said("words", "it is large"))
    markdown, _ = sheets(first, second, elsewhere, **said)
    assert markdown.count("In words: it is large") == 2
    assert markdown.count("Read as") == 3


def repaired(name: str, latex: str, *changes: str) -> dict[str, Any]:
    repair = {"latex": latex + "+1", "verdict": "proved", "changes": [*changes], "under": ""}
    return claim(name, "refuted", latex=latex, repairs=[repair])


@pytest.mark.parametrize("formulas", ["ab", "abcde"])
def test_one_change_that_repairs_several_formulas_is_one_entry(formulas: str) -> None:
    change = "a symbol: r becomes s"
    found = [repaired(name, f"{name} = r", change) for name in formulas]
    for text in sheets(*found, repaired("x", "x = r", change, "a symbol: t becomes u")):
        assert text.count("One change repairs all of these") == 1
        assert text.count("Read instead") == len(formulas) + 1
        places = "; ".join(f"equation ({name})" for name in formulas)
        assert text.count(places) == 1


@pytest.mark.parametrize("change", ["a printed number: 1 becomes 2", "sign of a term: a"])
def test_changes_that_name_no_thing_join_nothing(change: str) -> None:
    for text in sheets(repaired("a", "a = 1", change), repaired("b", "b = 1", change)):
        assert "One change" not in text
        assert "equation (a);" not in text


def test_nothing_found_is_said() -> None:
    clean = {"source": SOURCE, "claims": [claim("1", "proved")]}
    assert "No errata were found." in errata_sheet.sheet([clean], [{}])
    assert "No errata were found." in errata_sheet.sheet([clean], [{}], ".tex")


@pytest.mark.parametrize("name", ["paper.toml", "sheet", "sheet.txt"])
def test_other_kinds_of_files_are_refused(name: str) -> None:
    with pytest.raises(BadInputError, match=r"\.md or \.tex"):
        errata_sheet.target(name)


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


def test_symbols_of_a_reading_are_told_with_their_meanings() -> None:
    text = (CLAIMS / "patent-4869403.toml").read_text(encoding="utf-8")
    said = claims_said(text)["figure8"]
    assert dict(said.symbols)["c"] == "ratio of the index to the nominal one"
    assert "a" not in dict(said.symbols)
    for sheet in sheets(claim("figure8", "refuted"), figure8=said):
        assert "$c$: ratio of the index to the nominal one" in sheet


@pytest.mark.parametrize("file", sorted(CLAIMS.rglob("*.toml")), ids=lambda path: path.stem)
def test_every_claim_of_every_file_has_an_origin(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    for claim_, said in zip(tomllib.loads(text)["claims"], claims_said(text).values(), strict=True):
        assert said.origin in ORIGINS
        if said.origin == "printed":
            assert "latex" in claim_ or "plain" in claim_
            assert not said.note.startswith(("Not printed", "Not in the source", "Reconstructed"))


def test_claims_are_one_entry_over_others_between_them() -> None:
    found = [
        claim("u", "refuted", latex="f > 1", place="page 1"),
        claim("v", "refuted", latex="f > 1", place="page 2"),
        claim("w", "refuted", latex="g > 1", place="page 1"),
    ]
    large = Said("words", "it is large")
    for text in sheets(*found, u=large, v=Said("words", "so it is"), w=large):
        assert text.count("page 1, u; page 2, v; page 1, w") == 1
        assert text.count("it is large") == 1


@pytest.mark.parametrize("differs", ["reading", "under", "verdict"])
def test_members_of_an_entry_that_are_read_apart_are_each_shown(differs: str) -> None:
    """As well where they have no formula, or one and the same."""
    said = [Said("words", "it is large", reading="K rises"), Said("words", "it is large")]
    if differs == "reading":
        said[1] = replace(said[0], reading="K falls")
        both = [claim(n, "refuted", latex="", place="page 9") for n in "12"]
    else:
        said[1] = replace(said[0], under=("k > 1",) if differs == "under" else ())
        verdicts = ("refuted", "refuted" if differs == "under" else "undefined")
        both = [claim(n, v, place="page 9") for n, v in zip("12", verdicts, strict=True)]
    (entry,) = entries({"source": SOURCE, "claims": both}, dict(zip("12", said, strict=True)))
    assert [member.claim["id"] for member in entry.readings] == ["1", "2"]
    for text in sheets(*both, **dict(zip("12", said, strict=True))):
        assert text.count("Read as") == 2
