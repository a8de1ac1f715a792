"""What is wrong with a claim file, and where; and where in its text something stands."""

from __future__ import annotations

from gainproof.verify.judge.reader.errors import ReaderError


class ClaimFileError(ValueError):
    """A claim file that is not accepted.

    `path` names the file, `where` the table and field (`claims.table1-2.latex`), `line` and `column` count from 1 and
    are None where TOML does not tell them; `token` and `nearest` are those of a formula's error.
    """

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


class FileText:
    """The text of a claim file, which knows the lines that `tomllib` forgets."""

    def __init__(self, path: str, text: str) -> None:
        self.path = path
        self._lines = text.split("\n")

    def line_of_assignment(self, key: str, value: str, start: int = 1) -> int | None:
        """The first line from `start` on that reads `key = "value"`, in either kind of quotes."""
        for number in range(start - 1, len(self._lines)):
            left, equals, right = self._lines[number].partition("=")
            if equals and left.strip() == key and right.strip()[1:].startswith(value):
                rest = right.strip()[1 + len(value) :]
                if rest[:1] in ("'", '"') and right.strip()[:1] == rest[:1]:
                    return number + 1
        return None

    def line_of_key(self, key: str, start: int = 1) -> int | None:
        """The first line from `start` on that begins with the key, bare or quoted."""
        forms = (key, f"'{key}'", f'"{key}"')
        for number in range(start - 1, len(self._lines)):
            left, equals, _ = self._lines[number].partition("=")
            if equals and left.strip() in forms:
                return number + 1
        return None

    def line_of_table(self, name: str) -> int | None:
        """The line of `[name]`."""
        for number, line in enumerate(self._lines):
            if line.strip().split("#")[0].strip() == f"[{name}]":
                return number + 1
        return None

    def place_of(self, value: str, start: int = 1) -> tuple[int, int] | None:
        """Line and column where the first line of `value` stands literally, from line `start` on."""
        first = value.lstrip("\n").split("\n", 1)[0]
        for number in range(start - 1, len(self._lines)):
            column = self._lines[number].find(first) if first else -1
            if column >= 0:
                return number + 1, column + 1
        return None

    def error(self, where: str, problem: str, line: int | None = None) -> ClaimFileError:
        """The error to raise for `where`."""
        return ClaimFileError(self.path, where, problem, line)

    def formula_error(
        self, where: str, value: str, error: ReaderError, line: int | None
    ) -> ClaimFileError:
        """A reader's error moved to its place in the file, if the formula stands there literally."""
        place = self.place_of(value, line or 1)
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
