"""Shapes of letters in a formula about matrices of any size, as the formula itself says them.

Each letter has rows and columns of unknown size; sums, products, inverses and both sides of an
equation say which of them are equal.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from gainproof.bad_input import BadInputError
from gainproof.verify.judge.formula import Graph

ONE = "1"
PROPERTIES = ("symmetric", "positive definite", "positive semidefinite", "invertible")
NUMBER = "number"
"""What is said of a letter that is no matrix."""
_SIZE = r"[A-Za-z]|[1-9]\d{0,3}"
_SHAPE = re.compile(rf"({_SIZE})\s*x\s*({_SIZE})\b[\s,]*")
_BASE = re.compile(
    r"(?:\\(?:hat|widehat|tilde|widetilde|bar|overline|math(?:bf|rm|it)|boldsymbol|bm)\s*\{?\s*)*"
    r"(\\?[A-Za-z]+)"
)
SYMMETRIC = {
    **dict.fromkeys(("P", r"\Sigma", "R", "S"), "positive definite"),
    "Q": "positive semidefinite",
}
"""Covariances by their letters. That of a process noise may be singular."""
_TRANSITIONS = ("F", r"\Phi")
"""Transition matrices, which are square."""
Shape = tuple[int, int] | None
"""Classes of rows and columns; None for a number, which may stand before any matrix."""


@dataclass(frozen=True)
class Said:
    """What a user says of a letter: a shape, properties, that it is a number, or a definition."""

    shape: tuple[str, str] | None = None
    properties: tuple[str, ...] = ()
    number: bool = False
    definition: str = ""


def says_matrix(text: str) -> bool:
    """Whether what is said of a symbol is that it is a matrix: "n x m", "symmetric"."""
    return bool(_SHAPE.match(text)) or text.split(",")[0].strip() in PROPERTIES


def said_of(token: str, text: str) -> Said:
    """What `--symbol` says of a letter of a formula about matrices. Raises BadInputError."""
    if text.startswith("="):
        if not text[1:].strip():
            raise BadInputError(f"--symbol {token}: a formula is wanted behind =, got none")
        return Said(definition=text[1:].strip())
    if text in (NUMBER, "1"):
        return Said(number=True)
    found = _SHAPE.match(text)
    rest = [part.strip() for part in text[found.end() if found else 0 :].split(",")]
    properties = tuple(part for part in rest if part)
    if not set(properties) <= set(PROPERTIES):
        raise BadInputError(
            f"--symbol '{token}: {text}': of a matrix a shape is wanted, 'n x m', with "
            f"{', '.join(PROPERTIES)} behind it after commas, or '{NUMBER}', or '= ...'"
        )
    return Said((found[1], found[2]) if found else None, properties)


class Sizes:
    """Which rows and columns are of one size: classes that are joined, some of which have names."""

    def __init__(self) -> None:
        self.above: list[int] = []
        self.names: dict[int, str] = {}
        self.numbered: dict[str, int] = {}

    def new(self) -> int:
        self.above.append(len(self.above))
        return len(self.above) - 1

    def named(self, name: str) -> int:
        """The class that has this name."""
        if name not in self.numbered:
            self.numbered[name] = self.new()
            self.names[self.numbered[name]] = name
        return self.root(self.numbered[name])

    def root(self, number: int) -> int:
        while self.above[number] != number:
            number = self.above[number]
        return number

    def join(self, one: int, other: int, where: str) -> None:
        """Both are one size. Raises BadInputError where these have different names."""
        a, b = self.root(one), self.root(other)
        if a == b:
            return
        if a in self.names and b in self.names:
            both = " beside ".join(sorted((self.names[a], self.names[b])))
            raise BadInputError(f"{where}: sizes do not fit, {both}")
        if a in self.names:
            a, b = b, a
        self.above[a] = b


class Letters(Protocol):
    """What is known of letters."""

    said: Mapping[str, Said]

    def size_of(self, token: str) -> str | None:
        """The size of an identity matrix, empty where it is open; None for other letters."""


@dataclass
class Shapes:
    """The shapes of the letters and of what is made of them; `numbers` are letters without one,
    `columns` have one column.
    """

    sizes: Sizes
    reader: Letters
    numbers: frozenset[str]
    columns: frozenset[str]
    letters: dict[str, tuple[int, int]] = field(default_factory=dict)

    def letter(self, token: str) -> Shape:
        if token in self.numbers:
            return None
        if token not in self.letters:
            own = self.reader.said.get(token, Said())
            rows, columns = own.shape or ("", "")
            shape = tuple(self.sizes.named(s) if s else self.sizes.new() for s in (rows, columns))
            self.letters[token] = shape[0], shape[1]
            size = self.reader.size_of(token)
            usual = not own.shape and base_letter(token) in (*SYMMETRIC, *_TRANSITIONS)
            if size is not None or own.properties or usual:
                self.sizes.join(*self.letters[token], token)
            if size:
                self.sizes.join(self.letters[token][0], self.sizes.named(size), token)
            if token in self.columns and not own.shape:
                self.sizes.join(self.letters[token][1], self.sizes.named(ONE), token)
        return self.letters[token]

    def is_one(self, shape: Shape) -> bool:
        """Whether it is a number, or a matrix of one row and column."""
        one = self.sizes.numbered.get(ONE)
        return shape is None or (
            one is not None and all(self.sizes.root(s) == self.sizes.root(one) for s in shape)
        )

    def alike(self, shapes: Sequence[Shape], where: str) -> Shape:
        """Of a sum or of both sides: all have one shape, 1 x 1 where there is a number."""
        known = [each for each in shapes if each is not None]
        for each in known[1:]:
            for one, other in zip(known[0], each, strict=True):
                self.sizes.join(one, other, where)
        if known and len(known) < len(shapes):
            for size in known[0]:
                self.sizes.join(size, self.sizes.named(ONE), where)
        return known[0] if known else None

    def square(self, shape: Shape, where: str) -> Shape:
        if shape is not None:
            self.sizes.join(*shape, where)
        return shape

    def of(self, graph: Graph) -> Shape:
        """The shape of what a graph says. Raises BadInputError for what is not read here."""
        nodes: Sequence[Sequence[Any]] = graph["nodes"]
        found: list[Shape] = []
        for node in nodes:  # each of nodes before it
            found.append(self._node(node, found, nodes))
        value: int = graph["outputs"]["value"]
        return found[value]

    def _node(
        self, node: Sequence[Any], found: Sequence[Shape], nodes: Sequence[Sequence[Any]]
    ) -> Shape:
        kind: str = node[0]
        parts: Sequence[Any] = node[1:]
        match kind:
            case "number":
                return None
            case "symbol":
                return self.letter(parts[0])
            case "add":
                counted = [n for n in parts if nodes[n] != ["number", "0"]]
                return self.alike([found[n] for n in counted], "a sum")
            case "mul":
                return self._product([found[n] for n in parts])
            case "call" if parts[0] in ("det", "trace"):
                self.square(found[parts[1]], parts[0])
                return None
        inner: Shape = found[parts[0]] if type(parts[0]) is int else None
        match kind:
            case "neg":
                return inner
            case "div":
                self.alike([found[parts[1]], None], "a divisor")
                return inner
            case "transpose":
                return inner and (inner[1], inner[0])
            case "pow" | "inverse":
                return self.square(inner, "a power or an inverse")
            case _:
                what = parts[0] if kind == "call" else kind
                raise BadInputError(
                    f"{what} in a formula about matrices of any size, which a transpose says it "
                    "is: that is done in a claim file; an exponent T is written ^{(T)}"
                )

    def _product(self, shapes: Sequence[Shape]) -> Shape:
        whole: Shape = None
        for shape in shapes:
            if self.is_one(shape):
                whole = whole if whole is not None else shape
            elif self.is_one(whole):
                whole = shape
            elif whole is not None and shape is not None:
                self.sizes.join(whole[1], shape[0], "a product")
                whole = whole[0], shape[1]
        return whole


def base_letter(token: str) -> str:
    """A letter without accents and marks: P of `\\hat{P}_{k|k-1}`."""
    found = _BASE.match(token)
    return found[1] if found else token


def is_small(token: str) -> bool:
    """Whether it is a small letter, Latin or Greek: a vector, if it is no number."""
    return re.fullmatch(r"[a-z]|\\[a-z]+", base_letter(token)) is not None
