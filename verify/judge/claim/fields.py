"""Fields of a TOML table: each of its type, none missing, none that nobody knows."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

from gainproof.verify.judge.claim.errors import ClaimFileError, FileText

MOST_TEXT = 4000
UNSAID = "TODO"
"""What a draft has in place of everything that its user has to say."""
SIMILARITY = 0.6
"""How alike two names must be, from 0 to 1, for one to be suggested in place of the other."""


class Fields:
    """One table with fields of the names `known`; another name is an error that is noted first, so
    that a misspelt key is reported before the one it was meant to be.

    `where` names the table in messages, `line` is its place in the file if known.
    """

    def __init__(
        self,
        text: FileText,
        where: str,
        table: object,
        known: Sequence[str],
        line: int | None = None,
    ) -> None:
        if not isinstance(table, Mapping):
            raise text.error(where, f"a table is wanted, not {kind_of(table)}", line)
        self.text = text
        self.where = where
        self.line = line
        self._table = table
        self._misspelt: set[str] = set()
        for field in table:
            if field not in known:
                shown = field[:80]
                hint = nearest_hint(shown, known)
                self._misspelt.update(hint.split()[-1:])
                text.note(self.fail(shown, f"this field is not known{hint}"))

    def fail(self, field: str, problem: str) -> ClaimFileError:
        """The error to raise about `field`; that it is missing follows from a misspelt name."""
        where = f"{self.where}.{field}" if field else self.where
        line = self.text.line_in_table(field, self.line) or self.line
        error = self.text.error(where, problem, line)
        error.follows = field in self._misspelt
        return error

    def has(self, field: str) -> bool:
        """Whether the field is there."""
        return field in self._table

    def given(self) -> tuple[str, ...]:
        """The fields that are there, in their order."""
        return tuple(self._table)

    def take(self, field: str) -> Any:
        """The value as it is, or None."""
        return self._table.get(field)

    def text_or_none(self, field: str) -> str | None:
        """A text of reasonable length, or None where the field is missing."""
        value = self.take(field)
        if value is None:
            return None
        if not isinstance(value, str):
            raise self.fail(field, f"a text is wanted, not {kind_of(value)}")
        if len(value) > MOST_TEXT:
            raise self.fail(field, f"{len(value)} characters, but at most {MOST_TEXT} are read")
        if not value.strip():
            raise self.fail(field, "an empty text")
        if value == UNSAID:
            raise self.fail(field, f"still marked {UNSAID}: say it here")
        return value

    def required_text(self, field: str) -> str:
        """A text that must be there."""
        value = self.text_or_none(field)
        if value is None:
            raise self._missing(field)
        return value

    def choice(self, field: str, choices: tuple[str, ...], default: str | None = None) -> str:
        """One of `choices`; with a `default` the field may be missing."""
        value = self.text_or_none(field)
        if value is None:
            if default is None:
                raise self._missing(field)
            return default
        if value not in choices:
            hint = nearest_hint(value, choices)
            raise self.fail(field, f"{value!r} is none of {', '.join(choices)}{hint}")
        return value

    def whole_number(self, field: str, lowest: int, highest: int) -> int | None:
        """A whole number in the range, or None where the field is missing."""
        value = self.take(field)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, int):
            raise self.fail(field, f"a whole number is wanted, not {kind_of(value)}")
        if not lowest <= value <= highest:
            raise self.fail(field, f"wanted {lowest} to {highest}, but it is outside")
        return value

    def flag(self, field: str) -> bool:
        """True or false; false where the field is missing."""
        value = self.take(field)
        if value is None:
            return False
        if not isinstance(value, bool):
            raise self.fail(field, f"true or false is wanted, not {kind_of(value)}")
        return value

    def texts(self, field: str, most: int) -> tuple[str, ...]:
        """A list of texts, empty where the field is missing."""
        value = self.take(field)
        if value is None:
            return ()
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise self.fail(field, "a list of texts is wanted")
        if len(value) > most or any(len(item) > MOST_TEXT for item in value):
            raise self.fail(field, f"more than {most} texts, or one beyond {MOST_TEXT} characters")
        if UNSAID in value:
            raise self.fail(field, f"still marked {UNSAID}: say it here")
        return tuple(value)

    def _missing(self, field: str) -> ClaimFileError:
        return self.fail(field, "this field is missing")


def kind_of(value: object) -> str:
    """A TOML value's type in words, without its content."""
    names = {str: "a text", bool: "true or false", int: "a number", Decimal: "a number"}
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list):
        return "a list"
    return names.get(type(value), "a date or time")


def nearest_hint(value: str, known: Sequence[str]) -> str:
    """`; the nearest is ...`, or nothing."""
    close = difflib.get_close_matches(value[:80], known, n=1, cutoff=SIMILARITY)
    return f"; the nearest is {close[0]}" if close else ""
