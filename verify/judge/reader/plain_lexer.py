"""Tokens of formulas in plain text: `alpha^2/(2 - alpha) = beta`, `sqrt(x)`, `[a, b; c, d]`."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.reader.alphabet import DIGITS, is_letter, skip_space
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.line_end import LineEnds
from gainproof.verify.judge.reader.printed import decimal
from gainproof.verify.judge.reader.scan import MOST_SHOWN, scan_number
from gainproof.verify.judge.reader.special import circle_number, declared_kind, special_name
from gainproof.verify.judge.reader.tokens import MARKS, FormulaToken
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import (
    CASES,
    FUNCTION_WORDS,
    JOINING_WORDS,
    PLAIN_FORMS,
    function_of,
)

_MARKS = {mark: token for mark, token in MARKS.items() if mark not in ("{", "}", "_", "&")} | {
    "<=>": ("CONNECTIVE", "iff"),
    "=>": ("CONNECTIVE", "implies"),
    "==": ("EQUAL", "="),
    "~=": ("RELATION", "approx"),
    "~": ("RELATION", "sim"),
    "**": ("POWER", "^"),
    "*": ("DOT", "*"),
    ";": ("LINE", ";"),
}
_BY_ENTRIES = (".*", "./", ".^")
_OF_CODE = {"fabs": "abs", "fabsf": "abs", "sqrtf": "sqrt", "M_PI": "pi"}
"""Names of source code, and what they are called here."""
_POWERS = ("pow", "powf")
_REMAINDERS = ("fmod", "fmodf", "rem", "remainder")
_OPERANDS = ("SYMBOL", "NUMBER", "CONSTANT", "CLOSE", "RIGHT_BRACE", "BAR_CLOSE")
_MOST_EXPONENT = 20
"""Beyond this a number with an exponent is not written out in a message."""
_INFINITY = ("infinity", "inf", "oo")
_RELATION_WORDS = {"propto": ("RELATION", "propto"), "approx": ("RELATION", "approx")}


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
            elif text[start : start + 2] in _BY_ENTRIES:
                mark = text[start : start + 2]
                raise self._error(f"{mark} is a sign of source code: write {mark[1]}", mark)
            elif character in DIGITS or character == ".":
                self._add(*scan_number(text, start, single=False))
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
        text, start = self.text, self.position
        word = text[start:end]
        calls = text.startswith("(", skip_space(text, end))
        if calls and word == CASES:
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
            usual = self.vocabulary.logarithm_name if word == "log" else function
            self._add("WORD", usual, end)
        elif (special := special_name(text, word, end)) is not None:
            self._add(*special)
        elif (number := circle_number(text, word, end, self.vocabulary)) is not None:
            self._add(*number)
        elif word in PLAIN_FORMS or word == "sqrt" or function_of(word) is not None:
            raise self._error(f"{word} needs brackets: {word}(...)", word)
        else:
            raise self._undeclared(word, end)

    def _undeclared(self, word: str, end: int) -> ReaderError:
        """The error for a word that nobody declared; what comes from source code is told how to be
        written.
        """
        shown = word[:MOST_SHOWN]
        before = self.tokens[-1] if self.tokens else None
        if before is not None and before.kind == "NUMBER" and before.end == self.position:
            written = _number_of_code(before.value, word, self.text[end:])
            if written:
                problem = f"a number as in source code: write {written}"
                self.position = before.start
                return self._error(problem, before.value)
        if word in _POWERS:
            return self._error(f"{word} is not read: write {_power(self.text, end)}", word)
        if word in _REMAINDERS:
            problem = f"{word} has not the sign of its divisor: write mod(x, y), x - y floor(x/y)"
            return self._error(problem, word)
        if word in _OF_CODE:
            return self._error(f"{word} is not read: write {_OF_CODE[word]}", word)
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
        end = start
        while end < len(text) and _is_inner(text[end]):
            end += 1
        return "", end

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
        elif kind == "POWER" and (power := _power_end(text, end)) is not None:
            self._power(*power)
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
        if value != "]" or all(self.tokens[number].kind == "COMMA" for number in separators):
            return "CLOSE", value
        self.tokens[opening] = replace(self.tokens[opening], kind="MATRIX_OPEN", value="matrix")
        for number in separators:
            if self.tokens[number].kind == "COMMA":
                self.tokens[number] = replace(self.tokens[number], kind="CELL")
        return "MATRIX_CLOSE", "matrix"

    def _power(self, digits: int, end: int) -> None:
        """`^-1` and `^T`: `digits` is where a number begins, -1 for the mark of a transpose."""
        if digits < 0:
            self._add("TRANSPOSE", "T", end)
            return
        self._add("POWER", "^", digits - 1)
        self._add("LEFT_BRACE", "{", digits - 1)
        self._add("MINUS", "-", digits)
        self._add(*scan_number(self.text, digits, single=False))
        self._add("RIGHT_BRACE", "}", self.position)


def _number_of_code(digits: str, word: str, following: str) -> str:
    """How the number is written that has these digits, then the undeclared `word`: `1.0f`,
    `3.3e-1`; empty if it is none.
    """
    if word in ("f", "F"):
        return digits
    sign = following[:1] if word in ("e", "E") and following[:1] in ("+", "-") else ""
    power = following[1:] if sign else word[1:]
    power = power[: len(power) - len(power.lstrip("0123456789"))]
    if word[0] not in "eE" or not power or (not sign and power != word[1:]):
        return ""
    exponent = f"{sign.rstrip('+')}{power[:MOST_SHOWN]}"
    small = len(power) <= 2 and abs(int(exponent)) <= _MOST_EXPONENT
    written = decimal(Fraction(digits) * Fraction(10) ** int(exponent)) if small else None
    return written or f"{digits}*10^{f'({exponent})' if sign == '-' else exponent}"


def _power(text: str, start: int) -> str:
    """`x**n` for what stands in the brackets at `start`, if it is two arguments."""
    inner: list[str] = [""]
    depth = 0
    for character in text[skip_space(text, start) :]:
        depth += (character == "(") - (character == ")")
        if depth == 0:
            break
        if character == "," and depth == 1:
            inner.append("")
        else:
            inner[-1] += character
    inner[0] = inner[0].removeprefix("(")
    parts = [part.strip() for part in inner]
    if depth or len(parts) != 2 or not all(0 < len(part) <= MOST_SHOWN for part in parts):
        return "x**n"
    base, exponent = (part if all(map(_is_inner, part)) else f"({part})" for part in parts)
    return f"{base}**{exponent}"


def _is_inner(character: str) -> bool:
    """Whether a character would go on with a word."""
    return is_letter(character) or character in DIGITS or character == "_"


def _power_end(text: str, position: int) -> tuple[int, int] | None:
    """After `^`: the place of a number behind a minus sign and the end of the sign, or -1 and the
    end of `T`; None for anything else.
    """
    start = skip_space(text, position)
    following = text[start + 1 : start + 2]
    if text[start : start + 1] == "-" and following in DIGITS:
        return start + 1, start + 1
    if text[start : start + 1] == "T" and not _is_inner(following):
        return -1, start + 1
    return None
