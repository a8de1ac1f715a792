"""Formulas and conditions as people type them, brought into what the reader of claims reads."""

from __future__ import annotations

import contextlib
import re
import unicodedata
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

from gainproof.bad_input import BadInputError
from gainproof.claims.symbols_met import Met, symbols_met
from gainproof.verify.judge.claim.notation import MARK, is_plain
from gainproof.verify.judge.claim.usual_letters import filter_meanings
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.characters import meant_character
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_CHARACTERS
from gainproof.verify.judge.reader.latex_printer import graph_to_latex, relations_to_latex
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.words import FUNCTION_COMMANDS, FUNCTION_WORDS

MOST_NAME = 100
ONE_NAME = (r"\Delta t", r"\Delta T")
"""What is one name wherever it stands, and no product."""
STEP = "dt"
"""The same, but where it is a differential."""
_RELATION = re.compile(r"[=<>]|\\(?:leq?|geq?|approx|neq?|to|simeq|sim)\b")
_BEGINS_WITH_RELATION = re.compile(rf"\s*&?\s*(?:{_RELATION.pattern})")
_NOT_BARE = re.compile(
    r"\\(?:text|mathrm|mbox|textrm|operatorname\*?|label|tag)\s*\{[^{}]*\}|\\[A-Za-z]+|[_^]\{[^{}]*\}"
)
"""What is no product of letters in LaTeX: words in upright print, commands, indices."""
_SURE = ("sinh", "cosh", "tanh", "sin", "cos", "tan", "sqrt", "exp", "log", "abs")
"""Functions that are meant at the end of a run of letters too, as in `xlog y`."""
_POWER = re.compile(r"\^\{([^{}]*)\}")
_MARKED = re.compile(
    r"(?<![A-Za-z\\])(?:\\(?:hat|tilde|bar|mathbf)\{?)?\\?[A-Za-z]{1,40}\}?(?:_(?:\{[^{}]{0,40}\}|\w))?"
    rf"(?:{MARK.pattern}|\([-+]\))"
)
"""A name with the mark of what is predicted or updated: `P_k^-`, `\\hat{x}_k(+)`."""
_BELOW = re.compile(r"_\{([A-Za-z0-9]+)\}")
_DIFFERENTIAL = re.compile(
    r"\\int|integral|diff|\\frac\s*\{?\s*(?:\\mathrm\s*\{?\s*)?d|\bd\w*\s*/\s*d"
)
"""Where the d of dt is one of a derivative or an integral."""
_EULER = re.compile(r"(?<![A-Za-z\\_{])e(?=\s*\^)(?!\^\{?[-+]\}?\s*(?:$|[=)}]))")
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


def typed(
    formula: str,
    said: Collection[str],
    is_number: Callable[[str], bool] = lambda _: True,
    *,
    latex: bool = False,
) -> Typed:
    """Read a formula; `said` are the symbols of which the user says what they are; letters are
    matrices where `is_number` denies it; as LaTeX, or as what it looks like. Raises BadInputError,
    with a mark under the place.
    """
    if not formula.strip():
        raise BadInputError("a formula is wanted, got an empty one")
    text, plain, met, products = _met(formula, said, is_number=is_number, latex=latex)
    taken = [(word, f"product {' '.join(word)}") for word in products]
    return Typed(text, plain, _read(met), met.symbols, tuple(taken + _meant(text, met)))


def condition(text: str, option: str, said: Collection[str], like: Typed) -> Typed:
    """A condition or hypothesis in LaTeX, whose words are products where they are in the formula
    that is `like` it. Raises BadInputError.
    """
    try:
        text, plain, met, products = _met(text, said, [word for word, _ in like.taken])
        formula = _read(met)
    except BadInputError as error:
        raise BadInputError(f"--{option}: {error}") from None
    if "or" in met.symbols:
        raise BadInputError(f"--{option}: conditions hold together; `or` is not read")
    if plain:
        if formula.readings[0].conditions:
            raise BadInputError(f"--{option}: a condition within a condition is not read")
        text = relations_to_latex(formula.readings[0].relations)
    taken = [(word, f"product {' '.join(word)}") for word in products]
    return Typed(text, False, formula, met.symbols, tuple(taken + _meant(text, met)))


def definition(text: str, option: str, said: Collection[str], like: Typed) -> Typed:
    """An expression in LaTeX. Raises BadInputError."""
    if not text.strip():
        raise BadInputError(f"--{option}: a formula is wanted behind =, got none")
    # as the right side of an equation it is read like one
    read = condition(f"0 = {text}", option, said, like)
    relations = read.formula.readings[0].relations
    if len(relations) != 1:
        raise BadInputError(f"--{option}: an expression is wanted behind =, got {text[:80]!r}")
    return replace(read, text=graph_to_latex(relations[0].right))


