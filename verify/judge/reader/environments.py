"""`\\begin` and `\\end`: matrices, and what stands round all lines of a formula."""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import DIGITS, is_letter, skip_space
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.line_end import skip_idle
from gainproof.verify.judge.reader.token_scan import Scanned
from gainproof.verify.judge.reader.words import CASES, LINE_ENVIRONMENTS, MATRIX_ENVIRONMENTS

_MOST_CHARACTERS = 40


class Environments:
    """The environments of lines that are open in one text, and how many matrices."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.open: list[str] = []
        self.matrices = 0

    def has_columns(self) -> bool:
        """Whether a mark `&` means anything here."""
        return bool(self.open) or self.matrices > 0

    def scan(self, start: int, end: int, begins: bool, nothing_before: bool) -> Scanned:
        """What the `\\begin` or `\\end` at `start`, whose word ends at `end`, opens or closes: a
        matrix, or with an empty kind lines, whose end is given.
        """
        text = self.text
        name, after = self._name(start, end)
        word = text[start:end]
        if name in MATRIX_ENVIRONMENTS:
            if name == "array" and begins:
                after = _after_columns(text, after)
            self.matrices += 1 if begins else -1
            return Scanned("MATRIX_OPEN" if begins else "MATRIX_CLOSE", name, after)
        if name == CASES:
            self.matrices += 1 if begins else -1
            return Scanned("CASES_OPEN" if begins else "CASES_CLOSE", name, after)
        if name not in LINE_ENVIRONMENTS:
            near = nearest_names(name, MATRIX_ENVIRONMENTS | LINE_ENVIRONMENTS | {CASES})
            problem = f"{word}{{{name}}} is not known"
            raise ReaderError(problem, text, start, word, near)
        if begins:
            if not nothing_before:
                raise ReaderError(f"{name} must stand round the whole formula", text, start, word)
            self.open.append(name)
            return Scanned("", name, after)
        if not self.open or self.open.pop() != name:
            raise ReaderError(f"\\end{{{name}}} was never begun", text, start, word)
        rest = skip_idle(text, after)
        if rest < len(text) and not text.startswith("\\end", rest):
            raise ReaderError(f"{name} must stand round the whole formula", text, start, word)
        return Scanned("", name, after)

    def refuse_open(self) -> None:
        """ReaderError if lines were begun and never ended."""
        if self.open:
            problem = f"\\begin{{{self.open[-1]}}} is never ended"
            raise ReaderError(problem, self.text, len(self.text), "\\begin")

    def _name(self, start: int, end: int) -> tuple[str, int]:
        opening = skip_space(self.text, end)
        closing = self.text.find("}", opening, opening + _MOST_CHARACTERS)
        name = self.text[opening + 1 : closing].strip()
        letters = name.removesuffix("*")
        if (
            self.text[opening : opening + 1] != "{"
            or closing < 0
            or not all(map(is_letter, letters))
        ):
            word = self.text[start:end]
            raise ReaderError(f"{word} needs the name of an environment", self.text, start, word)
        return name, closing + 1


def _after_columns(text: str, position: int) -> int:
    """The end of `{cc|c}`, which says how columns are set."""
    opening = skip_space(text, position)
    closing = text.find("}", opening, opening + _MOST_CHARACTERS)
    known = set(text[opening + 1 : max(closing, 0)]) <= set("lcr| ")
    if text[opening : opening + 1] != "{" or closing < 0 or not known:
        raise ReaderError("array needs its columns, such as {cc}", text, position, "array")
    return closing + 1


def line_break_end(text: str, position: int) -> int:
    """The end of `\\\\` with a distance such as `[2pt]` after it."""
    if text[position : position + 1] == "*":
        position += 1
    closing = text.find("]", position, position + 12)
    inner = text[position + 1 : max(closing, 0)]
    if text[position : position + 1] == "[" and inner[-2:] in ("pt", "em", "ex", "mm", "cm"):
        number = inner[:-2].strip().removeprefix("-")
        if number and all(c in DIGITS or c == "." for c in number):
            return closing + 1
    return position
