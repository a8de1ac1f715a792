"""Pages of the site for sheets: each sheet, the list of them, and the key, which lies apart."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.book.derivation_pages import address, formulas_of, writer_of
from gainproof.book.exercises.planting import Planted
from gainproof.book.exercises.sheet_lines import (
    HONESTY,
    RULE,
    answer,
    region,
    seal,
    sheet_lines,
)
from gainproof.book.page import Finding, Page
from gainproof.formulas.prose import plain_prose
from gainproof.pages.lecture import count, marks_of
from gainproof.verdicts.witness_text import of_relation

SCRIPT = "exercises.js"
KEY = "answers"


def sheet_address(number: int) -> str:
    """Where the page of a sheet lies."""
    return f"exercises/sheet-{number}.html"


def notebook_address(number: int) -> str:
    """Where a sheet lies as a notebook."""
    return f"exercises/sheet-{number}.ipynb"


def sheet_pages(
    sheets: Sequence[Planted], reports: Sequence[Mapping[str, Any]], *, notebooks: bool = False
) -> list[Page]:
    """The list, the sheets and the key. `reports`: the checker's on each sheet's certificate;
    `notebooks`: whether there are these to lead to.
    """
    return [
        _list(sheets, notebooks),
        *(_sheet(sheet, report) for sheet, report in zip(sheets, reports, strict=True)),
        _key(sheets, reports),
    ]


def words_on_others(sheet: Planted, report: Mapping[str, Any]) -> str:
    """`102 proved, 7 definition, 1 cited`: the checker's words on all steps but the wrong one."""
    marks = marks_of(report)
    return count(marks[step.id] for step in sheet.derived.steps if step.id != sheet.id)


def _list(sheets: Sequence[Planted], notebooks: bool) -> Page:
    rows = [
        (
            sheet_address(sheet.number),
            notebook_address(sheet.number) if notebooks else "",
            sheet.number,
            sheet.derived.title,
            sheet.first,
            sheet.last,
        )
        for sheet in sheets
    ]
    return Page(
        "exercises/index.html",
        "Exercises: find the error",
        "list",
        "exercises.html",
        {"rows": rows, "rule": RULE, "honesty": HONESTY, "seed": sheets[0].seed, "key": KEY},
        findings=(Finding("Exercises: find the error", "sheets with a planted error"),),
    )


def _sheet(sheet: Planted, report: Mapping[str, Any]) -> Page:
    return Page(
        path=sheet_address(sheet.number),
        title=f"Sheet {sheet.number}: {sheet.derived.title}",
        kind="exercise",
        template="exercise.html",
        data={
            "opening": plain_prose(sheet.derived.opening),
            "lines": sheet_lines(sheet, "../"),
            "sealed": seal(sheet).plain(),
            "rule": RULE,
            "honesty": HONESTY,
            "key": KEY,
            "others": words_on_others(sheet, report),
            "first": sheet.first,
            "last": sheet.last,
            "whole": address(sheet.derived.name),
        },
        scripts=(SCRIPT,),
    )


def _key(sheets: Sequence[Planted], reports: Sequence[Mapping[str, Any]]) -> Page:
    rows = []
    for sheet, report in zip(sheets, reports, strict=True):
        writer = writer_of(sheet.derived.symbols)
        rows.append(
            {
                "number": sheet.number,
                "title": sheet.derived.title,
                "whole": f"{address(sheet.derived.name)}#step-{sheet.id}",
                "line": sheet.line,
                "id": sheet.id,
                "slip": sheet.slip,
                "wrong": formulas_of(sheet.step, writer),
                "right": formulas_of(sheet.before, writer),
                "witness": of_relation(sheet.witness.plain(), sheet.derived.symbols),
                "others": words_on_others(sheet, report),
            }
        )
    return Page(f"{KEY}.html", "Key to the exercises", "list", "answers.html", {"rows": rows})


def key_file(sheets: Sequence[Planted]) -> str:
    """The key as JSON: for each sheet the line, what was done to it, and the witness."""
    entries = [
        {
            "sheet": sheet.number,
            "seed": sheet.seed,
            "derivation": sheet.derived.name,
            "line": sheet.line,
            "half": region(sheet.derived, sheet.line, sheet.first, sheet.last),
            "step": sheet.id,
            "slip": sheet.slip,
            "answer": answer(sheet),
            "witness": sheet.witness.plain(),
            "claim": sheet.step.claim,
            "before": sheet.before.claim,
        }
        for sheet in sheets
    ]
    return json.dumps(entries, indent=1, ensure_ascii=False) + "\n"
