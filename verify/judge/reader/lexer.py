"""Own lexer: longest match against the declared symbols, everything unknown an error with its
place.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gainproof.verify.judge.reader.alphabet import command_at, is_letter, skip_space
from gainproof.verify.judge.reader.brackets import pair_brackets
from gainproof.verify.judge.reader.characters import refuse_characters
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.limits import MOST_NAME_CHARACTERS
from gainproof.verify.judge.reader.names import scan_base, scan_decorations
from gainproof.verify.judge.reader.scan import (
    DIGITS,
    end_of_and,
    fraction_kind,
    scan_mark,
    scan_number,
    scan_sized,
)
from gainproof.verify.judge.reader.spaces import settle_wide_spaces
from gainproof.verify.judge.reader.tokens import (
    COMMANDS,
    SIZES,
    SPACES,
    TAKES_ARGUMENTS,
    WIDE_SPACES,
    FormulaToken,
)

_TEXTS = frozenset(("\\text", "\\mathrm", "\\textrm", "\\mbox"))
_ENVIRONMENT = "{aligned}"


def read_tokens(text: str, functions: Mapping[str, bool]) -> tuple[FormulaToken, ...]:
    """The tokens of `text`, brackets paired. `functions` maps each declared canonical symbol to
    whether it is a function.
    """
    refuse_characters(text)
    return settle_wide_spaces(pair_brackets(text, _Lexer(text, functions).run()))


class _Lexer:
    """One pass over one text. `waiting` counts the arguments that a command before still takes:
    there a digit or a letter stands for itself alone, as in TeX. `outer` keeps the counts of the
    braces around.
    """

    def __init__(self, text: str, functions: Mapping[str, bool]) -> None:
        self.text = text
        self.functions = functions
        self.tokens: list[FormulaToken] = []
        self.position = 0
        self.waiting = 0
        self.outer: list[int] = []
        self.environments = 0
        self.longest = min(MOST_NAME_CHARACTERS, max(map(len, (*functions, "and"))))

    def run(self) -> list[FormulaToken]:
        while (start := skip_space(self.text, self.position)) < len(self.text):
            self.position = start
            character = self.text[start]
            if character in DIGITS or character == ".":
                self._add(*scan_number(self.text, start, single=self.waiting > 0))
            elif is_letter(character):
                self._letters()
            elif character == "\\":
                self._command()
            elif character == "~" or (character == "&" and self.environments == 1):
                self.position += 1
            elif character == "_" and self.tokens and self.tokens[-1].kind == "SUM":
                self._add("UNDER", "_", start + 1)
            else:
                self._add(*scan_mark(self.text, start, self.tokens))
        if self.environments == 1:
            raise self._error("\\begin{aligned} is never ended", "\\begin")
        return self.tokens

    def _error(self, problem: str, token: str, nearest: tuple[str, ...] = ()) -> ReaderError:
        return ReaderError(problem, self.text, self.position, token, nearest)

    def _add(self, kind: str, value: str, end: int) -> None:
        if kind in ("SUM", "PARTIAL_OPERATOR") and self.tokens and self.tokens[-1].kind == "DOT":
            # the grammar looks one token ahead: this dot ends a product instead of continuing it
            self.tokens[-1] = replace(self.tokens[-1], kind="DOT_BEFORE_BIG")
        self.tokens.append(FormulaToken(kind, value, self.position, end))
        self.position = end
        if kind == "LEFT_BRACE":
            self.outer.append(max(0, self.waiting - 1))
            self.waiting = 0
        elif kind == "ROOT_OPEN":
            self.outer.append(self.waiting)
            self.waiting = 0
        elif kind in ("RIGHT_BRACE", "ROOT_CLOSE"):
            self.waiting = self.outer.pop() if self.outer else 0
        else:
            self.waiting = TAKES_ARGUMENTS.get(kind, max(0, self.waiting - 1))

    def _symbol(self, name: str, end: int) -> None:
        self._add("FUNCTION" if self.functions[name] else "SYMBOL", name, end)

    def _letters(self) -> None:
        """The longest declared name that begins here; primes and a subscript follow its last
        letter.
        """
        text, start = self.text, self.position
        most = start + (1 if self.waiting else self.longest + 1)
        end = start + 1
        while end < min(len(text), most) and is_letter(text[end]):
            end += 1
        word = text[start:end]
        name, name_end = (word, end) if self.waiting else scan_decorations(text, word, end)
        if name in self.functions:
            self._symbol(name, name_end)
            return
        if name == "and":
            self._add("AND", "and", name_end)
            return
        for length in range(len(word) - 1, 0, -1):
            if word[:length] in self.functions:
                self._symbol(word[:length], start + length)
                return
        raise self._undeclared(name)

    def _undeclared(self, name: str) -> ReaderError:
        near = nearest_names(name, self.functions)
        return self._error(f"the symbol {name} is not declared", name, near)

    def _command(self) -> None:
        text, start = self.text, self.position
        command = command_at(text, start)
        end = start + len(command)
        if command in SPACES:
            self.position = end
        elif command in WIDE_SPACES:
            self._add("WIDE", command, end)
        elif command in ("\\begin", "\\end"):
            self._environment(command, end)
        elif command in SIZES:
            self._add(*scan_sized(text, start, command))
        elif command in _TEXTS and (end_of_word := end_of_and(text, end)) is not None:
            self._add("AND", "and", end_of_word)
        elif command in COMMANDS:
            kind, value = COMMANDS[command]
            self._add(fraction_kind(text, end) if kind == "FRAC" else kind, value, end)
        elif (found := scan_base(text, start)) is not None:
            name, end = found if self.waiting else scan_decorations(text, *found)
            if name not in self.functions:
                raise self._undeclared(name)
            self._symbol(name, end)
        else:
            near = nearest_names(command, [*COMMANDS, *self.functions])
            raise self._error(f"the command {command} is not known", command, near)

    def _environment(self, command: str, end: int) -> None:
        """`aligned` round the whole formula, once: its lines are joined by `and`, its marks `&` say
        nothing.
        """
        place = end + len(_ENVIRONMENT)
        begins = command == "\\begin"
        if not self.text.startswith(_ENVIRONMENT, end) or self.environments != (not begins):
            raise self._error("only \\begin{aligned} ... \\end{aligned} is known, once", command)
        around = self.tokens if begins else self.text[skip_space(self.text, place) :]
        if around:
            raise self._error("aligned must stand round the whole formula", command)
        self.environments += 1
        self.position = place
