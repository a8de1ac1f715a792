"""Displayed equations of a LaTeX text: their rows, tags, labels, numbers as LaTeX counts them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from gainproof.claims.tex_text import body_start, group_end

_ONE_ROW = ("equation", "displaymath", "multline", "math")
_ROWS = ("align", "gather", "eqnarray", "alignat", "flalign")
_NUMBERED_LESS = ("displaymath", "math")
_SUBEQUATIONS = "subequations"


@dataclass(frozen=True)
class _Display:
    """The inside of one display: `environment` without its star (`[` and `$$` for the short
    forms), whether its rows are numbered, and the offset of `content` in the text.
    """

    environment: str
    numbered: bool
    content: str
    offset: int


@dataclass(frozen=True)
class _Mark:
    """`\\begin{subequations}` (`opens`) or its end."""

    opens: bool


def _displays(text: str) -> Iterator[_Display | _Mark]:
    """All displays of the body. `text` is without comments. A display without an end is left out,
    with what follows it.
    """
    position = body_start(text)
    dollars = text.find("$$", position)
    while True:
        backslash = text.find("\\", position)
        if 0 <= dollars < position:
            dollars = text.find("$$", position)
        if backslash < 0 and dollars < 0:
            return
        if backslash < 0 or 0 <= dollars < backslash:
            end = text.find("$$", dollars + 2)
            if end < 0:
                return
            yield _Display("$$", False, text[dollars + 2 : end], dollars + 2)
            position = end + 2
            continue
        found = _at_backslash(text, backslash)
        if found is None:
            position = backslash + 2
            continue
        display, position = found
        if display is None:
            return
        yield display


def _at_backslash(text: str, place: int) -> tuple[_Display | _Mark | None, int] | None:
    """What begins at a backslash and where it ends; None if no display does."""
    if text.startswith("\\[", place):
        return _until(text, "[", False, place + 2, "\\]")
    for opens, word in ((True, "\\begin{"), (False, "\\end{")):
        mark = f"{word}{_SUBEQUATIONS}}}"
        if text.startswith(mark, place):
            return _Mark(opens), place + len(mark)
    if not text.startswith("\\begin{", place):
        return None
    start = place + len("\\begin{")
    close = text.find("}", start, start + 20)
    name = text[start:close] if close >= 0 else ""
    bare = name.removesuffix("*")
    if bare not in (*_ONE_ROW, *_ROWS):
        return None
    numbered = bare == name and bare not in _NUMBERED_LESS
    return _until(text, bare, numbered, close + 1, f"\\end{{{name}}}")


def _until(
    text: str, environment: str, numbered: bool, start: int, closing: str
) -> tuple[_Display | None, int]:
    end = text.find(closing, start)
    if end < 0:
        return None, len(text)
    return _Display(environment, numbered, text[start:end], start), end + len(closing)


_CONTINUES = ("=", "<", ">", "+", "-", "\\le", "\\ge", "\\times", "\\cdot", "\\approx", "\\equiv")
_DROPPED = ("\\nonumber", "\\notag", "\\displaystyle", "\\hspace", "\\vspace", "\\allowbreak")
_LEADING = re.compile(r"(?:\s|~|\{\}|\\[,;:! ]|\\q?quad(?![A-Za-z]))+")
"""Spaces at the beginning of a row."""
_TAKES_ARGUMENT = ("\\hspace", "\\vspace", "\\label", "\\tag")
_MOST_LABEL = 200
_MOST_CONTENT = 20_000
"""Characters of a display that is taken apart; nobody prints a longer one."""
_LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(frozen=True)
class Equation:
    """One displayed equation: LaTeX without tags and alignment, the number printed beside it if
    there is one, its label, and the line where it begins.
    """

    latex: str
    number: str | None
    label: str | None
    line: int


@dataclass(frozen=True)
class _Row:
    latex: str
    tag: str | None
    label: str | None
    unnumbered: bool
    offset: int


def equations(text: str) -> Iterator[Equation]:
    """All displayed equations of a text without comments, numbered as LaTeX would without sections
    in the numbers.
    """
    counter, letter, inside = 0, 0, False
    line, counted = 1, 0
    for found in _displays(text):
        if isinstance(found, _Mark):
            inside, letter = found.opens, 0
            counter += 1 if found.opens else 0
            continue
        for row in _joined(_rows(found)):
            number = row.tag
            if number is None and found.numbered and not row.unnumbered:
                counter, letter = (counter, letter + 1) if inside else (counter + 1, 0)
                number = f"{counter}{_LETTERS[(letter - 1) % 26] if inside else ''}"
            latex = " ".join(row.latex.split()).rstrip(" .,;")
            if latex:
                line += text.count("\n", counted, row.offset)
                counted = row.offset
                yield Equation(latex, number, row.label, line)


def _rows(display: _Display) -> Iterator[_Row]:
    content = display.content
    if len(content) > _MOST_CONTENT:
        yield _Row(content[:_MOST_CONTENT], None, None, False, display.offset)
        return
    if display.environment == "alignat" and content.startswith("{"):
        content = " " * (end := group_end(content, 0) or 0) + content[end:]
    pieces = list(_split(content))
    if display.environment not in _ROWS:
        joined = " ".join(piece for piece, _ in pieces)
        pieces = [(joined, pieces[0][1])]
    for piece, offset in pieces:
        leading = len(piece) - len(piece.lstrip())
        yield _row(piece, display.offset + offset + leading)


def _split(content: str) -> Iterator[tuple[str, int]]:
    """Rows between `\\\\` outside of inner environments and braces, without alignment marks."""
    start, position, depth = 0, 0, 0
    kept: list[str] = []
    while position < len(content):
        character = content[position]
        if character == "\\":
            step = 2
            if content.startswith("\\begin{", position):
                depth += 1
            elif content.startswith("\\end{", position):
                depth -= 1
            elif content.startswith("\\\\", position) and depth == 0:
                yield "".join(kept), start
                position = start = _after_break(content, position + 2)
                kept = []
                continue
            kept.append(content[position : position + step])
            position += step
            continue
        if character in "{}":
            depth += 1 if character == "{" else -1
        kept.append(" " if character == "&" and depth == 0 else character)
        position += 1
    yield "".join(kept), start


def _after_break(content: str, position: int) -> int:
    """The position after `\\\\`, its star and its optional distance."""
    if content.startswith("*", position):
        position += 1
    if content.startswith("[", position):
        close = content.find("]", position, position + 20)
        position = close + 1 if close >= 0 else position
    return position


def _row(piece: str, offset: int) -> _Row:
    """One row without what only numbers or spaces it."""
    kept: list[str] = []
    said: dict[str, str] = {}
    dropped: set[str] = set()
    position = 0
    while position < len(piece):
        command = next(
            (c for c in (*_DROPPED, "\\label", "\\tag") if _is_at(piece, c, position)), ""
        )
        if not command:
            kept.append(piece[position : position + (2 if piece[position] == "\\" else 1)])
            position += len(kept[-1])
            continue
        dropped.add(command)
        position += len(command)
        position += piece[position : position + 1] == "*"
        end = (
            group_end(piece, position, _MOST_LABEL)
            if piece[position : position + 1] == "{"
            else None
        )
        if command in _TAKES_ARGUMENT and end is not None:
            said[command] = piece[position + 1 : end - 1].strip()
            position = end
    unnumbered = bool(dropped & {"\\nonumber", "\\notag"})
    return _Row("".join(kept), said.get("\\tag"), said.get("\\label"), unnumbered, offset)


def _is_at(text: str, command: str, position: int) -> bool:
    if not text.startswith(command, position):
        return False
    following = text[position + len(command) : position + len(command) + 1]
    return not (following.isascii() and following.isalpha())


def _joined(rows: Iterable[_Row]) -> Iterator[_Row]:
    """Rows that begin with a relation or an operator continue the one before."""
    waiting: _Row | None = None
    for row in rows:
        leading = _LEADING.match(row.latex)
        text = row.latex[leading.end() if leading else 0 :].rstrip()
        continues = text.startswith(_CONTINUES) or not text
        if waiting is not None and continues:
            waiting = _Row(
                f"{waiting.latex} {text}",
                waiting.tag or row.tag,
                waiting.label or row.label,
                waiting.unnumbered and row.unnumbered,
                waiting.offset,
            )
            continue
        if waiting is not None:
            yield waiting
        waiting = row
    if waiting is not None:
        yield waiting
