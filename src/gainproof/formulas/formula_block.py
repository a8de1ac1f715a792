"""Lines of a formula set on a page: matrices as blocks of rows, long lines broken before a sign.

A matrix comes as text between the marks below, which `formula_text` puts there for this module.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

OPEN, ENTRY, ROW, CLOSE = "\x0e", "\x1f", "\x1e", "\x0f"

_INNERMOST = re.compile(f"{OPEN}([^{OPEN}{CLOSE}]*){CLOSE}")
_CONTINUED = "    "
_RELATIONS = (" = ", " -> ")
_SIGNS = (*_RELATIONS, " > ", " < ", " >= ", " <= ", " + ", " - ", " as ")
_ARROW_OF_AN_END = re.compile(r" as \w+$")
"""What stands before the arrow of `as p -> infinity`, which stays on the line of its `as`."""


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
            moved = [row.pop()] if len(row) > 1 and row[-1] == ["="] else []
            lines += _joined(row)
            row = [[_CONTINUED[1:]], *moved]
        row.append(piece)
    return [line.rstrip() for line in lines + _joined(row)]


def broken(text: str, width: int) -> list[str]:
    """A formula without matrices on as few lines as it needs, broken before a sign, outside
    parentheses where that can be had.
    """
    lines: list[str] = []
    rest = text
    while len(rest) > width:
        cut = _cut(rest, width)
        if not cut:
            break
        lines.append(rest[:cut].rstrip())
        # a product that goes on stands further in than a term
        again = _CONTINUED if rest.startswith(_SIGNS, cut) else 2 * _CONTINUED
        rest = again + rest[cut:].lstrip()
    return [*lines, rest]


def _cut(text: str, width: int) -> int:
    """The best place for a line to end: of the least depth of parentheses, where a sign is better
    than a space between factors, and the last of those; 0 if there is none.
    """
    depth = 0
    found: list[tuple[int, int, int]] = []
    for place, character in enumerate(text[: width + 1]):
        depth += (character in "([") - (character in ")]")
        if _ARROW_OF_AN_END.search(text, 0, place):
            continue
        if character == " " and place > 2 * len(_CONTINUED):
            sign = text.startswith(_SIGNS, place)
            # early in the line only an equals sign or an arrow is worth a break
            early = place < width // 4 and not text.startswith(_RELATIONS, place)
            found.append((-early, -2 * depth - (not sign), place))
    return max(found, default=(0, 0, 0))[-1]


def _pieces(text: str) -> list[list[str]]:
    """Blocks from left to right: text is one line high, a matrix as many as it has rows."""
    pieces: list[list[str]] = []
    position = 0
    for match in _INNERMOST.finditer(text):
        before = text[position : match.start()].strip()
        if before:
            pieces += [[word] for word in re.split(r" (?==)|(?<==) ", before)]
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
