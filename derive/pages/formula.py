"""The notation of formulas on pages: read, printed back and compared.

    2 e^2/(1 + e)    A P A' + K K'    P H' S^-1    [alpha, beta]    [1, T; 0, 1]    index(n)

Factors stand beside each other, apart by a blank; what is divided by is one factor. `'` transposes,
a comma ends an entry of a matrix and a semicolon its row. A name followed at once by a parenthesis
is a function. `{name}` is a slot, whose value comes with the page. There is one way to write a
formula: what is printed from what was read is compared with what was written, and where they differ
the formula is refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import TypeVar

Read = TypeVar("Read")
MAXIMUM_CHARACTERS = 4000
MAXIMUM_DEPTH = 40
MAXIMUM_EXPONENT = 16
MAXIMUM_DIGITS = 40
AROUND = 30
RESERVED = frozenset(
    [
        "and",
        "as",
        "falls",
        "for",
        "from",
        "grows",
        "has",
        "if",
        "in",
        "infinity",
        "is",
        "over",
        "stands",
        "to",
        "where",
        "with",
    ]
)
"""What may stand behind a formula; no quantity has such a name."""
NAME = r"[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*"
CLOSED = {")": "(", "]": "[", "}": "{"}
_TOKEN = re.compile(rf"(?P<blank> *)(?P<text>{NAME}|\d+|->|>=|[-+/^()\[\],;'{{}}=>])")


class FormulaError(ValueError):
    """A formula that is none of this notation; says what was wanted and what came."""

    def __init__(self, text: str, wanted: str = "") -> None:
        super().__init__(text)
        self.wanted = wanted


def nearest(name: str, known: Iterable[str], most: int = 1) -> list[str]:
    """Known names that resemble one, best first, whatever is written large: `beta` of `Beta`."""
    folded = {each.casefold(): each for each in sorted(known)}
    return [folded[each] for each in get_close_matches(name.casefold(), folded, most)]


@dataclass(frozen=True)
class Formula:
    """One node: number, name, slot, add, neg, mul, div, pow, call, matrix, transpose, inverse or
    names.

    `text`: the number, the name, the exponent, or the columns of a matrix.
    """

    kind: str
    text: str = ""
    parts: tuple[Formula, ...] = ()

    def __str__(self) -> str:
        """As it is written."""
        return _printed(self)


@dataclass(frozen=True)
class Token:
    """A piece of text, and whether it follows the one before it at once."""

    text: str
    close: bool

    @property
    def is_name(self) -> bool:
        """Whether it is the name of a quantity."""
        return self.text[:1].isalpha() and self.text not in RESERVED


def tokens_of(text: str, primed: frozenset[str] = frozenset()) -> list[Token]:
    """The pieces of a line; names that end with ' are those of `primed`. Raises FormulaError."""
    if len(text) > MAXIMUM_CHARACTERS:
        raise FormulaError(f"at most {MAXIMUM_CHARACTERS} characters are wanted, {len(text)} came")
    found: list[Token] = []
    place = 0
    while place < len(text):
        match = _TOKEN.match(text, place)
        if match is None:
            raise FormulaError(f"{text[place:].strip()[:1]!r} is no part of a formula")
        piece = match["text"]
        place = match.end()
        while text[place : place + 1] == "'" and piece + "'" in primed:
            piece, place = piece + "'", place + 1
        if piece.isdigit() and (len(piece) > MAXIMUM_DIGITS or str(int(piece)) != piece):
            raise FormulaError(f"a number of at most {MAXIMUM_DIGITS} digits is wanted: {piece}")
        found.append(Token(piece, not match["blank"]))
    return found


