"""Names that mean something where nobody declared them: E[...], O(...), e^x, pi, named functions;
the mark of a transpose; the sign of a branch.
"""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import braced_sign_end, command_at, skip_space
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_DIGITS
from gainproof.verify.judge.reader.token_scan import Scanned
from gainproof.verify.judge.reader.tokens import SIZES
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import (
    BASED,
    CIRCLE,
    CIRCLE_NAMES,
    EULER_NAMES,
    EXPECTATION_NAMES,
    ORDER_NAMES,
    TRANSPOSE_MARKS,
    function_of,
)


def special_name(text: str, name: str, end: int) -> Scanned | None:
    """The expectation, the order of a term or Euler's number, where what follows shows that it is
    meant: `E[` or `E\\{`, `O(`, `e^`.
    """
    following = bracket_after(text, end)
    if name in EXPECTATION_NAMES and following in ("[", "\\{"):
        return Scanned("EXPECT", "expectation", end)
    if name in ORDER_NAMES and following == "(":
        return Scanned("ORDER", "order", end)
    if name in EULER_NAMES and following == "^":
        return Scanned("EULER", "exp", end)
    return None


def circle_number(text: str, name: str, end: int, vocabulary: Vocabulary) -> Scanned | None:
    """The number pi, where nothing is declared that is called so, with marks or without, and none
    stand here.
    """
    marked = text.startswith(("_", "'"), skip_space(text, end))
    if name not in CIRCLE_NAMES or marked:
        return None
    if any(each.startswith(tuple(CIRCLE_NAMES)) for each in vocabulary.symbols):
        return None
    return Scanned("CONSTANT", CIRCLE, end)


def declared_kind(text: str, name: str, end: int, vocabulary: Vocabulary) -> str:
    """The kind of a declared name. ReaderError for `E[x]` with a declared number E: it is hardly
    meant to be a product.
    """
    if vocabulary.is_function(name):
        return "FUNCTION"
    if name in EXPECTATION_NAMES and bracket_after(text, end) in ("[", "\\{"):
        problem = (
            f"{name} is declared, so that this is no expectation: leave it undeclared for one, "
            f"write {name} ( ) for a product"
        )
        raise ReaderError(problem, text, skip_space(text, end), name)
    return "SYMBOL"


def function_named(base: str, end: int) -> Scanned | None:
    """`\\operatorname{tr}`, `\\mathrm{diag}` and the like."""
    word = base[base.find("{") + 1 : -1]
    function = function_of(word)
    if function is None or not base.startswith(("\\operatorname", "\\mathrm", "\\text")):
        return None
    return Scanned("NAMED", function, end)


def with_base(text: str, function: Scanned, vocabulary: Vocabulary) -> Scanned:
    """A logarithm with the base under it, if there is one: `\\log_{10}`, `\\log_2`, `\\log_e`; and
    `\\arctan2(y, x)`.
    ReaderError for a base that is neither Euler's number nor a whole number from 2 on.
    """
    if function.value == "atan" and text.startswith("2", function.end):
        after = function.end + 1
        return Scanned("NAMED", "atan2", after) if bracket_after(text, after) == "(" else function
    under = skip_space(text, function.end)
    if function.value != "log":
        return function
    natural = text[: function.end].endswith(("ln", "ln}"))
    if text[under : under + 1] != "_":
        usual = "log" if natural else vocabulary.logarithm_name
        return function._replace(value=usual)
    if natural:
        problem = "a natural logarithm with a base: write \\log"
        raise ReaderError(problem, text, under, "_")
    start = skip_space(text, under + 1)
    closing = text.find("}", start, start + MOST_DIGITS)
    braced = text[start : start + 1] == "{" and closing > 0
    end = closing + 1 if braced else start + 1
    base = text[start + 1 : closing].strip() if braced else text[start:end]
    if base == "e" and not EULER_NAMES & set(vocabulary.symbols):
        return function._replace(end=end)
    if not (base.isascii() and base.isdecimal() and int(base) > 1):
        problem = "the base of a logarithm is to be e or a whole number from 2 on"
        raise ReaderError(problem, text, start, text[start:end])
    return Scanned("NAMED", f"{BASED}{int(base)}", end)


def bracket_after(text: str, position: int) -> str:
    """The next mark after blanks and the size of a bracket."""
    position = skip_space(text, position)
    if text[position : position + 1] == "\\":
        command = command_at(text, position)
        if command not in SIZES:
            return command
        position = skip_space(text, position + len(command))
    mark = text[position : position + 1]
    return command_at(text, position) if mark == "\\" else mark


def sign_in_braces(text: str, position: int) -> Scanned | None:
    """`{+}` or `{-}` at `position`, which prints a sign without blanks round it."""
    end = braced_sign_end(text, position)
    if end is None:
        return None
    sign = text[position:end].strip("{} \t\n")
    return Scanned("PLUS" if sign == "+" else "MINUS", sign, end)


def transpose(text: str, position: int) -> Scanned | None:
    """The mark of a transpose after `^`, `T` or `-T` with that of an inverse before it, and the
    end; None for any other exponent.
    """
    start = skip_space(text, position)
    braced = text[start : start + 1] == "{"
    if braced:
        start = skip_space(text, start + 1)
    inverse = braced and text[start : start + 1] == "-"
    if inverse:
        start = skip_space(text, start + 1)
    end = _end_of_mark(text, start)
    if end is None:
        return None
    if braced:
        end = skip_space(text, end)
        if text[end : end + 1] != "}":
            return None
        end += 1
    return Scanned("TRANSPOSE", "-T" if inverse else "T", end)


def _end_of_mark(text: str, start: int) -> int | None:
    if text[start : start + 1] == "T":
        return start + 1
    if text[start : start + 1] != "\\":
        return None
    command = command_at(text, start)
    end = start + len(command)
    if command in TRANSPOSE_MARKS:
        return end
    argument = skip_space(text, end)
    braced = text[argument : argument + 1] == "{"
    letter = skip_space(text, argument + 1) if braced else argument
    if f"{command}{{{text[letter : letter + 1]}}}" not in TRANSPOSE_MARKS:
        return None
    end = letter + 1
    if braced:
        end = skip_space(text, end)
        return end + 1 if text[end : end + 1] == "}" else None
    return end


def sign_of_branch(text: str, start: int, command: str, branch: str | None) -> Scanned:
    """`\\pm` or `\\mp` in the declared branch. ReaderError where none is declared."""
    if branch is None:
        problem = f'{command} stands for two formulas: declare branch = "upper" or branch = "lower"'
        raise ReaderError(problem, text, start, command)
    plus = (branch == "upper") == (command == "\\pm")
    return Scanned("PLUS" if plus else "MINUS", "+" if plus else "-", start + len(command))
