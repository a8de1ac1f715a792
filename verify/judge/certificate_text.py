"""Statements as the files that decide certificates read them: names and expressions as text."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from keyword import iskeyword

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Malformed

OF_MODEL = re.compile(r"[PKSXL]\[\d,\d\]")
"""Entries of a filter's matrices, as the files name them."""
SUM, PRODUCT, POWER, ATOM = 0, 1, 2, 3


@dataclass(frozen=True)
class Said:
    """A statement, with variables as the source calls them where they have a label."""

    typed: str
    """The formula as it was typed."""
    convention: str
    partial: bool
    """Whether the domain of the verdict is where its parts have values."""
    boxes: Mapping[str, Box]
    """The ranges of the variables."""
    given: Sequence[Rel]
    """Conditions beside the ranges."""
    model: Mapping[str, Sequence[Sequence[Expr]]]
    """The matrices of a filter; empty where the formula is of none."""
    letters: Mapping[str, Expr]
    """What other symbols of the source stand for."""
    relations: Sequence[Rel]
    """What is claimed; if it is refuted, one of it."""
    needed: Sequence[Expr]
    """Parts of the formula, no longer in the relations, that have to have a value."""
    labels: Mapping[str, str]
    """Names of variables in the judge, and in the source."""
    functions: Sequence[str]
    """How the source defines those that are put in."""


class Text:
    """Names and expressions of a statement; lines are said by `say`. `own` are names that the file
    takes for itself.
    """

    def __init__(self, said: Said, own: set[str]) -> None:
        self.said, self.own = said, own
        self.names: dict[str, str] = {}
        self.texts: dict[bytes, tuple[str, int]] = {}
        self.parts = 0
        for token in sorted((*said.boxes, *said.letters), key=lambda token: "[" in token):
            self.name(token)

    def say(self, title: str, text: str) -> None:
        raise NotImplementedError

    def name(self, token: str) -> str:
        """How the file calls a symbol."""
        if token not in self.names:
            plain = re.sub("[^A-Za-z0-9]+", "_", token.replace("'", "_prime")).strip("_")
            plain = plain if plain[:1].isalpha() else f"x_{plain}"
            if "[" in token and plain in self.names.values():
                plain = f"entry_of_{plain}"  # D[1, 2] beside a number D_{1,2}
            taken = self.own | {*self.names.values()}
            while plain in taken or iskeyword(plain) or re.fullmatch(r"part\d+", plain):
                plain += "_"
            self.names[token] = plain
        return self.names[token]

    def relation(self, rel: Rel) -> str:
        left, right = self.text(rel.left), self.text(rel.right)
        if rel.operator in ("<", "<="):
            left, right = right, left
        operator = {"=": "==", "<": ">", "<=": ">="}.get(rel.operator, rel.operator)
        return f"{left} {operator} {right}"

    def text(self, expr: Expr) -> str:
        for node in walk(expr):
            if node.key not in self.texts:
                text, level = self.node(node, [self.texts[part.key] for part in node.parts])
                if len(text) > 120:
                    self.parts += 1
                    self.say("with", f"part{self.parts} = {text}")
                    text, level = f"part{self.parts}", ATOM
                self.texts[node.key] = text, level
        return self.texts[expr.key][0]

    def node(self, node: Expr, parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
        match node.kind:
            case "number":
                value = Fraction(str(node.value))
                return str(value), SUM if value < 0 else PRODUCT if value.denominator > 1 else ATOM
            case "symbol":
                name = str(node.value)
                if OF_MODEL.fullmatch(name):
                    return name, ATOM
                return self.name(self.said.labels.get(name, name)), ATOM
            case "add":
                text = parts[0][0]
                for part, _ in parts[1:]:
                    text += f" - {part[1:]}" if part[0] == "-" else f" + {part}"
                return text, SUM
            case "mul":
                return "*".join(_bracketed(part, PRODUCT) for part in parts), PRODUCT
            case "neg":
                return f"-{_bracketed(parts[0], PRODUCT)}", SUM
            case "div":
                return f"{_bracketed(parts[0], PRODUCT)}/{_bracketed(parts[1], ATOM)}", PRODUCT
            case "pow":
                e = Fraction(str(node.value))
                if e.denominator not in (1, 2, 4):
                    raise Malformed(f"not known: a power {e}")
                base = _bracketed(parts[0], ATOM)
                for depth in range(e.denominator // 2):
                    base = f"sqrt({base if depth else parts[0][0]})"
                text = base if abs(e.numerator) == 1 else f"{base}**{abs(e.numerator)}"
                return (
                    (text, POWER) if e > 0 else (f"1/{_bracketed((text, POWER), POWER)}", PRODUCT)
                )
            case "call":
                return self.function(node.name, parts)
        raise Malformed(f"not known: {node.kind}")

    def function(self, name: str, parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
        raise Malformed(f"not known: {name} of {', '.join(text for text, _ in parts)}")


def _bracketed(part: tuple[str, int], least: int) -> str:
    text, level = part
    return text if level >= least else f"({text})"
