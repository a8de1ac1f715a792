"""Which characters a formula may hold: printable ASCII and seven signs. Look-alikes are refused
with their code point and what to write instead.
"""

from __future__ import annotations

import unicodedata

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_CHARACTERS
from gainproof.verify.judge.reader.tokens import MARKS

SIGNS = frozenset(mark for mark in MARKS if not mark.isascii())
"""Signs beyond ASCII that have one meaning and no double."""

# fmt: off
_MEANT = {
    # Cyrillic and Greek letters that print like Latin ones
    "\u0430": "a", "\u0435": "e", "\u043e": "o", "\u0440": "p", "\u0441": "c", "\u0443": "y",
    "\u0445": "x", "\u0456": "i", "\u0458": "j", "\u0455": "s", "\u04bb": "h", "\u0501": "d",
    "\u051b": "q", "\u051d": "w", "\u0410": "A", "\u0412": "B", "\u0415": "E", "\u041a": "K",
    "\u041c": "M", "\u041d": "H", "\u041e": "O", "\u0420": "P", "\u0421": "C", "\u0422": "T",
    "\u0425": "X", "\u0406": "I", "\u0408": "J", "\u0405": "S", "\u0391": "A", "\u0392": "B",
    "\u0395": "E", "\u0396": "Z", "\u0397": "H", "\u0399": "I", "\u039a": "K", "\u039c": "M",
    "\u039d": "N", "\u039f": "O", "\u03a1": "P", "\u03a4": "T", "\u03a5": "Y", "\u03a7": "X",
    "\u03bf": "o", "\u03f2": "c", "\u0131": "i", "\u0237": "j", "\u0261": "g", "\u0251": "a",
    # signs
    "\u2212": "-", "\u2010": "-", "\u2011": "-", "\u2012": "-", "\u2013": "-", "\u2014": "-",
    "\u00b7": "\\cdot", "\u22c5": "\\cdot", "\u2219": "\\cdot", "\u2022": "\\cdot",
    "\u00d7": "\\times", "\u2217": "*", "\u2215": "/", "\u2044": "/", "\u00f7": "/",
    "\u2032": "'", "\u2019": "'", "\u02b9": "'", "\u221e": "\\infty", "\u221a": "\\sqrt",
    "\u2211": "\\sum", "\u220f": "\\prod", "\u222b": "\\int", "\u2202": "\\partial",
    "\u00b1": "\\pm", "\u2213": "\\mp", "\u2223": "|", "\u2236": ":", "\u2208": "\\in",
    "\u2a7d": "\\le", "\u2a7e": "\\ge", "\u2266": "\\le", "\u2267": "\\ge", "\u2243": "\\simeq",
    "\u2245": "\\cong", "\u223c": "\\sim", "\u221d": "\\propto", "\u2297": "\\otimes",
    "\u2261": "\\equiv", "\u2026": "\\ldots", "\u22ef": "\\cdots", "\u27e8": "(", "\u27e9": ")",
    "\u00b5": "\\mu", "\u2206": "\\Delta", "\u2126": "\\Omega", "\u03f5": "\\epsilon",
}
# fmt: on
_GREEK_WORD = "GREEK "


def refuse_characters(text: str) -> None:
    """ReaderError if `text` is too long or holds a character that is neither printable ASCII, tab,
    newline nor one of SIGNS.
    """
    if len(text) > MOST_CHARACTERS:
        problem = f"{len(text)} characters, but a formula has at most {MOST_CHARACTERS}"
        raise ReaderError(problem, text, MOST_CHARACTERS)
    for position, character in enumerate(text):
        if not (" " <= character <= "~" or character in "\n\t" or character in SIGNS):
            name = unicodedata.name(character, "no name")
            code = f"U+{ord(character):04X}"
            meant = meant_character(character)
            hint = f": write {meant}" if meant else ""
            problem = f"the character {code} ({name}) is not LaTeX written in ASCII{hint}"
            raise ReaderError(problem, text, position, code)


def meant_character(character: str) -> str | None:
    """What the writer of a character beyond ASCII meant, as LaTeX; None where nobody knows."""
    if character in _MEANT:
        return _MEANT[character]
    plain = unicodedata.normalize("NFKC", character)
    if plain != character and len(plain) == 1:
        form = unicodedata.decomposition(character).partition(" ")[0]
        shift = {"<super>": "^", "<sub>": "_"}.get(form, "")
        meant = plain if plain.isascii() and plain.isprintable() else meant_character(plain)
        return None if meant is None else shift + meant
    return _greek(unicodedata.name(character, ""))


def _greek(name: str) -> str | None:
    """`\\alpha` for GREEK SMALL LETTER ALPHA."""
    case, _, letter = name.removeprefix(_GREEK_WORD).partition(" LETTER ")
    letter = {"FINAL SIGMA": "VARSIGMA", "LAMDA": "LAMBDA"}.get(letter, letter)
    if not name.startswith(_GREEK_WORD) or not letter.isalpha() or case not in ("SMALL", "CAPITAL"):
        return None
    return "\\" + (letter.lower() if case == "SMALL" else letter.capitalize())
