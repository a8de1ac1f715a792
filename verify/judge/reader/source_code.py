"""What plain text takes from source code in MATLAB, C and Python: numbers such as `1.0f` and
`3.3e-1`, names of functions with the prefix of a library, the circle's number.
"""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import DIGITS, is_letter, skip_space
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_DIGITS, MOST_EXPONENT
from gainproof.verify.judge.reader.line_end import ends_line
from gainproof.verify.judge.reader.token_scan import MOST_SHOWN, Scanned, scan_number
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import CIRCLE, PLAIN_FORMS, function_of

ENTRYWISE = (".*", "./", ".^")
"""Signs that act entry by entry: of matrices that is another thing than the product."""
PREFIXES = ("numpy.", "np.", "math.", "cmath.", "linalg.", "Math.", "std::")
"""Of libraries, before the name of a function."""
SAME = {
    "fabs": "abs",
    "inv": "inverse",
    "power": "pow",
    "arctan2": "atan2",
    "fmax": "max",
    "fmin": "min",
}
"""Functions by their names in source code."""
_OTHERS = frozenset(("cov", "var", "diag", "blkdiag", "rank", "tr"))
_FORMS = frozenset(("abs", "sqrt", "transpose", "inverse", "kron", "pow", "hypot"))
_CIRCLES = ("pi", "PI")


def scan_code_number(text: str, start: int, vocabulary: Vocabulary) -> Scanned:
    """A number with or without a point, an exponent of ten and the mark `f` of C, all exact as
    printed. ReaderError where a declared name makes another reading of it, and beyond the limits.
    """
    end = _digits_end(text, start)
    if _has_point(text, start, end):
        end = _digits_end(text, end + 1)
    mantissa = text[start:end]
    bad = not mantissa or mantissa == "."
    if bad or (text[end : end + 1] == "." and not _point_is_free(text, end)):
        return scan_number(text, start, single=False)  # which says what is wrong
    if len(mantissa) > MOST_DIGITS:
        problem = f"a number of {len(mantissa)} digits, but at most {MOST_DIGITS} are read"
        raise ReaderError(problem, text, start, mantissa[:MOST_SHOWN])
    value, after = _with_exponent(text, start, end, mantissa.rstrip("."), vocabulary)
    if after > end or "." in mantissa:
        after = _without_mark(text, start, after, vocabulary)
    if after > end and _goes_on(text, after):
        problem = f"a number that runs into what follows: {text[start : after + 1][:MOST_SHOWN]}"
        raise ReaderError(problem, text, start, text[start:after][:MOST_SHOWN])
    return Scanned("NUMBER", f"0{value}" if value.startswith(".") else value, after)


def _digits_end(text: str, position: int) -> int:
    while position < len(text) and text[position] in DIGITS:
        position += 1
    return position


def _goes_on(text: str, position: int) -> bool:
    """Whether a word would go on there."""
    following = text[position : position + 1]
    return is_letter(following) or following in DIGITS or following == "_"


def _has_point(text: str, start: int, end: int) -> bool:
    """Whether the point at `end` belongs to the number: `1./3.`, but not that of `2.*x`, of dots or
    of the end of a line.
    """
    if text[end : end + 1] != ".":
        return False
    if text[end + 1 : end + 2] in DIGITS:
        return True
    if end == start or _point_is_free(text, end):
        return False
    return not _goes_on(text, end + 1) or text[end + 1] in "eEfF"


def _point_is_free(text: str, place: int) -> bool:
    """Whether a point behind a number is none of it."""
    entrywise = text[place : place + 2] in ENTRYWISE and text[place + 1 : place + 3] != "**"
    return entrywise or text.startswith("...", place) or ends_line(text, place)


def _with_exponent(
    text: str, start: int, end: int, mantissa: str, vocabulary: Vocabulary
) -> tuple[str, int]:
    """The number with its exponent as `3.3e-1`, and the end; as it is where none follows, or where
    a declared name begins there.
    """
    if text[end : end + 1] not in ("e", "E"):
        return mantissa, end
    signed = text[end + 1 : end + 2] in ("+", "-")
    digits = end + 1 + signed
    after = _digits_end(text, digits)
    word = end + 1
    while _goes_on(text, word):
        word += 1
    if after == digits or (not signed and text[end:word] in vocabulary.plain_names):
        return mantissa, end
    if signed and text[end] in vocabulary.plain_names:
        raise _two_readings(text, start, end, after)
    exponent = int(text[digits:after]) if after - digits <= MOST_DIGITS else MOST_EXPONENT + 1
    if exponent > MOST_EXPONENT:
        problem = f"an exponent beyond {MOST_EXPONENT}"
        raise ReaderError(problem, text, digits, text[digits:after][:MOST_SHOWN])
    sign = "-" if text[end + 1] == "-" else ""
    return f"{mantissa}e{sign}{exponent}", after


def _without_mark(text: str, start: int, end: int, vocabulary: Vocabulary) -> int:
    """The end of a number with the mark of single precision, if it has one."""
    if text[end : end + 1] not in ("f", "F") or _goes_on(text, end + 1):
        return end
    names = vocabulary.plain_names.get(text[end], ())
    calls = text.startswith("(", skip_space(text, end + 1))
    if any(calls or not vocabulary.is_function(name) for name in names):
        raise _two_readings(text, start, end, end + 1)
    return end + 1


def _two_readings(text: str, start: int, letter: int, end: int) -> ReaderError:
    shown = text[start:end]
    problem = (
        f"{shown[:MOST_SHOWN]} may be a number or a product with {text[letter]}, which is "
        f"declared: write {text[start:letter]}*{text[letter]}, or the number without a letter"
    )
    return ReaderError(problem, text, start, shown[:MOST_SHOWN])


def library_end(text: str, position: int) -> int:
    """The end of the prefixes of libraries at `position`: `np.`, `numpy.linalg.`, `std::`."""
    while (found := next((p for p in PREFIXES if text.startswith(p, position)), "")) and is_letter(
        text[position + len(found) : position + len(found) + 1]
    ):
        position += len(found)
    return position


def usual_word(word: str) -> str:
    """The name by which plain text knows a function of source code: `sqrt` of `sqrtf`, `abs` of
    `fabs`; any other word as it is.
    """
    for name in (word, word.removesuffix("f")):
        name = SAME.get(name, name)
        if name == "sqrt" or name in PLAIN_FORMS or function_of(name) is not None:
            return name
    return word


def is_of_library(word: str) -> bool:
    """Whether a library has a function of this name that means the same: `np.diff` is a difference,
    `np.var` that of a sample.
    """
    return word in _FORMS or (function_of(word) is not None and word not in _OTHERS)


def code_circle(word: str, *, of_library: bool) -> str | None:
    """What a name of source code for the number pi is in graphs; None for other words."""
    return CIRCLE if word == "M_PI" or (of_library and word in _CIRCLES) else None
