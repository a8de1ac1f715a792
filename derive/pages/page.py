"""Pages as they are written: the blocks of a text file, read with their lines and printed back.

A blank line stands between blocks; the first line of a block says what it is.

    # Title                             and beneath it what the page is about
    names                             quantities, and what certificates call them: one a line
    let                               names for formulas, and functions of them
    setting NAME                      parameters, then what quantities are in them; with no line
                                      beneath one that the program makes
    matrices NAME                     letters of any size, and what some of them stand for
    ## Heading (if SLOT)
    ### id (in NAME, if SLOT, hidden, essential)   one step, with its sentence beneath
        statement                     indented: what it says, see `statement`
        id (...): statement           more, shown together with the first
    because ...                       why it follows
    hint id                           what a proof uses besides, see `hints`: one a line
    kernel NAME (in NAME)             its outputs that are no quantity of their name, and its roots
    include PART (SLOTS)              the blocks of another file, with values for its slots; which
                                      one a slot may say, {name}, and that it is none
    steps NAME                        steps that the program makes, of that name; indented, in place
                                      of a statement, they are shown with those of the step

`in main` is not said, nor is that a step is not essential. Prose is filled to 100 columns, formulas
are continued on lines that are indented further.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NoReturn

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.formula import NAME, Formula, FormulaError, read_formula
from gainproof.derive.pages.statement import Statement, read_statement

MAXIMUM_LINES = 5000
WIDTH = 100
_ID = r"[A-Za-z0-9{}_-]+"
_MARK = re.compile(
    rf"({_ID})(?: \((?=\w)(?:in ([A-Za-z0-9{{}}_]+))?(?:, |\b)?(?:if ({NAME}))?(?:, |\b)?(hidden)?"
    r"(?:, |\b)?(essential)?\))?"
)
_ITEM = re.compile(rf"(?:({_ID}(?: \([^)]*\))?): )?(.+)")
_MADE = re.compile(r"steps ([a-z0-9-]+)")
_TOLD = ("theorem: ", "in words: ")
_THEOREM = re.compile(r"theorem: (.+) \[([a-z0-9-]+)\]")
_PLAIN = re.compile(rf"{NAME}'?(?:, {NAME}'?)*")
_NAMES = re.compile(
    rf"(?P<name>{NAME}'?) = (?P<meaning>[A-Za-z0-9{{}}_]+)(?: as (?P<printed>{NAME}))?"
    r"(?: for (?P<variable>[a-z]+) in (?P<values>[a-z0-9]+(?:, [a-z0-9]+)*))?"
)
_DEFINED = re.compile(rf"({NAME}'?)(?:\(({NAME}(?:, {NAME})*)\))? = (.+)")
_LETTER = re.compile(rf"({NAME})(?: = ({NAME}))?(?: as ([A-Za-z0-9_+|]+))?")
_SIZE = rf"(?:1|{NAME})"
_WHAT = re.compile(
    rf"(.+): ({_SIZE} by {_SIZE}|positive|real|(?:unit|blocks) of {_SIZE}|with inverse)"
)
_PARAMETER = re.compile(rf"({NAME}) (>=?) (0|[1-9]\d*)")


@dataclass(frozen=True)
class Place:
    """A line of a file."""

    file: str
    line: int

    def error(self, text: str) -> PageError:
        """What is wrong there."""
        return PageError(f"{self.file}, line {self.line}: {text}")


@dataclass(frozen=True)
class Prose:
    """A title or heading, with the text beneath."""

    mark: str
    head: str
    text: str
    place: Place

    def __str__(self) -> str:
        return "\n".join([f"{self.mark} {self.head}", *([_filled(self.text)] if self.text else [])])


@dataclass(frozen=True)
class Theorem:
    """A theorem that is cited, by the key of its source."""

    text: str
    source: str

    def __str__(self) -> str:
        return f"theorem: {self.text} [{self.source}]"


@dataclass(frozen=True)
class InWords:
    """A definition in words."""

    text: str

    def __str__(self) -> str:
        return f"in words: {self.text}"


@dataclass(frozen=True)
class Made:
    """Statements that the program makes, under the sentence of the page."""

    name: str

    def __str__(self) -> str:
        return f"steps {self.name}"


@dataclass(frozen=True)
class Mark:
    """The id of a statement and what is said of it; no setting: main, or that of the step.

    `condition`: a slot; where that is empty the statement is not there, nor those of its step.
    """

    id: str = ""
    setting: str = ""
    condition: str = ""
    hidden: bool = False
    essential: bool = False

    def __str__(self) -> str:
        said = [f"in {self.setting}"] if self.setting else []
        said += [f"if {self.condition}"] if self.condition else []
        said += ["hidden"] * self.hidden + ["essential"] * self.essential
        return f"{self.id} ({', '.join(said)})" if said else self.id


@dataclass(frozen=True)
class Item:
    """One statement of a step; the first is marked by the step."""

    mark: Mark
    said: Statement | Theorem | InWords | Made
    place: Place

    def __str__(self) -> str:
        return f"{self.mark}: {self.said}" if self.mark.id else str(self.said)


@dataclass(frozen=True)
class PageStep:
    """One step: the statements that are shown together under a sentence, with one reason."""

    mark: Mark
    sentence: str
    items: tuple[Item, ...]
    reason: str
    place: Place

    def __str__(self) -> str:
        head = f"### {self.mark}\n{_filled(self.sentence)}"
        texts = [head, "\n".join(map(_indented, self.items))]
        return "\n\n".join([*texts, *([_filled(f"because {self.reason}")] if self.reason else [])])


@dataclass(frozen=True)
class Line:
    """One line of a block of names, definitions or outputs, read.

    Of names: `printed`, the name as which one is printed; the `values` of a `variable` at the end.
    """

    name: str
    meaning: str | Formula
    arguments: tuple[str, ...] = ()
    printed: str = ""
    variable: str = ""
    values: tuple[str, ...] = ()
    place: Place = Place("", 0)

    @property
    def is_plain(self) -> bool:
        """Whether it is of names, apart by commas, that certificates have too."""
        return self.meaning == self.name and not self.values

    def __str__(self) -> str:
        called = f"{self.name}({', '.join(self.arguments)})" if self.arguments else self.name
        if self.is_plain:
            return called
        ranges = f" for {self.variable} in {', '.join(self.values)}" if self.values else ""
        printed = f" as {self.printed}" if self.printed else ""
        return f"{called} = {self.meaning}{printed}{ranges}"


@dataclass(frozen=True)
class LetterLine:
    """Letters of a block of matrices: each with its name in certificates and as printed; what they
    are.
    """

    letters: tuple[tuple[str, str, str], ...]
    what: str
    place: Place = Place("", 0)

    def __str__(self) -> str:
        listed = (
            name + f" = {quantity}" * bool(quantity) + f" as {printed}" * bool(printed)
            for name, quantity, printed in self.letters
        )
        return f"{', '.join(listed)}: {self.what}"


@dataclass(frozen=True)
class Block:
    """A block of lines: names, let, setting, matrices or kernel; `parameters` of a setting, inputs
    first; `letters` of matrices, before their lines.
    """

    kind: str
    name: str
    setting: str
    parameters: tuple[tuple[str, str, str], ...]
    lines: tuple[Line, ...]
    place: Place
    letters: tuple[LetterLine, ...] = ()

    def __str__(self) -> str:
        head = " ".join(filter(None, (self.kind, self.name)))
        lines: list[object] = [*self.letters, *self.lines]
        if self.parameters:
            lines.insert(0, ", ".join(map(" ".join, self.parameters)))
        place = f" (in {self.setting})" if self.setting != "main" else ""
        return "\n".join([f"{head}{place}", *map(_indented, lines)])


@dataclass(frozen=True)
class Include:
    """The blocks of a part, with values for its slots; or steps that the program makes."""

    kind: str
    part: str
    slots: str
    place: Place

    def __str__(self) -> str:
        return f"{self.kind} {self.part}" + (f" ({self.slots})" if self.slots else "")


@dataclass(frozen=True)
class Hint:
    """The hint for a statement: lines of `hints`."""

    id: str
    lines: tuple[str, ...]
    place: Place

    def __str__(self) -> str:
        return "\n".join([f"hint {self.id}", *map(_indented, self.lines)])


PageBlock = Prose | PageStep | Block | Include | Hint


@dataclass(frozen=True)
class Page:
    """A file, read."""

    file: str
    blocks: tuple[PageBlock, ...]

    def __str__(self) -> str:
        """The file's text."""
        return "\n\n".join(map(str, self.blocks)) + "\n"


