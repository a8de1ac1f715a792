"""What the user asked for and cannot have: one error type, with the nearest names."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

MOST_SUGGESTIONS = 3
SIMILARITY = 0.6
"""How alike two names must be, from 0 to 1, for one to be suggested in place of the other."""
LEAST_PART = 3
"""Characters of a name that is suggested where it is part of a longer one."""


class BadInputError(Exception):
    """Input that cannot be used; the message says what was wanted and what came. Exit status 2."""


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
