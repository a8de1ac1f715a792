"""Formulas and conditions as people type them, brought into what the reader of claims reads."""

from __future__ import annotations

import contextlib
import re
import unicodedata
from collections.abc import Collection, Sequence
from dataclasses import dataclass

from gainproof.bad_input import BadInputError
from gainproof.verify.judge.claim.short_form import MARK, is_plain
from gainproof.verify.judge.claim.symbols_met import Met, symbols_met
from gainproof.verify.judge.claim.usual_letters import filter_meanings
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.characters import meant_character
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex import relations_to_latex
from gainproof.verify.judge.reader.names import canonical_token

MOST_CHARACTERS = 20_000
"""Of a formula; the reader has limits of its own below that."""
ONE_NAME = (r"\Delta t", r"\Delta T")
"""What is one name wherever it stands, and no product."""
STEP = "dt"
"""The same, but where there is an integral."""
_RELATION = re.compile(r"[=<>]|\\(?:leq?|geq?|approx|neq?|to|simeq|sim)\b")
_BEGINS_WITH_RELATION = re.compile(rf"\s*&?\s*(?:{_RELATION.pattern})")
_POWER = re.compile(r"\^\{([^{}]*)\}")
_MARKED = re.compile(
    r"(?:\\(?:hat|tilde|bar|mathbf)\{?)?\\?[A-Za-z]{1,40}\}?(?:_(?:\{[^{}]{0,40}\}|\w))?"
    rf"(?:{MARK.pattern}|\([-+]\))"
)
"""A name with the mark of what is predicted or updated: `P_k^-`, `\\hat{x}_k(+)`."""
_EULER = re.compile(r"(?<![A-Za-z\\_{])e(?![A-Za-z_'])")
_LOGARITHM = re.compile(r"\\log(?![A-Za-z]|\s*_)|(?<![A-Za-z\\])log(?=\s*\()")


@dataclass(frozen=True)
class Typed:
    """A formula that was read.

    Attributes
    ----------
    text : str
        As the reader reads it, in LaTeX or `plain` text.
    formula : Formula
        What it says.
    symbols : tuple of str
        Its symbols, in order of appearance.
    taken : tuple of (str, str)
        What was read in one of several ways: the part, and as what.
    """

    text: str
    plain: bool
    formula: Formula
    symbols: tuple[str, ...]
    taken: tuple[tuple[str, str], ...]


def typed(formula: str, said: Collection[str]) -> Typed:
    """Read a formula; `said` are the symbols of which the user says what they are. Raises
    BadInputError, with a mark under the place.
    """
    text = in_ascii(formula.strip())
    if not text:
        raise BadInputError("a formula is wanted, got an empty one")
    if len(text) > MOST_CHARACTERS:
        raise BadInputError(f"a formula of more than {MOST_CHARACTERS} characters")
    _refuse_several(text)
    plain = is_plain(text)
    if plain:
        text = _POWER.sub(r"^(\1)", text)
    met = symbols_met(text, plain=plain, known=_known(text, said))
    products = _products(met.symbols, said) if plain else ()
    for word in products:
        text = re.sub(rf"(?<![A-Za-z_]){word}(?![A-Za-z_])", f"({' '.join(word)})", text)
    if products:
        met = symbols_met(text, plain=plain, known=_known(text, said))
    taken = [(word, f"product {' '.join(word)}") for word in products]
    if "e" not in met.symbols and _EULER.search(text):
        taken.append(("e", "Euler's number"))
    if _LOGARITHM.search(text):
        taken.append(("log", "natural logarithm"))
    return Typed(text, plain, _read(met), met.symbols, tuple(taken))


def condition(text: str, option: str, said: Collection[str]) -> tuple[str, tuple[str, ...]]:
    """A condition or hypothesis in LaTeX, and its symbols. Raises BadInputError."""
    text = in_ascii(text.strip())
    plain = is_plain(text)
    met = symbols_met(text, plain=plain, known=_known(text, said))
    try:
        formula = _read(met)
    except BadInputError as error:
        raise BadInputError(f"--{option}: {error}") from None
    if "or" in met.symbols:
        raise BadInputError(f"--{option}: conditions hold together; `or` is not read")
    if not plain:
        return text, met.symbols
    reading = formula.readings[0]
    if reading.conditions:
        raise BadInputError(f"--{option}: a condition within a condition is not read")
    return relations_to_latex(reading.relations), met.symbols


def symbol_name(name: str) -> str:
    """The symbol that a user names, in LaTeX or as plain text. Raises BadInputError."""
    name = in_ascii(name.strip()).strip()
    if is_plain(name):
        met = symbols_met(f"{name} = 0", plain=True)
        if met.formula is not None and len(met.symbols) == 1:
            return met.symbols[0]
    try:
        return canonical_token(name)
    except ReaderError as error:
        raise BadInputError(f"--symbol {name!r}: {error.problem}") from None


def in_ascii(formula: str) -> str:
    """The formula with Greek letters, small digits and the minus sign as LaTeX has them. What looks
    like a Latin letter and is none stays, for the reader to refuse.
    """
    return "".join(map(_in_ascii, formula))


def _in_ascii(character: str) -> str:
    meant = None if character.isascii() else meant_character(character)
    if meant is None:
        return character
    if meant.startswith("\\") and "GREEK" in unicodedata.name(character, ""):
        return f"{meant} "
    return meant if meant[:1] in "^_-" and (meant == "-" or meant[1:].isdigit()) else character


def _read(met: Met) -> Formula:
    if met.formula is None:
        raise BadInputError(f"not read: {met.problem}\n{met.caret}")
    return met.formula


def _known(text: str, said: Collection[str]) -> list[str]:
    """Names of several letters that the reader would take for products."""
    usual = [*ONE_NAME, *([] if "\\int" in text or "integral" in text else [STEP])]
    for found in _MARKED.finditer(text):
        with contextlib.suppress(ReaderError):
            usual.append(canonical_token(found[0]))
    return [*said, *(name for name in dict.fromkeys(usual) if name not in said)]


def _refuse_several(text: str) -> None:
    """Raises BadInputError for lines that are formulas of their own: blanks join what they part."""
    lines = [line for line in text.split("\n") if _RELATION.search(line)]
    if any(not _BEGINS_WITH_RELATION.match(line) for line in lines[1:]):
        raise BadInputError("several formulas in lines below each other: ask for each by itself")


def _products(tokens: Sequence[str], said: Collection[str]) -> tuple[str, ...]:
    """Words of plain text that are meant as products: nobody said what they are, and each of their
    letters stands elsewhere too, alone or in another such word. `ab` beside a and b, not `vel`.
    """
    usual = filter_meanings(tokens)
    words = [
        token
        for token in tokens
        if re.fullmatch("[A-Za-z]{2,4}", token) and token not in said and token not in usual
    ]

    def elsewhere(letter: str, word: str) -> bool:
        return any(letter in other for other in tokens if other != word and len(other) < 5)

    return tuple(word for word in words if all(elsewhere(letter, word) for letter in word))
