"""Own lexer: longest match against the declared symbols, brackets paired, everything else an error with its place."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from dataclasses import replace

from gainproof.verify.judge.reader.brackets import pair_brackets
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.limits import MOST_CHARACTERS, MOST_DIGITS, MOST_NAME_CHARACTERS
from gainproof.verify.judge.reader.names import (
    command_at,
    is_letter,
    scan_base,
    scan_decorations,
    skip_space,
)
from gainproof.verify.judge.reader.tokens import COMMANDS, MARKS, SIZES, SPACES, FormulaToken

_WORDS_AND = frozenset(("and",))
_DIGITS = frozenset("0123456789")


def read_tokens(text: str, functions: Mapping[str, bool]) -> tuple[FormulaToken, ...]:
    """The tokens of `text`. `functions` maps each declared canonical symbol to whether it is a function."""
    _refuse_characters(text)
    return pair_brackets(text, _Lexer(text, functions).run())


def _refuse_characters(text: str) -> None:
    if len(text) > MOST_CHARACTERS:
        raise ReaderError(
            f"{len(text)} characters, but a formula has at most {MOST_CHARACTERS}",
            text,
            MOST_CHARACTERS,
        )
    for position, character in enumerate(text):
        if not (" " <= character <= "~" or character in "\n\t"):
            name = unicodedata.name(character, "no name")
            problem = f"the character U+{ord(character):04X} ({name}) is not LaTeX written in ASCII"
            raise ReaderError(problem, text, position, f"U+{ord(character):04X}")


class _Lexer:
    """One pass over one text. `waiting` counts the arguments that a command before still takes: there a digit or
    a letter stands for itself alone, as in TeX."""

    def __init__(self, text: str, functions: Mapping[str, bool]) -> None:
        self.text = text
        self.functions = functions
        self.tokens: list[FormulaToken] = []
        self.waiting = 0
        self.outer: list[int] = []
        self.position = 0
        self.aligned = 0

    def run(self) -> list[FormulaToken]:
        while (start := skip_space(self.text, self.position)) < len(self.text):
            self.position = start
            character = self.text[start]
            if character in _DIGITS or character == ".":
                self._number()
            elif is_letter(character):
                self._letters()
            elif character == "\\":
                self._command()
            elif character == "~" or (character == "&" and self.aligned == 1):
                self.position += 1
            elif character == "_" and self.tokens and self.tokens[-1].kind == "SUM":
                self._add("UNDER", "_", start + 1)
            else:
                self._mark()
        if self.aligned == 1:
            raise ReaderError("\\begin{aligned} is never ended", self.text, len(self.text))
        return self.tokens

    def _environment(self, command: str, end: int) -> None:
        """`aligned` round the whole formula, once: its lines are joined by `and`, its marks `&` say nothing."""
        name = "{aligned}"
        wanted = {"\\begin": 0, "\\end": 1}[command]
        if not self.text.startswith(name, end) or self.aligned != wanted:
            problem = "only \\begin{aligned} ... \\end{aligned} is known, once"
            raise ReaderError(problem, self.text, self.position, command)
        place = end + len(name)
        around = self.tokens if command == "\\begin" else self.text[skip_space(self.text, place) :]
        if around:
            problem = "aligned must stand round the whole formula"
            raise ReaderError(problem, self.text, self.position, command)
        self.aligned += 1
        self.position = place

    def _add(self, kind: str, value: str, end: int) -> None:
        if kind in ("SUM", "PARTIAL_OPERATOR") and self.tokens and self.tokens[-1].kind == "DOT":
            # the grammar looks one token ahead: this dot ends a product instead of continuing it
            self.tokens[-1] = replace(self.tokens[-1], kind="DOT_BEFORE_BIG")
        self.tokens.append(FormulaToken(kind, value, self.position, end))
        self.position = end
        if kind in ("LEFT_BRACE", "ROOT_OPEN"):
            self.outer.append(max(0, self.waiting - 1) if kind == "LEFT_BRACE" else self.waiting)
            self.waiting = 0
        elif kind in ("RIGHT_BRACE", "ROOT_CLOSE"):
            self.waiting = self.outer.pop() if self.outer else 0
        elif kind in ("FRAC", "FRAC_PARTIAL", "PARTIAL_OPERATOR"):
            self.waiting = 2
        elif kind in ("SQRT", "POWER", "UNDER"):
            self.waiting = 1
        else:
            self.waiting = max(0, self.waiting - 1)

    def _number(self) -> None:
        text, end = self.text, self.position
        if self.waiting and text[end] in _DIGITS:
            self._add("NUMBER", text[end], end + 1)
            return
        points = 0
        while end < len(text) and (text[end] in _DIGITS or text[end] == "."):
            points += text[end] == "."
            end += 1
        value = text[self.position : end]
        if points > 1 or value[0] == "." or value[-1] == ".":
            raise ReaderError(
                "a number needs digits on both sides of its one point",
                text,
                self.position,
                value[:40],
            )
        if len(value) > MOST_DIGITS:
            problem = f"a number of {len(value)} digits, but at most {MOST_DIGITS} are read"
            raise ReaderError(problem, text, self.position, value[:40])
        self._add("NUMBER", value, end)

    def _letters(self) -> None:
        """The longest declared name that begins here; a name's primes and subscript follow its last letter."""
        text, start = self.text, self.position
        end = start + 1
        while (
            not self.waiting
            and end < len(text)
            and is_letter(text[end])
            and end - start < MOST_NAME_CHARACTERS
        ):
            end += 1
        word = text[start:end]
        whole, whole_end = (word, end) if self.waiting else scan_decorations(text, word, end)
        if whole in _WORDS_AND and whole not in self.functions:
            self._add("AND", "and", whole_end)
            return
        if whole in self.functions:
            self._symbol(whole, whole_end)
            return
        for length in range(len(word) - 1 if whole != word or len(word) > 1 else 1, 0, -1):
            if word[:length] in self.functions:
                self._symbol(word[:length], start + length)
                return
        self._unknown(whole if len(word) == 1 else word[0], whole if len(word) > 1 else "")

    def _symbol(self, name: str, end: int) -> None:
        self._add("FUNCTION" if self.functions[name] else "SYMBOL", name, end)

    def _unknown(self, name: str, word: str = "") -> None:
        near = nearest_names(word, self.functions) if word else ()
        near = near or nearest_names(name, self.functions)
        raise ReaderError(
            f"the symbol {word or name} is not declared",
            self.text,
            self.position,
            word or name,
            near,
        )

    def _command(self) -> None:
        text, start = self.text, self.position
        command = command_at(text, start)
        end = start + len(command)
        if command in SPACES:
            self.position = end
        elif command in ("\\begin", "\\end"):
            self._environment(command, end)
        elif command in SIZES:
            self._sized(command, end)
        elif command in ("\\text", "\\mathrm", "\\textrm") and self._is_and(end):
            self._add("AND", "and", text.index("}", end) + 1)
        elif command == "\\frac" or command in COMMANDS and COMMANDS[command][0] == "FRAC":
            self._add(self._kind_of_fraction(end), "\\frac", end)
        elif command in COMMANDS:
            self._add(*COMMANDS[command], end)
        elif (found := scan_base(text, start)) is not None:
            name, end = found if self.waiting else scan_decorations(text, *found)
            if name not in self.functions:
                self._unknown(name)
            self._symbol(name, end)
        else:
            known = [*COMMANDS, *self.functions]
            raise ReaderError(
                f"the command {command} is not known",
                text,
                start,
                command,
                nearest_names(command, known),
            )

    def _sized(self, command: str, end: int) -> None:
        """`\\left(` and the like: the size says nothing, except that bars get a direction."""
        start = self.position
        bracket = skip_space(self.text, end)
        mark = self.text[bracket : bracket + 1]
        mark = command_at(self.text, bracket) if mark == "\\" else mark
        end = bracket + len(mark)
        if mark == "|" and command in ("\\left", "\\right") or mark in ("\\lvert", "\\rvert"):
            opens = command == "\\left" or mark == "\\lvert"
            self._add("BAR_OPEN" if opens else "BAR_CLOSE", "|", end)
            return
        kind, value = MARKS.get(mark) or COMMANDS.get(mark) or ("", "")
        if kind not in ("OPEN", "CLOSE") or command == "\\left" != kind == "CLOSE":
            raise ReaderError(
                f"{command} needs a bracket after it", self.text, start, command + mark
            )
        if command in ("\\left", "\\right") and (command == "\\left") != (kind == "OPEN"):
            raise ReaderError(
                f"{command} stands before the wrong side of a bracket",
                self.text,
                start,
                command + mark,
            )
        self._add(kind, value, end)

    def _is_and(self, end: int) -> bool:
        closing = self.text.find("}", end, end + 20)
        return closing > 0 and self.text[end:closing].replace(" ", "") == "{and"

    def _kind_of_fraction(self, end: int) -> str:
        """Whether a fraction is a number's, `\\frac{\\partial}{...}` or `\\frac{\\partial x}{...}`."""
        brace = skip_space(self.text, end)
        inner = skip_space(self.text, brace + 1)
        if self.text[brace : brace + 1] != "{" or command_at(self.text, inner) != "\\partial":
            return "FRAC"
        closing = skip_space(self.text, inner + len("\\partial"))
        return "PARTIAL_OPERATOR" if self.text[closing : closing + 1] == "}" else "FRAC_PARTIAL"

    def _mark(self) -> None:
        text, start = self.text, self.position
        for length in (2, 1):
            mark = text[start : start + length]
            if mark in MARKS:
                kind, value = MARKS[mark]
                if value == "[" and self.tokens and self.tokens[-1].kind == "SQRT":
                    kind = "ROOT_OPEN"
                elif (
                    value == "]"
                    and self.tokens
                    and len(self.tokens) > 1
                    and self.tokens[-2].kind == "ROOT_OPEN"
                ):
                    kind = "ROOT_CLOSE"
                self._add(kind, value, start + length)
                return
        character = text[start]
        if character == "_":
            raise ReaderError("this subscript belongs to no symbol", text, start, "_")
        if character == "|":
            problem = "a bar may mean two things: write \\left| x \\right| or \\lvert x \\rvert"
            raise ReaderError(problem, text, start, "|")
        raise ReaderError(
            f"the character {character!r} has no meaning here", text, start, character
        )
