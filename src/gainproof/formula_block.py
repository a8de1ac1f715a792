"""Lines of a formula set on a page: matrices as blocks of rows, long lines broken before a sign.

A matrix comes as text between the marks below, which `formula_text` puts there for this module.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

OPEN, ENTRY, ROW, CLOSE = "\x0e", "\x1f", "\x1e", "\x0f"

_INNERMOST = re.compile(f"{OPEN}([^{OPEN}{CLOSE}]*){CLOSE}")
_CONTINUED = "    "


def marked_matrix(rows: Sequence[Sequence[str]]) -> str:
    """A matrix with marks; matrices inside matrices are written inline."""
    entries = [[inline(entry) for entry in row] for row in rows]
    return OPEN + ROW.join(ENTRY.join(row) for row in entries) + CLOSE


def inline(text: str) -> str:
    """The text with every matrix on one line: `[a, b; c, d]`."""
    return _INNERMOST.sub(
        lambda match: "[" + match[1].replace(ENTRY, ", ").replace(ROW, "; ") + "]", text
    )


def set_formula(text: str, width: int) -> list[str]:
    """The lines of one formula, none longer than `width` where that can be had."""
    if OPEN not in text:
        return broken(text, width)
    lines: list[str] = []
    row: list[list[str]] = []
    for piece in _pieces(text):
        if row and sum(len(block[0]) for block in [*row, piece]) + len(row) > width:
            lines += _joined(row)
            row = [[_CONTINUED]]
        row.append(piece)
    return [line.rstrip() for line in lines + _joined(row)]


def broken(text: str, width: int) -> list[str]:
    """A formula without matrices on as few lines as it needs, broken before a sign."""
    lines: list[str] = []
    rest = text
    while len(rest) > width:
        cut = max(rest.rfind(sign, 1, width) for sign in (" = ", " + ", " - "))
        if cut < width // 4:
            cut = rest.rfind(" ", 1, width)
        if cut <= len(_CONTINUED):
            break
        lines.append(rest[:cut].rstrip())
        rest = _CONTINUED + rest[cut:].lstrip()
    return [*lines, rest]


def _pieces(text: str) -> list[list[str]]:
    """Blocks from left to right: text is one line high, a matrix as many as it has rows."""
    pieces: list[list[str]] = []
    position = 0
    for match in _INNERMOST.finditer(text):
        before = text[position : match.start()].strip()
        if before:
            pieces += [[word] for word in re.split(r"(?<= =) ", before)]
        pieces.append(matrix_rows([row.split(ENTRY) for row in match[1].split(ROW)]))
        position = match.end()
    after = text[position:].strip()
    return [*pieces, [after]] if after else pieces


def matrix_rows(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows of a matrix of texts, columns aligned."""
    widths = [max(len(row[j]) for row in rows) for j in range(len(rows[0]))]
    return [
        "[ " + "  ".join(f"{e:>{w}}" for e, w in zip(row, widths, strict=True)) + " ]"
        for row in rows
    ]


def _joined(blocks: list[list[str]]) -> list[str]:
    """Blocks side by side, each centred on the middle line."""
    height = max(map(len, blocks))
    columns = []
    for block in blocks:
        above = (height - len(block)) // 2
        blank = " " * len(block[0])
        columns.append([blank] * above + block + [blank] * (height - len(block) - above))
    return [" ".join(column[i] for column in columns) for i in range(height)]
