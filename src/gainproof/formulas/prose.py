"""Sentences of derivations: formulas between backticks, `@id` for the number of another step."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterator, Mapping

from gainproof.formulas.formula_text import plain_name

_REFERENCE = re.compile(r"@([a-z0-9]+(?:-[a-z0-9]+)*)")
_FORMULA = re.compile(r"`([^`]*)`")
_ROOT = re.compile(r"\\surd\(([^()]*)\)")
_LONGEST_WHOLE = 60  # characters; a longer formula may be broken between lines
_FIXED = "\N{NO-BREAK SPACE}"
_WORDS = {
    "infinity": r"\infty",
    "sqrt": r"\surd",
    "det": r"\det",
    "adj": r"\operatorname{adj}",
    "Q0": "Q_0",
}


def numbered(text: str, numbers: Mapping[str, int]) -> str:
    """The text with the number of each step that it refers to. Raises KeyError for an id that has
    none.
    """
    return _REFERENCE.sub(lambda match: str(numbers[match[1]]), text)


def pieces(text: str) -> Iterator[tuple[str, str]]:
    """The text cut into ("text", words), ("formula", plain letters) and ("step", id)."""
    for place, part in enumerate(_FORMULA.split(text)):
        if place % 2:
            yield "formula", part
            continue
        for inner, words in enumerate(_REFERENCE.split(part)):
            if words:
                yield ("step" if inner % 2 else "text"), words


def plain_prose(text: str) -> str:
    """The text without backticks."""
    return _FORMULA.sub(lambda match: match[1], text)


def wrapped(text: str, columns: int, first: str = "", rest: str = "") -> list[str]:
    """Lines of at most `columns`, `first` before the first; short formulas are kept whole."""
    fixed = _FORMULA.sub(lambda match: _whole(match[1]), text)
    lines = textwrap.wrap(fixed, columns, initial_indent=first, subsequent_indent=rest)
    return [line.replace(_FIXED, " ") for line in lines]


def _whole(formula: str) -> str:
    return formula.replace(" ", _FIXED) if len(formula) <= _LONGEST_WHOLE else formula


def latex_prose(text: str, symbols: Mapping[str, str], escaped: Callable[[str], str]) -> str:
    """The text as LaTeX, its formulas in mathematical type."""
    pieces = re.split(r"`([^`]*)`", text)
    return "".join(
        f"${latex_math(piece, symbols)}$" if place % 2 else escaped(piece)
        for place, piece in enumerate(pieces)
    )


def latex_math(text: str, symbols: Mapping[str, str]) -> str:
    """A formula in plain letters as LaTeX: names by their symbols, other words upright."""
    named = {plain_name(latex): latex for latex in symbols.values()}
    known = "|".join(re.escape(name) for name in sorted(named, key=len, reverse=True))
    token = re.compile(
        rf"(?<![A-Za-z0-9])(?:({known})(?![A-Za-z0-9])|([A-Za-z]\w*?_\w+?_\w+|[A-Za-z]+\d*))"
        r"|\^(-?\w+)|(->)"
    )

    def written(match: re.Match[str]) -> str:
        name, word, exponent, arrow = match.groups()
        if name is not None:
            return named[name]
        if exponent is not None:
            return rf"^{{{exponent}}}"
        if arrow is not None:
            return r"\to"
        if word[0] == "d" and word[1:] in named:
            # a differential: `d/dLambda`
            return f"d{named[word[1:]]}"
        # one subscript is one; a name with more of them, as of a derivative, is a word
        upright = word.replace("_", r"\_")
        return _WORDS.get(word) or (word if len(word) == 1 else rf"\mathrm{{{upright}}}")

    return _ROOT.sub(r"\\sqrt{\1}", token.sub(written, text))
