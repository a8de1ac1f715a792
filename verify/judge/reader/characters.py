"""Which characters a formula may hold: printable ASCII. Look-alikes are refused with their code
point.
"""

from __future__ import annotations

import unicodedata

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_CHARACTERS


def refuse_characters(text: str) -> None:
    """ReaderError if `text` is too long or holds a character beyond printable ASCII, tab and
    newline.
    """
    if len(text) > MOST_CHARACTERS:
        problem = f"{len(text)} characters, but a formula has at most {MOST_CHARACTERS}"
        raise ReaderError(problem, text, MOST_CHARACTERS)
    for position, character in enumerate(text):
        if not (" " <= character <= "~" or character in "\n\t"):
            name = unicodedata.name(character, "no name")
            code = f"U+{ord(character):04X}"
            problem = f"the character {code} ({name}) is not LaTeX written in ASCII"
            raise ReaderError(problem, text, position, code)
