"""Characters that look like others are refused with their code point and what was meant."""

from __future__ import annotations

import sys
import unicodedata

import pytest
from declared import Declared
from one_of_each import cases

from gainproof.verify.judge.reader.characters import SIGNS, meant_character
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.reader import read_formula, read_plain

SYMBOLS = {name: Declared() for name in "abckT"}


def refusal(text: str, plain: bool = False) -> ReaderError:
    with pytest.raises(ReaderError) as caught:
        (read_plain if plain else read_formula)(text, SYMBOLS)
    return caught.value


@pytest.mark.parametrize(
    ("character", "code", "meant"),
    [
        ("\u03b1", "U+03B1", "\\alpha"),
        ("\u039b", "U+039B", "\\Lambda"),
        ("\u03c2", "U+03C2", "\\varsigma"),
        ("\u0430", "U+0430", "a"),  # Cyrillic
        ("\u0422", "U+0422", "T"),  # Cyrillic
        ("\u03a4", "U+03A4", "T"),  # Greek, printed like Latin
        ("\uff11", "U+FF11", "1"),  # full width
        ("\uff41", "U+FF41", "a"),
        ("\U0001d44e", "U+1D44E", "a"),  # mathematical italic
        ("\U0001d6fc", "U+1D6FC", "\\alpha"),
        ("\U0001d7cf", "U+1D7CF", "1"),  # mathematical bold
        ("\u00b5", "U+00B5", "\\mu"),  # micro sign
        ("\u2212", "U+2212", "-"),
        ("\u00b2", "U+00B2", "^2"),
        ("\u2099", "U+2099", "_n"),
        ("\u200b", "U+200B", None),
        ("\u202e", "U+202E", None),
        ("\u0301", "U+0301", None),
        ("\ud800", "U+D800", None),
        ("\x00", "U+0000", None),
        ("\x7f", "U+007F", None),
        ("\r", "U+000D", None),
        ("\u4e00", "U+4E00", None),
    ],
)
def test_refused_by_code_point(character: str, code: str, meant: str | None) -> None:
    for plain in (False, True):
        error = refusal(f"a = {character} b", plain)
        assert error.token == code
        assert code in error.problem
        assert error.column == 5
        assert error.problem.endswith(f": write {meant}" if meant else "ASCII")
        if not character.isprintable():
            assert character not in str(error)


SIGNS_END = 0x3000  # letters of Europe, signs and arrows lie below; above, mostly those of Asia
SPARSE = 17  # shares no factor with the sizes of Unicode's blocks, multiples of 16
IN_PARTS = {
    "signs": (*range(0x80, SIGNS_END), *range(0x1D400, 0x1D800), sys.maxunicode),
    "sparse": range(SIGNS_END, 0x10000, SPARSE),
    "rest": range(SIGNS_END, 0x10000),
}


@pytest.mark.parametrize("codes", cases(list(IN_PARTS), lambda part: part != "rest"))
def test_every_character_beyond_ascii_is_refused_or_a_sign(codes: str) -> None:
    """The first plane, mathematical letters and the last code point: none is read as something
    else.
    """
    for code in IN_PARTS[codes]:
        character = chr(code)
        if character in SIGNS:
            continue
        assert refusal(f"a = {character}").token == f"U+{code:04X}"


def test_signs_are_read_as_their_commands() -> None:
    for sign, command in (
        ("\u2264", r"\le"),
        ("\u2265", r"\ge"),
        ("\u2260", r"\ne"),
        ("\u2248", r"\approx"),
        ("\u2192", r"\to"),
    ):
        read = read_formula(f"a {sign} b", SYMBOLS).readings
        assert read == read_formula(f"a {command} b", SYMBOLS).readings
        assert unicodedata.normalize("NFKC", sign) == sign


def test_what_is_meant_is_itself_ascii() -> None:
    for code in range(0x80, 0x20000):
        meant = meant_character(chr(code))
        assert meant is None or (meant.isascii() and meant.isprintable())