def _filled(text: str) -> str:
    return textwrap.fill(text, WIDTH, break_long_words=False, break_on_hyphens=False)


def _indented(line: object) -> str:
    return textwrap.fill(
        str(line),
        WIDTH,
        initial_indent=" " * 4,
        subsequent_indent=" " * 8,
        break_long_words=False,
        break_on_hyphens=False,
    )


Numbered = list[tuple[int, str]]


def read_page(text: str, file: str, primed: frozenset[str] = frozenset()) -> Page:
    """A page from its text; `file` is its name in errors. Raises PageError.

    `primed`: names with ' of a page that includes this one.
    """
    return Page(file, tuple(_Reading(file, primed).blocks(text)))


@dataclass
class _Reading:
    file: str
    primed: frozenset[str] = frozenset()

    def blocks(self, text: str) -> Iterator[PageBlock]:
        chunks = list(self._chunks(text))
        while chunks:
            number, first = chunks[0][0]
            kind = first.split(" ")[0]
            if kind == "###":
                end = 1
                while end < len(chunks) and chunks[end][0][1].startswith((" ", "because ")):
                    end += 1
                yield self._step(chunks[:end])
                del chunks[:end]
                continue
            rest = chunks.pop(0)
            match kind:
                case "#" | "##":
                    yield Prose(
                        kind, first[len(kind) + 1 :], self._prose(rest[1:]), self._at(number)
                    )
                case "names" | "let" | "setting" | "matrices" | "kernel":
                    yield self._block(kind, rest)
                case "hint":
                    lines = tuple(text for _, text in self._lines(rest[1:]))
                    yield Hint(first.removeprefix("hint "), lines, self._at(number))
                case "include" | "steps":
                    yield self._include(kind, rest)
                case _:
                    self._at_error(
                        number,
                        "a block is wanted that starts with #, ##, ###, names, let, setting, "
                        f"matrices, hint, kernel, include or steps, {first.strip()[:40]!r} came",
                    )

    def _chunks(self, text: str) -> Iterator[Numbered]:
        lines = text.split("\n")
        if len(lines) > MAXIMUM_LINES:
            self._at_error(MAXIMUM_LINES, f"at most {MAXIMUM_LINES} lines are wanted")
        chunk: Numbered = []
        for number, line in enumerate([*lines, ""], 1):
            if not line.isprintable():
                self._at_error(number, "a sign that is not printed, such as a tab")
            if line.rstrip() != line:
                self._at_error(number, "blanks at the end of the line")
            if line:
                chunk.append((number, line))
            elif chunk:
                yield chunk
                chunk = []

    def _at(self, number: int) -> Place:
        return Place(self.file, number)

    def _at_error(self, number: int, text: str) -> NoReturn:
        raise self._at(number).error(text)

    def _step(self, chunks: list[Numbered]) -> PageStep:
        (number, first), *beneath = chunks[0]
        mark = self._mark(number, first.removeprefix("### "))
        if not beneath:
            self._at_error(number, f"a sentence is wanted beneath ### {mark.id}")
        if len(chunks) < 2 or not chunks[1][0][1].startswith(" "):
            self._at_error(
                beneath[-1][0] + 1, "an indented statement is wanted, after a blank line"
            )
        if len(chunks) > 3 or (len(chunks) == 3 and chunks[2][0][1].startswith(" ")):
            self._at_error(chunks[-1][0][0], "one block of statements and one reason are wanted")
        items = tuple(self._items(chunks[1]))
        reason = self._prose(chunks[2]).removeprefix("because ") if len(chunks) == 3 else ""
        return PageStep(mark, self._prose(beneath), items, reason, self._at(number))

    def _prose(self, lines: Numbered) -> str:
        """A sentence or several, each formula in a pair of backticks."""
        text = " ".join(line.strip() for _, line in lines)
        if text.count("`") % 2:
            odd = [number for number, line in lines if line.count("`") % 2]
            self._at_error(odd[-1], "a formula stands between two backticks, one is alone here")
        return text

    def _mark(self, number: int, text: str) -> Mark:
        match = _MARK.fullmatch(text)
        mark = match and Mark(
            match[1], match[2] or "", match[3] or "", bool(match[4]), bool(match[5])
        )
        if mark is None or str(mark) != text:
            wanted = "id (in NAME, if SLOT, hidden, essential)"
            self._at_error(number, f"{wanted!r} is wanted, in this order, {text!r} came")
        return mark

    def _items(self, chunk: Numbered) -> Iterator[Item]:
        for place, (number, text) in enumerate(self._lines(chunk)):
            if made := _MADE.fullmatch(text):
                yield Item(Mark(), Made(made[1]), self._at(number))
                continue
            match = None if text.startswith(_TOLD) else _ITEM.fullmatch(text)
            named = match is not None and bool(match[1])
            if named is (place == 0):
                wanted = "'id: statement'" if place else "a statement without an id"
                self._at_error(number, f"{wanted} is wanted, {text[:40]!r} came")
            mark = self._mark(number, match[1]) if match and match[1] else Mark()
            yield Item(mark, self._said(number, match[2] if match else text), self._at(number))

    def _said(self, number: int, text: str) -> Statement | Theorem | InWords:
        if text.startswith(_TOLD):
            return self._told(number, text)
        try:
            return read_statement(text, self.primed)
        except FormulaError as error:
            self._at_error(number, str(error))

    def _told(self, number: int, text: str) -> Theorem | InWords:
        if text.startswith("in words: "):
            return InWords(text.removeprefix("in words: "))
        match = _THEOREM.fullmatch(text)
        if match is None:
            self._at_error(number, f"'theorem: text [key of a source]' is wanted, {text!r} came")
        return Theorem(match[1], match[2])

    def _lines(self, chunk: Numbered) -> list[tuple[int, str]]:
        """Indented lines, those that go on put together."""
        found: list[tuple[int, str]] = []
        for number, line in chunk:
            depth = len(line) - len(line.lstrip())
            if depth > 4 and found:
                found[-1] = (found[-1][0], f"{found[-1][1]} {line.strip()}")
            elif depth == 4:
                found.append((number, line.strip()))
            else:
                self._at_error(
                    number, f"4 blanks are wanted, more to go on with a line, {depth} came"
                )
        return found

    def _block(self, kind: str, chunk: Numbered) -> Block:
        (number, first), *beneath = chunk
        match = re.fullmatch(rf"{kind}(?: ({NAME}))?(?: \(in ({NAME})\))?", first)
        named, placed = kind in ("setting", "matrices", "kernel"), kind == "kernel"
        if match is None or bool(match[1]) is not named or (match[2] and not placed):
            wanted = f"{kind}{' NAME' * named}{' (in NAME)' * placed}"
            self._at_error(number, f"{wanted} is wanted, {first!r} came")
        lines = self._lines(beneath)
        if not lines and kind not in ("setting", "kernel"):
            self._at_error(number, f"indented lines are wanted beneath {first!r}")
        inputs = kind == "setting" and lines and " = " not in lines[0][1]
        parameters = self._parameters(lines.pop(0)) if inputs else ()
        letters = []
        while kind == "matrices" and lines and (shape := _WHAT.fullmatch(lines[0][1])):
            letters.append(self._letters(lines.pop(0)[0], *shape.groups()))
        read = {"names": self._name}.get(kind, self._definition)
        made = tuple(read(*line) for line in lines)
        place = self._at(number)
        name, setting = match[1] or "", match[2] or "main"
        return Block(kind, name, setting, parameters, made, place, tuple(letters))

    def _letters(self, number: int, listed: str, what: str) -> LetterLine:
        found = []
        for text in listed.split(", "):
            match = _LETTER.fullmatch(text)
            if match is None:
                self._at_error(number, f"'letter' or 'letter = quantity' is wanted, {text!r} came")
            name, quantity, printed = match.groups(default="")
            found.append((name, quantity, printed))
        return LetterLine(tuple(found), what, self._at(number))

    def _parameters(self, line: tuple[int, str]) -> tuple[tuple[str, str, str], ...]:
        found = []
        for text in line[1].split(", "):
            match = _PARAMETER.fullmatch(text)
            if match is None:
                self._at_error(
                    line[0], f"parameters are wanted as in 'x > 0, y >= 0', {text!r} came"
                )
            found.append((match[1], match[2], match[3]))
        return tuple(found)

    def _name(self, number: int, text: str) -> Line:
        if _PLAIN.fullmatch(text):
            self.primed |= {name for name in text.split(", ") if name.endswith("'")}
            return Line(text, text, place=self._at(number))
        match = _NAMES.fullmatch(text)
        if match is None:
            self._at_error(
                number,
                "'name, name', 'name = quantity' or 'P_ij = p_ij as Q_ij for ij in 11, 12' is "
                f"wanted, {text!r} came",
            )
        name, meaning, printed, variable, values = match.groups(default="")
        if name.endswith("'"):
            self.primed |= {name}
        listed = tuple(values.split(", ")) if values else ()
        return Line(name, meaning, (), printed, variable, listed, self._at(number))

    def _definition(self, number: int, text: str) -> Line:
        match = _DEFINED.fullmatch(text)
        if match is None:
            self._at_error(number, f"'name = formula' is wanted, {text[:40]!r} came")
        arguments = tuple(match[2].split(", ")) if match[2] else ()
        try:
            formula = read_formula(match[3], self.primed)
        except FormulaError as error:
            self._at_error(number, str(error))
        return Line(match[1], formula, arguments, place=self._at(number))

    def _include(self, kind: str, chunk: Numbered) -> Include:
        number, text = chunk[0]
        slots = rf"(?: \(({NAME})\))?" if kind == "include" else "()"
        match = re.fullmatch(rf"{kind} ([a-z0-9-]+|{{{NAME}}}){slots}", text)
        if match is None or len(chunk) > 1:
            self._at_error(number, f"{kind} NAME is wanted, alone, {text!r} came")
        return Include(kind, match[1], match[2] or "", self._at(number))
