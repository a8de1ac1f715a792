"""Conditions on sizes behind a formula: `\\quad (0 \\leq n_b < n)`."""

from __future__ import annotations

from gainproof.verify.judge.matrices.notation import RELATIONS, WIDE
from gainproof.verify.judge.matrices.printed_names import skip_blanks
from gainproof.verify.judge.matrices.size import Sizes
from gainproof.verify.judge.matrices.size_text import read_size
from gainproof.verify.judge.matrices.tree import Bound
from gainproof.verify.judge.reader.alphabet import command_at
from gainproof.verify.judge.reader.errors import ReaderError


def split_bounds(text: str, sizes: Sizes) -> tuple[str, tuple[Bound, ...]]:
    """The formula in front of a wide blank outside all brackets, and the bounds behind it."""
    depth, position, opened = 0, 0, None
    while position < len(text):
        character = text[position]
        command = command_at(text, position) if character == "\\" else character
        if command in ("(", "[", "{", "\\begin"):
            depth += 1
        elif command in (")", "]", "}", "\\end"):
            depth -= 1
        elif command in WIDE and depth == 0:
            opened = position
            break
        position += len(command)
    if opened is None:
        return text, ()
    inner = text[opened:]
    while (start := skip_blanks(inner, 0)) or inner.startswith(WIDE):
        inner = inner[start:]
        if inner.startswith(WIDE):
            inner = inner[len(command_at(inner, 0)) :]
    body = inner.rstrip().rstrip(".,")
    if not (body.startswith("(") and body.endswith(")")):
        raise ReaderError("conditions on sizes stand in parentheses", text, opened)
    return text[:opened], _bounds(body[1:-1], sizes, text, opened)


def _bounds(body: str, sizes: Sizes, text: str, place: int) -> tuple[Bound, ...]:
    parts: list[str] = [""]
    operators: list[str] = []
    position = 0
    while position < len(body):
        command = command_at(body, position) if body[position] == "\\" else body[position]
        if command in RELATIONS:
            operators.append(RELATIONS[command])
            parts.append("")
        else:
            parts[-1] += command
        position += len(command)
    if not operators:
        raise ReaderError("a comparison of sizes is wanted", text, place)
    try:
        values = [read_size(part, sizes, may_be_negative=True) for part in parts]
    except ReaderError as error:
        raise ReaderError(error.problem, text, place, error.token, error.nearest) from error
    found = []
    for left, operator, right in zip(values, operators, values[1:], strict=False):
        if operator in (">", ">="):
            left, right = right, left
        found.append(Bound(left, right, operator in ("<", ">")))
        if operator == "=":
            found.append(Bound(right, left, False))
    return tuple(found)