def symbol_name(name: str) -> str:
    """The symbol that a user names, in LaTeX or as plain text. Raises BadInputError."""
    name = in_ascii(name.strip()).strip()
    if len(name) > MOST_NAME:
        raise BadInputError(f"--symbol: a name of more than {MOST_NAME} characters")
    if is_plain(name):
        met = symbols_met(f"{_without_braces(name)} = 0", plain=True)
        if met.formula is not None and len(met.symbols) == 1:
            return met.symbols[0]
    try:
        return canonical_token(name)
    except ReaderError as error:
        raise BadInputError(f"--symbol {name!r}: {error.problem}") from None


def _met(
    formula: str,
    said: Collection[str],
    products: Sequence[str] = (),
    is_number: Callable[[str], bool] = lambda _: True,
    *,
    latex: bool = False,
) -> tuple[str, bool, Met, tuple[str, ...]]:
    """The text as the reader has it, whether it is plain, what is met in it, and which words are
    products there: those of `products` too. Raises BadInputError.
    """
    text = in_ascii(formula.strip())
    if len(text) > MOST_CHARACTERS:
        raise BadInputError(f"{len(text)} characters, at most {MOST_CHARACTERS} are read")
    _refuse_several(text)
    if is_plain(text) and not latex:
        text = _without_braces(text)
    plain = is_plain(text) and "^{" not in text and not latex
    if not plain:
        _refuse_words(text, said)
    met = symbols_met(text, plain=plain, known=_known(text, said), is_number=is_number)
    if not plain:
        return text, plain, met, ()
    # of matrices capital letters beside each other are a product, whatever else the formula has
    capitals = [w for w in met.symbols if re.fullmatch("[A-Z]{2,4}", w) and not is_number(w)]
    also = [word for word in (*capitals, *products) if word in met.symbols and word not in said]
    words = tuple(dict.fromkeys((*_products(met.symbols, said), *also)))
    for word in words:
        place = rf"(?<![A-Za-z_]){word}(?![A-Za-z_])"
        if re.search(rf"[\^/]\s*{place}", text):
            raise BadInputError(
                f"{word} behind ^ or / may be one name or a product: write ({' '.join(word)}), or "
                f"say what it is: --symbol '{word}: 1'; a derivative is written diff(f, x)"
            )
        text = re.sub(place, " ".join(word), text)
    if words:
        met = symbols_met(text, plain=plain, known=_known(text, said), is_number=is_number)
    return text, plain, met, words


def _without_braces(text: str) -> str:
    """Plain text without the braces of LaTeX round a subscript, and with brackets for those round
    an exponent.
    """
    return _POWER.sub(r"^(\1)", _BELOW.sub(r"_\1", text))


def _meant(text: str, met: Met) -> list[tuple[str, str]]:
    """What has a meaning that nobody said."""
    found = []
    if "e" not in met.symbols and _EULER.search(text):
        found.append(("e", "Euler's number"))
    if _LOGARITHM.search(text):
        found.append(("log", "natural logarithm"))
    return found


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
        problem = met.problem or ""
        if "declared as a matrix" in problem:
            problem += "; --model matrices, or a claim file, says so"
        raise BadInputError(f"not read: {problem}\n{met.caret}")
    return met.formula


def _known(text: str, said: Collection[str]) -> list[str]:
    """Names of several letters that the reader would take for products."""
    usual = [*ONE_NAME, *([] if _DIFFERENTIAL.search(text) else [STEP])]
    for found in _MARKED.finditer(text):
        with contextlib.suppress(ReaderError):
            usual.append(canonical_token(found[0]))
    return [*said, *(name for name in dict.fromkeys(usual) if name not in said)]


def _refuse_words(text: str, said: Collection[str]) -> None:
    """Raises BadInputError for a function without its backslash in LaTeX, where its letters would
    be a product.
    """
    # commands, upright words and indices are what they say
    bare = _NOT_BARE.sub(lambda found: "." * len(found[0]), text)
    for found in re.finditer("[A-Za-z]{2,}2?", bare):
        word = found[0]
        ends = [each for each in _SURE if word.endswith(each)]
        name = word if word in FUNCTION_WORDS or not ends else ends[0]
        if name not in FUNCTION_WORDS and name not in _SURE:
            continue
        if word in said:
            continue
        of = FUNCTION_WORDS.get(name, name)
        commands = [each for each, meant in FUNCTION_COMMANDS.items() if meant == of]
        commands.sort(key=lambda each: each != f"\\{name}")
        other = {"sqrt": r"\sqrt{...}", "abs": r"\left|...\right|"}
        wanted = commands[0] if commands else other.get(name, rf"\operatorname{{{name}}}")
        mark = " " * found.start() + "^"
        raise BadInputError(
            f"{word} in LaTeX would be the product {' '.join(word)}: write {wanted}\n"
            f"    {text}\n    {mark}"
        )


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
