"""What is wrong with a claim file, and where; and where in its text something stands."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable
from typing import Any, TypeVar

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.plain_names import plain_name
from gainproof.verify.judge.reader.printed_names import names_in

MOST_FOUND = 200
"""Errors of one file after which no more are looked for."""
MOST_LINES = 4_000
"""Lines of a file that are looked through for the place of a formula."""
Made = TypeVar("Made")
_HEADERS = ("[[claims]]", "[settings", "[symbols", "[source]")


class ClaimFileError(ValueError):
    """A claim file that is not accepted.

    `path` names the file, `where` the table and field (`claims.table1-2.latex`), `line` and
    `column` count from 1 and are None where TOML does not tell them; `token` and `nearest` are
    those of a formula's error. `others` are the further errors of the file. One that `follows` may
    be no more than what another error leads to, and is not told.
    """

    others: tuple[ClaimFileError, ...] = ()
    follows = False

    def __init__(
        self,
        path: str,
        where: str,
        problem: str,
        line: int | None = None,
        column: int | None = None,
        token: str = "",
        nearest: tuple[str, ...] = (),
    ) -> None:
        self.path = path
        self.where = where
        self.problem = problem
        self.line = line
        self.column = column
        self.token = token
        self.nearest = nearest
        place = path
        if line is not None:
            place += f", line {line}" + (f", column {column}" if column is not None else "")
        super().__init__(f"{place}: {where}: {problem}" if where else f"{place}: {problem}")

    def to_json(self) -> dict[str, Any]:
        """As plain data: `file`, `line` and `column` from 1 or None, `where`, `message`, `text`,
        which is all of this in words, with a mark under the place in a formula, and of a formula
        the `token` at which the reader stopped, with the declared names `nearest` to it.
        """
        return {
            "file": self.path,
            "line": self.line,
            "column": self.column,
            "where": self.where,
            "message": self.problem.partition("\n")[0],
            "text": str(self),
            "token": self.token,
            "nearest": list(self.nearest),
        }


class TooManyError(Exception):
    """So many errors were found that reading ends."""


class FileText:
    """The text of a claim file, which knows the lines that `tomllib` forgets, and what its source
    means by `\\log` (see `SourceRecord`).

    It gathers the errors that are `found`, so that what stands beside one is read too: `noted`
    counts them all. In `doubtful` are names whose declaration could not be understood: what is
    wrong with a formula that holds one may follow from that.
    """

    def __init__(self, path: str, text: str, logarithm: int | None = None) -> None:
        self.path = path
        self.logarithm = logarithm
        self.found: list[ClaimFileError] = []
        self.noted = 0
        self.doubtful: set[str] = set()
        self._lines = text.split("\n")
        # looked up once for every symbol and claim, hence indexed once
        self._keys: dict[str, list[int]] = {}
        for number, line in enumerate(self._lines, start=1):
            key = line.partition("=")[0].strip()
            bare = key[1:-1] if key[:1] in ("'", '"') and key[-1:] == key[:1] else key
            self._keys.setdefault(bare, []).append(number)

    def note(self, error: ClaimFileError) -> None:
        """Keep an error, to go on behind it. Raises TooManyError."""
        self.noted += 1
        if not (error.follows and self.found):  # one without a cause that is told is told itself
            self.found.append(error)
        if len(self.found) >= MOST_FOUND:
            raise TooManyError

    def attempt(self, make: Callable[[], Made], otherwise: Made) -> Made:
        """What `make` gives, or `otherwise` where it finds an error, which is noted."""
        try:
            return make()
        except ClaimFileError as error:
            self.note(error)
            return otherwise

    def unsaid(self, make: Callable[[], Made]) -> Made | None:
        """What `make` gives, or None where it finds an error, of which nothing is said."""
        noted, found = self.noted, len(self.found)
        made = self.attempt(make, None)
        good = self.noted == noted
        self.noted = noted
        del self.found[found:]
        return made if good else None

    def refusal(self) -> ClaimFileError:
        """The first error that was found, with the others, in the order of the file."""
        first, *others = self.in_order()
        first.others = tuple(others)
        return first

    def in_order(self) -> list[ClaimFileError]:
        """The errors that were found by their lines, those without one last."""
        return sorted(self.found, key=lambda error: (error.line is None, error.line or 0))

    def doubted(self, error: ClaimFileError, text: str, *, plain: bool = False) -> ClaimFileError:
        """The error, which follows where a doubtful name is one of the formula, in LaTeX or, if
        `plain`, as typed; not where it is a part of another: `a` in `\frac`.
        """
        if plain:
            names = map(plain_name, self.doubtful)
            error.follows = any(
                re.search(rf"(?<![\w{{]){re.escape(name)}(?![\w'])", text) for name in names
            )
        else:
            longest_run = max(map(len, self.doubtful), default=1)
            error.follows = not self.doubtful.isdisjoint(names_in(text, longest_run))
        return error

    def line_of_key(self, key: str, start: int = 1) -> int | None:
        """The first line from `start` on that begins with the key, bare or quoted."""
        numbers = self._keys.get(key, [])
        position = bisect_left(numbers, start)
        return numbers[position] if position < len(numbers) else None

    def line_in_table(self, key: str, start: int | None) -> int | None:
        """The line of a key in the table of line `start`; None if it has no line of its own."""
        if start is None:
            return self._line_of_header(key) if key else None
        number = self.line_of_key(key, start) if key else None
        if number is None:
            return None
        between = self._lines[start:number]
        return None if any(line.startswith("[") for line in between) else number

    def _line_of_header(self, name: str) -> int | None:
        """The first line with a key of the file's own table, or a table of this name in it."""
        for number, line in enumerate(self._lines, start=1):
            bare = line.lstrip("[ ")
            if bare.startswith(name) and bare[len(name) :].lstrip()[:1] in ("]", ".", "="):
                return number
        return None

    def line_of_identifier(self, value: str, start: int = 1) -> int | None:
        """The first line from `start` on that reads `id = "value"`, in either kind of quotes."""
        numbers = self._keys.get("id", [])
        for number in numbers[bisect_left(numbers, start) :]:
            right = self._lines[number - 1].partition("=")[2].strip()
            if right.startswith((f"'{value}'", f'"{value}"')):
                return number
        return None

    def line_of_table(self, name: str) -> int | None:
        """The line of `[name]`."""
        return self.line_of_key(f"[{name}]")

    def place_of(self, value: str, start: int) -> tuple[int, int] | None:
        """Line and column where the first line of `value` stands, in the table of line `start`."""
        first = value.lstrip("\n").split("\n", 1)[0]
        for number in range(start, min(len(self._lines), start + MOST_LINES) + 1):
            line = self._lines[number - 1]
            if number > start and line.startswith(_HEADERS):
                return None
            column = line.find(first) if first else -1
            if column >= 0:
                return number, column + 1
        return None

    def error(self, where: str, problem: str, line: int | None = None) -> ClaimFileError:
        """The error to raise for `where`."""
        return ClaimFileError(self.path, where, problem, line)

    def formula_error(
        self, where: str, value: str, error: ReaderError, line: int | None
    ) -> ClaimFileError:
        """A reader's error moved to its place in the file, if the formula stands there."""
        plain = where.endswith(".plain")
        return self.doubted(self._moved(where, value, error, line), value, plain=plain)

    def _moved(
        self, where: str, value: str, error: ReaderError, line: int | None
    ) -> ClaimFileError:
        place = self.place_of(value, line) if line is not None else None
        if place is None:
            shown = f"in the formula, {error}"
            return ClaimFileError(
                self.path, where, shown, line, token=error.token, nearest=error.nearest
            )
        skipped = len(value) - len(value.lstrip("\n"))
        row = place[0] + error.line - 1 - skipped
        column = error.column + (place[1] - 1 if error.line - skipped == 1 else 0)
        hint = f"; the nearest declared name is {error.nearest[0]}" if error.nearest else ""
        problem = f"{error.problem}{hint}\n{error.caret}"
        return ClaimFileError(self.path, where, problem, row, column, error.token, error.nearest)
