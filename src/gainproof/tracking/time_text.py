"""Times as text."""

from __future__ import annotations


def time_text(time: float) -> str:
    """The fewest digits that come back as the same number, in s: those of a file in s, mostly."""
    return repr(time).removesuffix(".0")
