"""Numbers and names as they may stand in a cell or an option."""

from __future__ import annotations

import re
import unicodedata

PLAIN = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
UNREADABLE = {"Cc", "Cf", "Cs", "Zl", "Zp"}
"""Categories of what a page cannot show: controls, marks without width, ends of lines."""


def decimal(text: str) -> float:
    """The number of plain decimal digits, as -1.5e3, or not finite (inf, nan). ValueError."""
    value = float(text)
    if abs(value) < float("inf") and not PLAIN.fullmatch(text.strip(" \t")):
        raise ValueError(f"no plain decimal number: {text!r}")
    return value


def name(text: str) -> str:
    """Composed (NFC), so that the same name in two files is one. ValueError: begins with #, which
    begins a comment; holds what a page cannot show.
    """
    if text.startswith("#"):
        raise ValueError(f"a name does not begin with #, which begins a comment, got {text!r}")
    if any(unicodedata.category(character) in UNREADABLE for character in text):
        raise ValueError(f"a name holds no control characters, got {text!r}")
    return unicodedata.normalize("NFC", text)
