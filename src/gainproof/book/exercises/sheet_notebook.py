"""Sheets and their key as notebooks."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.book.exercises.planting import Planted
from gainproof.book.exercises.sealed import Sealed
from gainproof.book.exercises.sheet_lines import HONESTY, RULE, answer, seal
from gainproof.notebook.cells import Cell
from gainproof.notebook.markup import display, lines_of, markdown_escaped, relation, sentence
from gainproof.pages.lecture_items import items, numbers

_WIDTH = 60


def sheet_cells(sheet: Planted) -> list[Cell]:
    """The lines of a sheet, and at the end a cell in which one of them is marked."""
    derived = sheet.derived
    found = items(derived.steps)
    known = numbers(found)
    told = (
        f"Lines {sheet.first} to {sheet.last} of the derivation `{derived.name}`; what stands "
        "before them there holds. One line is wrong."
    )
    title = f"# Sheet {sheet.number}: {markdown_escaped(derived.title)}"
    cells = [Cell("markdown", "\n\n".join([title, told, RULE, HONESTY]))]
    for item in found:
        if sheet.first <= item.number <= sheet.last:
            said, why = (
                sentence(text, derived.symbols, known, markdown_escaped)
                for text in (item.first.sentence, item.first.reason)
            )
            heading = item.first.heading
            opened = [f"## {markdown_escaped(heading)}"] if heading else []
            formulas = lines_of(item, derived.symbols, markdown_escaped)
            parts = [*opened, f"**{item.number}.** {said}", *formulas, *([why] if why else [])]
            cells.append(Cell("markdown", "\n\n".join(parts)))
    return [
        *cells,
        Cell("markdown", "## Your mark\n\nRun the next cell, then write a number into the last."),
        Cell("code", _written(seal(sheet))),
        Cell("code", "marked = None  # the number of the line that is wrong\nsheet.told(marked)"),
    ]


def _written(sealed: Sealed) -> str:
    """The sealed answer as code."""
    near = "".join(f'        "{digest}",\n' for digest in sealed.near)
    pieces = [sealed.text[k : k + _WIDTH] for k in range(0, len(sealed.text), _WIDTH)]
    text = "".join(f'        "{piece}"\n' for piece in pieces)
    return (
        "from gainproof.book.exercises.sealed import Sealed\n\n"
        f'sheet = Sealed(\n    salt="{sealed.salt}",\n    line="{sealed.line}",\n'
        f"    near=(\n{near}    ),\n    text=(\n{text}    ),\n)"
    )


def key_cells(sheets: Sequence[Planted]) -> list[Cell]:
    """The key: each wrong line, as it was, and the point at which it is false."""
    cells = [Cell("markdown", "# Key to the exercises")]
    for sheet in sheets:
        wrong, right = (
            display([line for words, line in relation(step, sheet.derived.symbols) if not words])
            for step in (sheet.step, sheet.before)
        )
        parts = [
            f"## Sheet {sheet.number}: {markdown_escaped(sheet.derived.title)}",
            markdown_escaped(answer(sheet)),
            "On the sheet:",
            wrong,
            "As it is proved:",
            right,
        ]
        cells.append(Cell("markdown", "\n\n".join(parts)))
    return cells
