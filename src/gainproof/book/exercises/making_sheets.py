"""Sheets made, checked, and put into the site."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gainproof.book.exercises.planting import Planted, plant
from gainproof.book.exercises.sheet_notebook import key_cells, sheet_cells
from gainproof.book.exercises.sheet_pages import (
    KEY,
    SCRIPT,
    key_file,
    notebook_address,
    sheet_pages,
    words_on_others,
)
from gainproof.book.more import More
from gainproof.jobs.session import Session
from gainproof.notebook.cells import notebook
from gainproof.subjects import derivations
from gainproof.subjects.derived import Derived

_STATIC = Path(__file__).resolve().parent.parent / "static"
SOUND = frozenset({"proved", "cited", "definition"})


def exercises(
    subjects: Sequence[Derived], count: int, seed: int, session: Session, *, notebooks: bool = False
) -> More:
    """So many sheets with their list and their key, as notebooks too if these are wanted.

    Raises BadInputError where no derivation has a step in which an error can be planted, and where
    what writes notebooks is missing.
    """
    sheets = plant(subjects, count, seed)
    reports = derivations.recheck([(s.derived.certificate, s.derived) for s in sheets], session)
    for sheet, report in zip(sheets, reports, strict=True):
        require_sound(sheet, report)
    return More(
        pages=sheet_pages(sheets, reports, notebooks=notebooks),
        scripts={SCRIPT: (_STATIC / SCRIPT).read_text(encoding="utf-8")},
        files={f"{KEY}.json": key_file(sheets), **(_notebooks(sheets) if notebooks else {})},
        front={"exercises": count},
    )


def _notebooks(sheets: Sequence[Planted]) -> dict[str, str]:
    """Raises BadInputError where nbformat is missing."""
    files = {notebook_address(sheet.number): notebook(sheet_cells(sheet)) for sheet in sheets}
    return {**files, f"{KEY}.ipynb": notebook(key_cells(sheets))}


def require_sound(sheet: Planted, report: dict[str, object]) -> None:
    """The checker rejects the planted line and no other. Raises ArithmeticError otherwise: a sheet
    that says so and does not hold it up is worse than none.
    """
    statements = report["statements"]
    assert isinstance(statements, list)
    words = {entry["id"]: entry["status"] for entry in statements}
    others = {word for id_, word in words.items() if id_ != sheet.id}
    if words.get(sheet.id) != "rejected" or not others <= SOUND or len(words) < 2:
        told = words_on_others(sheet, report)
        raise ArithmeticError(
            f"sheet {sheet.number}, {sheet.derived.name}: step {sheet.id} is "
            f"{words.get(sheet.id)}, of the others {told}"
        )
