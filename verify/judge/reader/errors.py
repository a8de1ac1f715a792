"""The reader's one error type, which says where and what was wanted."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

_MOST_SHOWN = 100


class ReaderError(ValueError):
    """A formula that the reader does not accept.

    `text` is the formula, `line` and `column` count from 1 within it; `token` is what was met
    there, `nearest` the declared names closest to it (best first), `caret` the line of the formula
    with a mark under the place.
    """

    def __init__(
        self,
        problem: str,
        text: str,
        position: int,
        token: str = "",
        nearest: tuple[str, ...] = (),
    ) -> None:
        before = text[:position]
        self.problem = problem
        self.text = text
        self.position = position
        self.line = before.count("\n") + 1
        self.column = position - (before.rfind("\n") + 1) + 1
        self.token = token
        self.nearest = nearest
        self.caret = _caret(text, position)
        hint = f"; the nearest declared name is {nearest[0]}" if nearest else ""
        super().__init__(f"line {self.line}, column {self.column}: {problem}{hint}\n{self.caret}")


def nearest_names(token: str, declared: Iterable[str]) -> tuple[str, ...]:
    """Up to three declared names that resemble `token`, best first."""
    return tuple(difflib.get_close_matches(token[:_MOST_SHOWN], sorted(declared), n=3, cutoff=0.6))


def _caret(text: str, position: int) -> str:
    """The line that holds `position`, cut to a readable width, and a caret below."""
    start = text.rfind("\n", 0, position) + 1
    end = text.find("\n", position)
    line = text[start:] if end < 0 else text[start:end]
    offset = position - start
    first = max(0, offset - _MOST_SHOWN // 2)
    shown = "".join(
        c if c.isascii() and c.isprintable() else "?" for c in line[first : first + _MOST_SHOWN]
    )
    return f"    {shown}\n    {' ' * (offset - first)}^"
