"""Tokens of formulas in plain text: `alpha^2/(2 - alpha) = beta`, `sqrt(x)`, `[a, b; c, d]`.

In square brackets rows may stand as Python writes them; entries that only a blank parts are
refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from gainproof.verify.judge.reader.alphabet import DIGITS, is_letter, skip_space
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.line_end import LineEnds
from gainproof.verify.judge.reader.source_code import (
    ENTRYWISE,
    code_circle,
    is_of_library,
    library_end,
    scan_code_number,
    usual_word,
)
from gainproof.verify.judge.reader.special_names import (
    circle_number,
    declared_kind,
    special_name,
    with_base,
)
from gainproof.verify.judge.reader.token_scan import MOST_SHOWN, NO_ALTERNATIVES, Scanned, unread
from gainproof.verify.judge.reader.tokens import MARKS, FormulaToken
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import (
    CASES,
    FUNCTION_WORDS,
    JOINING_WORDS,
    PLAIN_FORMS,
    function_of,
    is_unread,
)

_MARKS = {mark: token for mark, token in MARKS.items() if mark not in ("{", "}", "_", "&")} | {
    "<=>": ("CONNECTIVE", "iff"),
    "=>": ("CONNECTIVE", "implies"),
    "==": ("EQUAL", "="),
    "~=": ("RELATION", "approx"),
    "~": ("RELATION", "sim"),
    "**": ("POWER", "**"),
    "*": ("DOT", "*"),
    "@": ("DOT", "*"),
    ".*": ("DOT", ".*"),
    "./": ("SLASH", "./"),
    ".^": ("POWER", ".^"),
    "&&": ("AND", "and"),
    ";": ("LINE", ";"),
}
_REMAINDERS = ("fmod", "fmodf", "rem", "remainder")
_OPERANDS = ("SYMBOL", "NUMBER", "CONSTANT", "CLOSE", "RIGHT_BRACE", "BAR_CLOSE")
_INFINITY = ("infinity", "inf", "oo")
_RELATION_WORDS = {"propto": ("RELATION", "propto"), "approx": ("RELATION", "approx")}
_ENDS = ("SYMBOL", "NUMBER", "CONSTANT", "CLOSE", "RIGHT_BRACE", "MATRIX_CLOSE", "TRANSPOSE")
_BEGINS = ("SYMBOL", "NUMBER", "CONSTANT", "OPEN", "MATRIX_OPEN", "WORD", "SQRT")
_CALLS = ("EXPECT", "WORD", "NAMED", "FUNCTION", "SQRT", "ORDER", "EULER")
"""What a bracket behind belongs to: it holds an argument, no entries."""
_OPENING = ("OPEN", "MATRIX_OPEN", "CASES_OPEN", "LEFT_BRACE")
_CLOSING = ("CLOSE", "MATRIX_CLOSE", "CASES_CLOSE", "RIGHT_BRACE")


def scan_plain_tokens(text: str, vocabulary: Vocabulary) -> list[FormulaToken]:
    """The tokens of `text` in order, brackets not yet paired. ReaderError for anything unknown."""
    return _PlainLexer(text, vocabulary).run()


class _PlainLexer:
    """One pass over one text. `stack` holds the brackets that are open, and what
    separates entries in each, all as numbers of tokens.
    """

    def __init__(self, text: str, vocabulary: Vocabulary) -> None:
        self.text = text
        self.vocabulary = vocabulary
        self.tokens: list[FormulaToken] = []
        self.position = 0
        self.line_ends = LineEnds(text)
        self.stack: list[tuple[int, list[int]]] = []

    def run(self) -> list[FormulaToken]:
        text = self.text
        while (start := skip_space(text, self.position)) < len(text):
            self.position = start
            character = text[start]
            if text.startswith("...", start):
                self._add("DOTS", "...", start + 3)
            elif character in ".,;" and (end := self.line_ends.end_at(start)) is not None:
                self.position = end
            elif (end := self._transpose_end()) is not None:
                self._add("TRANSPOSE", "T", end)
            elif text[start : start + 2] in ENTRYWISE:
                self._mark()
            elif character in DIGITS or character == ".":
                self._add(*scan_code_number(text, start, self.vocabulary))
            elif is_letter(character):
                self._letters()
            else:
                self._mark()
        return self.tokens

    def _error(self, problem: str, token: str, nearest: tuple[str, ...] = ()) -> ReaderError:
        return ReaderError(problem, self.text, self.position, token, nearest)

    def _add(self, kind: str, value: str, end: int) -> None:
        self.tokens.append(FormulaToken(kind, value, self.position, end))
        self.position = end

    def _letters(self) -> None:
        name, end = self._declared()
        if name:
            kind = declared_kind(self.text, name, end, self.vocabulary)
            self._add(kind, name, end)
            return
        text = self.text
        start = library_end(text, self.position)
        of_library = start > self.position
        if of_library:
            end = _word_end(text, start)
        word = text[start:end]
        calls = text.startswith("(", skip_space(text, end))
        if calls:
            word = usual_word(word)
        if (circle := code_circle(word, of_library=of_library)) is not None:
            self._add("CONSTANT", circle, end)
        elif word.startswith("log_"):
            self._add(*self._logarithm(start))
        elif of_library and not (calls and is_of_library(word)):
            shown = text[self.position : end][:MOST_SHOWN]
            raise self._error(f"{shown} is no function that is read", shown)
        elif calls and word == CASES:
            self.stack.append((len(self.tokens), []))
            self._add("CASES_OPEN", CASES, skip_space(text, end) + 1)
        elif word == "mod" and self.tokens and self.tokens[-1].kind in _OPERANDS:
            self._add("MOD", "mod", end)
        elif word in JOINING_WORDS:
            self._add(*JOINING_WORDS[word], end)
        elif word in _RELATION_WORDS:
            self._add(*_RELATION_WORDS[word], end)
        elif word in _INFINITY:
            self._add("INFINITY", "\\infty", end)
        elif calls and word == "sqrt":
            self._add("SQRT", "\\sqrt", end)
        elif calls and word in PLAIN_FORMS:
            self._add("WORD", word, end)
        elif calls and (function := function_of(word)) is not None:
            # that of a library is natural, whatever the text calls so, and `logf` of C
            usual = text[start:end] == "log" and not of_library
            self._add("WORD", self.vocabulary.logarithm_name if usual else function, end)
        elif (special := special_name(text, word, end)) is not None:
            self._add(*special)
        elif (number := circle_number(text, word, end, self.vocabulary)) is not None:
            self._add(*number)
        elif _is_function(word):
            raise self._error(f"{word} needs brackets: {word}(...)", word)
        else:
            braced = text.find("}", end, end + MOST_SHOWN) if text[end : end + 1] == "{" else -1
            raise self._undeclared(
                text[start : braced + 1] if word.endswith("_") and braced > 0 else word
            )

    def _undeclared(self, word: str) -> ReaderError:
        """The error for a word that nobody declared."""
        shown = word[:MOST_SHOWN]
        if word == "or":
            return self._error(NO_ALTERNATIVES, "")
        if word in _REMAINDERS:
            problem = f"{word} has not the sign of its divisor: write mod(x, y), x - y floor(x/y)"
            return self._error(problem, word)
        behind = skip_space(self.text, self.position + len(word))
        if is_unread(word) and self.text.startswith("(", behind):
            return self._error(unread(word), "")
        known = [*self.vocabulary.plain_names, *PLAIN_FORMS, *FUNCTION_WORDS]
        problem = f"the symbol {shown} is not declared"
        return self._error(problem, shown, nearest_names(word, known))

    def _declared(self) -> tuple[str, int]:
        """The declared name that begins here, as long as possible, and the end; without one the end
        of the word.
        """
        text, start = self.text, self.position
        names = self.vocabulary.plain_names
        for length in range(min(self.vocabulary.longest, len(text) - start), 0, -1):
            name, end = text[start : start + length], start + length
            if name not in names or (_is_inner(name[-1]) and _is_inner(text[end : end + 1])):
                continue
            token, *others = names[name]
            if others:
                problem = f"{name} may be {' or '.join((token, *others))}: write LaTeX"
                raise self._error(problem, name, (token, *others))
            return token, end
        return "", _word_end(text, start)

    def _logarithm(self, start: int) -> Scanned:
        """`log_2(x)` and `log_{10}(x)`, the base read as in LaTeX. ReaderError without brackets."""
        text, under = self.text, start + len("log_")
        end = _word_end(text, under)
        # of the digits of a base LaTeX would take the first
        based = function_of(f"log{text[under:end]}") if end > under else None
        if based is not None:
            found = Scanned("NAMED", based, end)
        else:
            found = with_base(text, Scanned("NAMED", "log", start + len("log")), self.vocabulary)
        if not text.startswith("(", skip_space(text, found.end)):
            shown = text[start : found.end]
            raise self._error(f"{shown} needs brackets: {shown}(...)", shown)
        return found._replace(kind="WORD")

    def _transpose_end(self) -> int | None:
        """The end of `'`, `.'` or `.T` right behind a matrix or a bracket; None where there is no
        such mark.
        """
        text, start = self.text, self.position
        mark = next((m for m in ("'", ".'", ".T") if text.startswith(m, start)), "")
        end = start + len(mark)
        before = self.tokens[-1] if self.tokens else None
        if not mark or before is None or before.end != start or _is_inner(text[end : end + 1]):
            return None
        is_matrix = before.kind == "SYMBOL" and before.value in self.vocabulary.matrices
        return end if is_matrix or before.kind in ("CLOSE", "MATRIX_CLOSE") else None

    def _mark(self) -> None:
        text, start = self.text, self.position
        mark = next((m for n in (3, 2, 1) if (m := text[start : start + n]) in _MARKS), "")
        if text[start] == "%":
            raise self._error("% may be one of two remainders: write mod(x, y)", "%")
        if not mark:
            problem = f"the character {text[start]!r} has no meaning in plain text"
            raise self._error(problem, text[start])
        kind, value = _MARKS[mark]
        end = start + len(mark)
        before = self.tokens[-1].kind if self.tokens else ""
        if kind == "OPEN":
            if before in ("POWER", "SQRT") and value == "(":
                kind, value = "LEFT_BRACE", "{"
            self.stack.append((len(self.tokens), []))
        elif kind == "CLOSE" and self.stack:
            kind, value = self._closed(*self.stack.pop(), value)
        elif kind in ("COMMA", "LINE") and self.stack:
            self.stack[-1][1].append(len(self.tokens))
        elif kind == "POWER" and (power := _power_end(text, end, mark)) is not None:
            self._power(*power, value)
            return
        self._add(kind, value, end)

    def _closed(self, opening: int, separators: list[int], value: str) -> tuple[str, str]:
        """What closes the bracket `opening`: square brackets with a semicolon hold a matrix."""
        if self.tokens[opening].kind == "CASES_OPEN" and value == ")":
            only_commas = all(self.tokens[number].kind == "COMMA" for number in separators)
            for place, number in enumerate(separators):
                if self.tokens[number].kind == "COMMA":
                    kind = "LINE" if only_commas and place % 2 else "CELL"
                    self.tokens[number] = replace(self.tokens[number], kind=kind)
            return "CASES_CLOSE", CASES
        if self.tokens[opening].kind == "LEFT_BRACE" and value == ")":
            return "RIGHT_BRACE", "}"
        if value == "]" and self.tokens[opening].value == "[":
            require_entries_apart(self.text, self.tokens, opening)
            if (rows := rows_of_lists(self.text, self.tokens, opening)) is not None:
                self.tokens[opening:] = rows
                return "MATRIX_CLOSE", "matrix"
        if value != "]" or all(self.tokens[number].kind == "COMMA" for number in separators):
            return "CLOSE", value
        self.tokens[opening] = replace(self.tokens[opening], kind="MATRIX_OPEN", value="matrix")
        for number in separators:
            if self.tokens[number].kind == "COMMA":
                self.tokens[number] = replace(self.tokens[number], kind="CELL")
        return "MATRIX_CLOSE", "matrix"

    def _power(self, digits: int, end: int, mark: str) -> None:
        """`^-1` and `^T`: `digits` is where a number begins, -1 for the mark of a transpose."""
        if digits < 0:
            self._add("TRANSPOSE", "T", end)
            return
        self._add("POWER", mark, digits - 1)
        self._add("LEFT_BRACE", "{", digits - 1)
        self._add("MINUS", "-", digits)
        self._add(*scan_code_number(self.text, digits, self.vocabulary))
        self._add("RIGHT_BRACE", "}", self.position)


def _is_inner(character: str) -> bool:
    """Whether a character would go on with a word."""
    return is_letter(character) or character in DIGITS or character == "_"


def _word_end(text: str, position: int) -> int:
    while position < len(text) and _is_inner(text[position]):
        position += 1
    return position


def _is_function(word: str) -> bool:
    """Whether it is the name of a function, or a word for what LaTeX prints with signs."""
    return word in PLAIN_FORMS or word == "sqrt" or function_of(word) is not None


def _power_end(text: str, position: int, mark: str) -> tuple[int, int] | None:
    """After the `mark` of a power: the place of a number behind a minus sign and the end of the
    sign, or -1 and the end of `T` after `^`; None for anything else.
    """
    start = skip_space(text, position)
    following = text[start + 1 : start + 2]
    number = following in DIGITS or (following == "." and text[start + 2 : start + 3] in DIGITS)
    if text[start : start + 1] == "-" and following and number:
        return start + 1, start + 1
    if mark == "^" and text[start : start + 1] == "T" and not _is_inner(following):
        return -1, start + 1
    return None


def require_entries_apart(text: str, tokens: Sequence[FormulaToken], opening: int) -> None:
    """ReaderError where only a blank parts two entries of the bracket that `opening` begins and the
    last of the `tokens` stands in, as in `[1 -2]` and `[a b; c d]`: MATLAB reads two, mathematics
    a difference or a product.
    """
    if opening and tokens[opening - 1].kind in _CALLS:
        return
    inner = _at_top(tokens, opening)
    for (before, _), (token, following) in pairwise(inner):
        if before.kind not in _ENDS or token.start == before.end:
            continue
        signed = token.kind in ("PLUS", "MINUS") and following == token.end
        if signed or token.kind in _BEGINS:
            shown = text[before.start : following]
            asked = f"{token.value} with a blank on both sides" if signed else "a * for a product"
            problem = (
                f"a blank inside [ ] may part two entries: write a comma between them, or {asked}"
            )
            raise ReaderError(problem, text, token.start, shown[:20])


def _at_top(tokens: Sequence[FormulaToken], opening: int) -> list[tuple[FormulaToken, int]]:
    """The tokens behind `opening` that stand in no further bracket, its own marks besides, each
    with the place where the next token begins.
    """
    found: list[tuple[FormulaToken, int]] = []
    depth = 0
    for number in range(opening + 1, len(tokens)):
        token = tokens[number]
        depth -= token.kind in _CLOSING
        if depth == 0:
            after = tokens[number + 1].start if number + 1 < len(tokens) else -1
            found.append((token, after))
        depth += token.kind in _OPENING
    return found


def rows_of_lists(
    text: str, tokens: Sequence[FormulaToken], opening: int
) -> list[FormulaToken] | None:
    """The tokens of `[[a, b], [c, d]` as those of `[a, b; c, d`; None where the bracket `opening`
    does not hold brackets alone, several of them with commas between. ReaderError for lists beside
    other entries.
    """
    parts: list[list[FormulaToken]] = [[]]
    depth = 0
    for token in tokens[opening + 1 :]:
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        if token.kind == "COMMA" and depth == 0:
            parts.append([])
        else:
            parts[-1].append(
                replace(token, kind="CELL") if token.kind == "COMMA" and depth == 1 else token
            )
    lists = [_is_list(part) for part in parts]
    if len(parts) == 1 or not any(lists):
        return None
    if not all(lists):
        if any(
            each and any(t.kind == "CELL" for t in part)
            for each, part in zip(lists, parts, strict=True)
        ):
            problem = "lists beside other entries: rows of a matrix are all lists"
            raise ReaderError(problem, text, tokens[opening].start, "[")
        return None
    found = [replace(tokens[opening], kind="MATRIX_OPEN", value="matrix")]
    for part in parts:
        if len(found) > 1:
            found.append(replace(part[0], kind="LINE", value=";", end=part[0].start))
        found += part[1:-1]
    return found


def _is_list(part: Sequence[FormulaToken]) -> bool:
    """Whether it is one pair of square brackets with what is between."""
    if len(part) < 3 or part[0].kind != "OPEN" or part[0].value != "[" or part[-1].kind != "CLOSE":
        return False
    depth = 0
    for number, token in enumerate(part):
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        if depth == 0:
            return number == len(part) - 1
    return False
