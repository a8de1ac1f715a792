"""Formulas in sentences: of `at \\sigma_o = 1 the left side is 5` which part is a formula, and its
LaTeX. What is a formula is seen from its signs; a sentence may be anybody's, so that only commands
that set mathematics are let through.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace

from gainproof.verify.judge.reader.alphabet import ACCENTS, GREEK, brace_partners, command_at
from gainproof.verify.judge.reader.words import FUNCTION_COMMANDS, FUNCTION_WORDS

_RELATIONS = {
    "->": r"\to",
    "<=": r"\leq",
    ">=": r"\geq",
    "!=": r"\neq",
    **{
        c: c
        for c in (
            "=",
            "<",
            ">",
            r"\to",
            r"\le",
            r"\leq",
            r"\ge",
            r"\geq",
            r"\ne",
            r"\neq",
            r"\approx",
        )
    },
}
_OPERATORS = {"+": "+", "-": "-", "*": r"\cdot", "/": "/", r"\cdot": r"\cdot", r"\times": r"\times"}
_OPEN = {"(": ")", "[": "]", r"\{": r"\}"}
_OPEN |= {rf"\left{bracket}": rf"\right{close}" for bracket, close in _OPEN.items()}
_COMMANDS = (
    (GREEK | ACCENTS | FUNCTION_COMMANDS.keys())
    - {r"\bm", r"\mathbb", r"\mathfrak", r"\mathscr", r"\underbar"}  # of packages, or of text only
) | {r"\frac", r"\sqrt", r"\partial", r"\infty"}
_ARTICLES = frozenset("aAI")
"""Letters that are words too."""
_NUMBER = re.compile(r"\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![A-Za-z]{2})")
_WORD = re.compile(r"[^\W\d_]+")
_NAME = re.compile(r"[A-Za-z]+(?:_[A-Za-z0-9]+)+")
_MATRIX = re.compile(r"\\begin\{([bp]?matrix)\}(.*?)\\end\{\1\}", re.DOTALL)
_SIGN = re.compile(r"->|<=|>=|!=|[-=<>+*/]")
_PLAIN = re.compile(r"[A-Za-z0-9 ,.+*'-]+")
"""What may stand in braces whatever it means."""
_LETTERS = re.compile(r"[A-Za-z0-9]+")
_POWER = re.compile(r"-?\d+|[A-Za-z]")
_UNIT = r"(?!and\b)[A-Za-z]{1,3}(?:\^-?\d+)?"
_UNITS = re.compile(rf"\b(?:{_UNIT} )*(?!and\b)[A-Za-z]{{1,3}}\^-?\d+(?: {_UNIT}\b)*")
_DIMENSIONS = re.compile(r"\bdimensions? [^;:,]*")
_DEEPEST = 20
"""Brackets in brackets that are followed."""


@dataclass(frozen=True)
class _Part:
    """A part of a sentence that may belong to a formula, where it ends, and its LaTeX. `sure`:
    nobody writes so but in a formula; `letters`: letters by themselves that may as well be words;
    `signs`: whether it has relations, or operators set apart by blanks; `relation`: the former.
    """

    end: int
    latex: str
    sure: bool = False
    letters: tuple[str, ...] = ()
    signs: bool = False
    relation: bool = False


def pieces(sentence: str, symbols: Collection[str] = ()) -> Iterator[tuple[bool, str]]:
    """The sentence in pieces: (True, LaTeX of a formula) or (False, plain text). `symbols` are
    those that are known to be meant, as they are written.
    """
    start = 0
    for match in _DIMENSIONS.finditer(sentence):
        yield from _Sentence(sentence[start : match.start()], symbols).pieces()
        place = match.start()
        for units in _UNITS.finditer(sentence, match.start(), match.end()):
            yield False, sentence[place : units.start()]
            raised = re.sub(r"\^(-?\d+)", r"^{\1}", units[0]).replace(" ", r"\,")
            yield True, rf"\mathrm{{{raised}}}"
            place = units.end()
        yield False, sentence[place : match.end()]
        start = match.end()
    yield from _Sentence(sentence[start:], symbols).pieces()


def written(
    sentence: str,
    symbols: Collection[str],
    text: Callable[[str], str],
    formula: Callable[[str], str] = "${}$".format,
) -> str:
    """The sentence with its text and its formulas each written as is said."""
    parts = pieces(sentence, symbols)
    return "".join(formula(part) if is_formula else text(part) for is_formula, part in parts)


class _Sentence:
    """One sentence with the symbols that are known."""

    def __init__(self, text: str, symbols: Collection[str]) -> None:
        self.text = text
        self.known = frozenset(symbols)
        self.longest = sorted(self.known, key=len, reverse=True)
        self.partners = brace_partners(text)

    def pieces(self) -> Iterator[tuple[bool, str]]:
        text, start, place = self.text, 0, 0
        while place < len(text):
            found = self.formula(place, 0) if self._may_begin(place) else None
            if found is None or not self._is_formula(found):
                place = self._next(place)
                continue
            if start < place:
                yield False, text[start:place]
            yield True, found.latex
            start = place = found.end
        if start < len(text):
            yield False, text[start:]

    def _may_begin(self, place: int) -> bool:
        before = self.text[place - 1 : place]
        return not self.text[place].isspace() and not before.isalnum() and before not in ("\\", "'")

    def _next(self, place: int) -> int:
        """Behind the word, number or sign that begins here."""
        if self.text[place] == "\\":
            return place + max(len(command_at(self.text, place)), 1)
        match = re.compile(r"[\w']+").match(self.text, place)
        return match.end() if match else place + 1

    def _is_formula(self, found: _Part) -> bool:
        if found.sure or (found.letters and found.signs):
            return True
        numbered = re.search(r"\d[A-Za-z]", found.latex)  # 17a
        known = found.letters and not numbered and self.known.issuperset(found.letters)
        named = self.text[found.end : found.end + 1] == ":"
        return bool(known) and (named or found.latex not in _ARTICLES)

    def formula(self, place: int, depth: int) -> _Part | None:
        """The longest formula from here on; None if there is none."""
        sign = "-" if self.text[place] == "-" else ""
        first = self._operand(place + len(sign), depth)
        if first is None:
            return None
        whole = _joined(_Part(place, sign), first, "")
        while (more := self._continued(whole, depth)) is not None:
            whole = more
        return whole

    def _continued(self, whole: _Part, depth: int) -> _Part | None:
        blanks = self._blanks(whole.end)
        apart = " " if blanks > whole.end else ""
        sign = self._sign(blanks)
        if sign is None:
            if whole.latex in _ARTICLES and apart:
                return None
            follower = self._operand(blanks, depth)
            joins = follower is not None and self._stands_beside(blanks, follower, apart)
            return _joined(whole, follower, apart) if follower and joins else None
        relation = sign in _RELATIONS
        behind = self._blanks(blanks + len(sign))
        spaced = bool(apart) and behind > blanks + len(sign)
        minus = "-" if relation and self.text[behind : behind + 1] == "-" else ""
        follower = self._operand(behind + len(minus), depth)
        if follower is None:
            return None
        if not relation and not spaced and sign == "-" and whole.letters and follower.letters:
            return None  # a hyphen
        latex = _RELATIONS[sign] if relation else _OPERATORS[sign]
        if sign == "*" and not follower.latex[0].isdigit():
            latex = r"\,"
        gap = " " if spaced or latex.startswith("\\") else ""
        joined = _joined(whole, follower, f"{gap}{latex}{gap}{minus}")
        return _Part(
            joined.end,
            joined.latex,
            joined.sure,
            joined.letters,
            joined.signs or relation or spaced,
            whole.relation or follower.relation or relation,
        )

    def _stands_beside(self, place: int, follower: _Part, apart: str) -> bool:
        """Whether what follows without a sign between is a factor."""
        first = self.text[place]
        if first.isdigit():
            return False
        if first in "([" and apart:
            return not follower.relation and (follower.sure or follower.signs)
        if apart and follower.latex in _ARTICLES:
            is_word = re.match(r" [A-Za-z]{2}", self.text[follower.end : follower.end + 3])
            return follower.latex in self.known and not is_word
        return True

    def _blanks(self, place: int) -> int:
        while self.text[place : place + 1] == " ":
            place += 1
        return place

    def _sign(self, place: int) -> str | None:
        if self.text[place : place + 1] == "\\":
            command = command_at(self.text, place)
            return command if command in _RELATIONS or command in _OPERATORS else None
        match = _SIGN.match(self.text, place)
        return match[0] if match else None

    def _operand(self, place: int, depth: int) -> _Part | None:
        if place >= len(self.text) or depth > _DEEPEST:
            return None
        text, character = self.text, self.text[place]
        for symbol in self.longest:
            end = place + len(symbol)
            if text.startswith(symbol, place) and not re.match(r"[A-Za-z0-9]", text[end : end + 1]):
                if len(symbol) == 1:
                    break
                plain = symbol if "\\" in symbol or "_" in symbol else rf"\mathit{{{symbol}}}"
                return self._scripts(_Part(end, plain, sure=True), depth)
        for bracket in _OPEN:
            if text.startswith(bracket, place):
                return self._bracketed(place, bracket, depth)
        if character == "\\":
            return self._command(place, depth)
        if number := _NUMBER.match(text, place):
            return self._scripts(_Part(number.end(), number[0]), depth)
        word = _WORD.match(text, place)
        if word is None or not word[0].isascii():
            return None
        if len(word[0]) == 1:
            primes = re.compile(r"'*(?![A-Za-z])").match(text, word.end())
            end = primes.end() if primes else word.end()
            if re.match(r"\d", text[end : end + 1]):
                return None
            letter = text[place:end]
            return self._scripts(_Part(end, letter, letters=(letter,)), depth)
        return self._named(place, word, depth)

    def _named(self, place: int, word: re.Match[str], depth: int) -> _Part | None:
        text, behind = self.text, self._blanks(word.end())
        if word[0] == "sqrt" and (root := self._operand(behind, depth + 1)) is not None:
            inner = root.latex
            if text[behind] == "(":
                inner = inner[1:-1]
            return self._scripts(_Part(root.end, rf"\sqrt{{{inner}}}", sure=True), depth)
        if word[0] in FUNCTION_WORDS and text[word.end() : word.end() + 1] in ("(", "^"):
            return self._scripts(
                _Part(word.end(), rf"\operatorname{{{word[0]}}}", sure=True), depth
            )
        if word[0] in ("pi", "infinity"):
            latex = r"\pi" if word[0] == "pi" else r"\infty"
            return self._scripts(_Part(word.end(), latex, letters=(word[0],)), depth)
        name = _NAME.match(text, place)
        if name is None:
            return None
        shown = rf"\text{{{name[0].replace('_', ' ')}}}"
        return self._scripts(_Part(name.end(), shown, letters=(name[0],)), depth)

    def _command(self, place: int, depth: int) -> _Part | None:
        text, command = self.text, command_at(self.text, place)
        if command == r"\begin" and (found := self._matrix(place, depth)) is not None:
            return self._scripts(found, depth)
        if command not in _COMMANDS:
            return None
        end = place + len(command)
        if command == r"\sqrt" and (index := re.compile(r"\[\d+\]").match(text, end)):
            end = index.end()
        groups = []
        while text[end : end + 1] == "{" and end in self.partners:
            groups.append(text[end + 1 : self.partners[end]])
            end = self.partners[end] + 1
        asked = 2 if command == r"\frac" else int(command in ACCENTS or command == r"\sqrt")
        if len(groups) != asked or not all(_is_whole(group, depth + 1) for group in groups):
            return None
        return self._scripts(_Part(end, text[place:end], sure=True), depth)

    def _matrix(self, place: int, depth: int) -> _Part | None:
        match = _MATRIX.match(self.text, place)
        if match is None:
            return None
        cells = (cell.strip() for cell in re.split(r"\\\\|&", match[2]))
        whole = all(not cell or _is_whole(cell, depth + 1) for cell in cells)
        return _Part(match.end(), match[0], sure=True) if whole else None

    def _bracketed(self, place: int, bracket: str, depth: int) -> _Part | None:
        start = self._blanks(place + len(bracket))
        inner = self.formula(start, depth + 1) if start < len(self.text) else None
        if inner is None:
            return None
        latex, end = inner.latex, self._blanks(inner.end)
        sure, letters, signs = inner.sure, inner.letters, inner.signs
        while self.text[end : end + 1] == ",":
            start = self._blanks(end + 1)
            more = self.formula(start, depth + 1) if start < len(self.text) else None
            if more is None:
                return None
            latex, end = f"{latex}, {more.latex}", self._blanks(more.end)
            sure, letters = sure or more.sure, letters + more.letters
        if not self.text.startswith(_OPEN[bracket], end):
            return None
        close = _OPEN[bracket]
        whole = _Part(
            end + len(close), f"{bracket}{latex}{close}", sure, letters, signs, inner.relation
        )
        return self._scripts(whole, depth)

    def _scripts(self, part: _Part, depth: int) -> _Part | None:
        """With its subscript and its power; None where one is begun that cannot be set."""
        below = above = False
        while True:
            if self.text.startswith("|_", part.end):
                latex = f"{part.latex}|"
                part, below = replace(part, end=part.end + 1, latex=latex, sure=True), False
            mark = self.text[part.end : part.end + 1]
            if not mark or mark not in "_^":
                return part
            found = self._script(mark, part.end + 1, depth)
            if found is None:
                return None
            latex = part.latex
            if (mark == "_" and below) or (mark == "^" and above):
                latex, below, above = f"{{{latex}}}", False, False
            below, above = below or mark == "_", above or mark == "^"
            part = _Part(found.end, f"{latex}{mark}{found.latex}", sure=True)

    def _script(self, mark: str, place: int, depth: int) -> _Part | None:
        text, character = self.text, self.text[place : place + 1]
        if character == "{" and place in self.partners:
            end = self.partners[place] + 1
            whole = _is_whole(text[place + 1 : end - 1], depth + 1)
            return _Part(end, text[place:end]) if whole else None
        if character == "\\":
            command = command_at(text, place)
            known = command in GREEK or command == r"\infty"
            return _Part(place + len(command), f"{{{command}}}") if known else None
        if character == "(" and mark == "^":
            inner = self._bracketed(place, "(", depth + 1)
            return inner and _Part(inner.end, f"{{{inner.latex[1:-1]}}}")
        match = (_LETTERS if mark == "_" else _POWER).match(text, place)
        if match is None:
            return None
        return _Part(match.end(), match[0] if len(match[0]) == 1 else f"{{{match[0]}}}")


def is_formula(latex: str) -> bool:
    """Whether all of it is one formula in LaTeX that can be set."""
    return "\\" in latex and _is_whole(latex, 0)


def _is_whole(latex: str, depth: int) -> bool:
    if _PLAIN.fullmatch(latex):
        return True
    sentence = _Sentence(latex, ())
    found = sentence.formula(0, depth) if latex.strip() else None
    return found is not None and not latex[found.end :].strip()


def _joined(first: _Part, second: _Part, between: str) -> _Part:
    return _Part(
        second.end,
        f"{first.latex}{between}{second.latex}",
        first.sure or second.sure,
        first.letters + second.letters,
        first.signs or second.signs,
        first.relation or second.relation,
    )
