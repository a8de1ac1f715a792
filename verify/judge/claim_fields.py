"""Fields of a TOML table taken one by one: each of its type, none missing, none left over."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.claim_errors import FileText

MOST_TEXT = 4000


class Fields:
    """One table. `where` names it in messages, `line` is its place in the file if known."""

    def __init__(self, text: FileText, where: str, table: object, line: int | None = None) -> None:
        if not isinstance(table, Mapping):
            raise text.error(where, f"a table is wanted, not {kind_of(table)}", line)
        self.text = text
        self.where = where
        self.line = line
        self._rest: dict[str, Any] = dict(table)
        self._known: list[str] = []

    def fail(self, field: str, problem: str) -> Exception:
        """The error to raise about `field`."""
        where = f"{self.where}.{field}" if field else self.where
        return self.text.error(where, problem, self.line)

    def has(self, field: str) -> bool:
        """Whether the field is there and not taken yet."""
        return field in self._rest

    def take(self, field: str) -> Any:
        """The value as it is, or None."""
        self._known.append(field)
        return self._rest.pop(field, None)

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
        return tuple(value)

    def finish(self) -> None:
        """Refuses whatever was not taken."""
        for field in self._rest:
            shown = field[:80]
            hint = nearest_hint(shown, self._known)
            raise self.fail(shown, f"this field is not known{hint}")

    def _missing(self, field: str) -> Exception:
        return self.fail(field, "this field is missing")


def kind_of(value: object) -> str:
    """A TOML value's type in words, without its content."""
    names = {str: "a text", bool: "true or false", int: "a number", float: "a number"}
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list):
        return "a list"
    return names.get(type(value), "a date or time")


def nearest_hint(value: str, known: tuple[str, ...] | list[str]) -> str:
    """`; the nearest is ...`, or nothing."""
    close = difflib.get_close_matches(value[:80], known, n=1, cutoff=0.5)
    return f"; the nearest is {close[0]}" if close else ""