@dataclass
class Reader:
    """Reads formulas from pieces, from left to right. Raises FormulaError."""

    tokens: list[Token]
    place: int = 0
    depth: int = field(default=0, repr=False)

    @property
    def next(self) -> str:
        """The next piece; nothing at the end."""
        return self.tokens[self.place].text if self.place < len(self.tokens) else ""

    def take(self, wanted: str) -> None:
        """Go past a piece."""
        if self.next != wanted:
            raise self.error(f"{wanted!r}")
        self.place += 1

    def name(self) -> str:
        """Go past a name."""
        if not self.next or not self.tokens[self.place].is_name:
            raise self.error("a name")
        self.place += 1
        return self.tokens[self.place - 1].text

    def slot(self) -> Formula:
        """Go past a slot."""
        self.take("{")
        name = self.name()
        self.take("}")
        return Formula("slot", name)

    def error(self, wanted: str) -> FormulaError:
        """What was wanted here, and what came."""
        came = repr(self.next) if self.next else "the end of the line"
        before = [each.text for each in self.tokens[: self.place]]
        behind = f" after {' '.join(before[-3:])!r}" if before else ""
        opening = CLOSED.get(self.next, "")
        if opening and before.count(opening) <= before.count(self.next):
            return FormulaError(f"{self.next!r} without {opening!r}{behind}", wanted)
        return FormulaError(f"wanted {wanted}{behind}, came {came}", wanted)

    def formula(self) -> Formula:
        """A sum, as long as it goes on."""
        self.depth += 1
        if self.depth > MAXIMUM_DEPTH:
            raise FormulaError(f"parentheses are nested more than {MAXIMUM_DEPTH} deep")
        parts = [self._signed()]
        while self.next in ("+", "-"):
            parts.append(self._signed(first=False))
        self.depth -= 1
        return parts[0] if len(parts) == 1 else Formula("add", "", tuple(parts))

    def _signed(self, first: bool = True) -> Formula:
        sign = self.next if self.next == "-" or not first else ""
        self.place += len(sign)
        term = self._term()
        return Formula("neg", "", (term,)) if sign == "-" else term

    def _term(self) -> Formula:
        factors = [self._factor()]
        while self._starts_factor():
            factors.append(self._factor())
        above = factors[0] if len(factors) == 1 else Formula("mul", "", tuple(factors))
        if self.next != "/":
            return above
        self.place += 1
        below = self._factor()
        if self._starts_factor() or self.next == "/":
            raise FormulaError(
                f"wanted parentheses around the quotient that ends with /{below}, or around all "
                f"that is divided by; {self.next!r} came"
            )
        return Formula("div", "", (above, below))

    def _starts_factor(self) -> bool:
        return self.next != "" and (
            self.next[0].isdigit() or self.next in "([{" or self.tokens[self.place].is_name
        )

    def _factor(self) -> Formula:
        found = self._atom()
        while self.next == "'":
            self.place += 1
            found = Formula("transpose", "", (found,))
        if self.next == "^":
            self.place += 1
            if self.next == "-":
                self.place += 1
                self.take("1")
                return Formula("inverse", "", (found,))
            exponent = self.next
            if not exponent.isdigit() or not 2 <= int(exponent) <= MAXIMUM_EXPONENT:
                raise self.error(f"a whole number from 2 to {MAXIMUM_EXPONENT}")
            self.place += 1
            found = Formula("pow", exponent, (found,))
        return found

    def _atom(self) -> Formula:
        text = self.next
        if text.isdigit():
            self.place += 1
            return Formula("number", text)
        if text in ("(", "["):
            self.place += 1
            if text == "[":
                return self._matrix()
            inside = self.formula()
            self.take(")")
            return inside
        if text == "{":
            return self.slot()
        name = self.name()
        if self.next == "(" and self.tokens[self.place].close:
            self.place += 1
            return Formula("call", name, self._listed(")"))
        return Formula("name", name)

    def _listed(self, end: str) -> tuple[Formula, ...]:
        parts = [self.formula()]
        while self.next == ",":
            self.place += 1
            parts.append(self.formula())
        self.take(end)
        return tuple(parts)

    def _matrix(self) -> Formula:
        rows = [[self.formula()]]
        while self.next in (",", ";"):
            if self.next == ";":
                rows.append([])
            self.place += 1
            rows[-1].append(self.formula())
        self.take("]")
        if len({len(row) for row in rows}) > 1:
            raise FormulaError(f"rows of one length are wanted, {[len(row) for row in rows]} came")
        return Formula("matrix", str(len(rows[0])), tuple(part for row in rows for part in row))


def read_formula(text: str, primed: frozenset[str] = frozenset()) -> Formula:
    """The formula of a text. Raises FormulaError, also where it is written in another way."""
    return whole(text, primed, Reader.formula)


def whole(text: str, primed: frozenset[str], read: Callable[[Reader], Read]) -> Read:
    """What `read` makes of all of a text; what was read has to print as it was written."""
    reader = Reader(tokens_of(text, primed))
    found = read(reader)
    if reader.next:
        raise reader.error("the end")
    printed = str(found)
    if printed != text:
        pairs = enumerate(zip(printed, text, strict=False))
        start = next((n for n, (one, other) in pairs if one != other), min(len(printed), len(text)))
        here = slice(max(0, start - AROUND), start + AROUND)
        raise FormulaError(
            f"read as {printed[here]!r}, written {text[here]!r}: write it as it is read"
        )
    return found


_BINDING = {"add": 0, "neg": 0, "div": 1, "mul": 2, "pow": 3, "inverse": 3, "transpose": 4}


def _printed(node: Formula) -> str:
    parts = node.parts
    match node.kind:
        case "number" | "name":
            return node.text
        case "slot":
            return f"{{{node.text}}}"
        case "add":
            first, *others = parts
            signs = (
                f" - {_inside(x.parts[0], 1)}" if x.kind == "neg" else f" + {_inside(x, 1)}"
                for x in others
            )
            return (str(first) if first.kind == "neg" else _inside(first, 1)) + "".join(signs)
        case "neg":
            return f"-{_inside(parts[0], 1)}"
        case "div":
            return f"{_inside(parts[0], 2)}/{_inside(parts[1], 3)}"
        case "mul":
            return " ".join(_inside(part, 3) for part in parts)
        case "pow":
            return f"{_inside(parts[0], 4)}^{node.text}"
        case "transpose":
            return f"{_inside(parts[0], 4)}'"
        case "inverse":
            return f"{_inside(parts[0], 4)}^-1"
        case "names":
            return ", ".join(map(str, parts))
        case "call":
            return f"{node.text}({', '.join(map(str, parts))})"
    columns = int(node.text)
    rows = (parts[start : start + columns] for start in range(0, len(parts), columns))
    return f"[{'; '.join(', '.join(map(str, row)) for row in rows)}]"


def _inside(node: Formula, binding: int) -> str:
    """In parentheses where it binds less than what is around it."""
    return f"({node})" if _BINDING.get(node.kind, 5) < binding else str(node)
