"""What the user asked for and cannot have: one error type, with the nearest names."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

MOST_TOLD = 50
"""Errors of one file that are told in words."""
MOST_SUGGESTIONS = 3
SIMILARITY = 0.6
"""How alike two names must be, from 0 to 1, for one to be suggested in place of the other."""
LEAST_PART = 3
"""Characters of a name that is suggested where it is part of a longer one."""


class BadInputError(Exception):
    """Input that cannot be used; the message says what was wanted and what came. Exit status 2.
    Where it is about places in a file, `errors` has them as plain data.
    """

    def __init__(self, message: str, errors: Sequence[Mapping[str, Any]] = ()) -> None:
        super().__init__(message)
        self.errors = tuple(errors)


def listed(errors: Sequence[Mapping[str, Any]]) -> str:
    """Errors of files in words, one below the other, the first `MOST_TOLD`, then how many more."""
    texts = [str(error["text"]) for error in errors[:MOST_TOLD]]
    more = len(errors) - MOST_TOLD
    return "\n".join([*texts, *([f"and {more} more"] if more > 0 else [])])


def harmless(text: str) -> str:
    """A message without signs that move a terminal's cursor or change its colours: names of files
    and options are quoted in it as they came.
    """
    return "".join(c if c.isprintable() or c in "\n\t" else ascii(c)[1:-1] for c in text)


def nearest(name: str, known: Iterable[str]) -> list[str]:
    """Up to three known names that resemble `name`, best first."""
    choices = sorted(set(known))
    folded = {choice.casefold().replace("_", "-"): choice for choice in choices}
    wanted = name.casefold().replace("_", "-")
    close = difflib.get_close_matches(wanted, list(folded), n=MOST_SUGGESTIONS, cutoff=SIMILARITY)
    is_part = len(wanted) >= LEAST_PART
    inside = [key for key in folded if is_part and wanted in key and key not in close]
    return [folded[key] for key in [*close, *inside][:MOST_SUGGESTIONS]]


def unknown_name(kind: str, name: str, known: Iterable[str]) -> BadInputError:
    """The error for a name that is not among `known`: the nearest ones, else where to find all."""
    choices = sorted(set(known))
    close = nearest(name, choices)
    if close:
        hint = f"nearest: {', '.join(close)}"
    elif choices and len(choices) <= 12:
        hint = f"known: {', '.join(choices)}"
    else:
        hint = "`gainproof list` shows them all"
    return BadInputError(f"no {kind} is called {name!r}; {hint}")
