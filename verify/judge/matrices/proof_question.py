"""The question of a proof before formulas are multiplied out: definitions and claim as text.

`gainproof.verify.check_matrices` reads it, in the letters of the proof.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.matrices.exact_instance import Unsupported, is_number
from gainproof.verify.judge.matrices.polynomial import Polynomial
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.size import ZERO
from gainproof.verify.judge.matrices.statement_letters import Alphabet
from gainproof.verify.judge.matrices.tree import Node
from gainproof.verify.judge.matrices.word_expansion import Expander, value_of

Link = tuple[Node, str, Node]


def asked(links: Sequence[Link], alphabet: Alphabet, expand: Expander) -> dict[str, Any] | None:
    """{"names": {letter or definition: its name in the source}, "matrices": {letter: [rows,
    columns]}, "facts": {letter: what is supposed of it}, "blocks": {size: [letters]}, "lines":
    [["with", "let", "inverse", "random" or "unit", definition], ...], "claims": [relation, ...]};
    None where there is no such text.
    """
    writer = _Writer(alphabet, expand)
    try:
        claims = [writer.relation(*link) for link in links]
    except Unsupported:
        return None
    letters = alphabet.setting.letters
    free = {alphabet.number(name): name for name in letters if alphabet.has(name)}
    blocks = {alphabet.size_name(size): own for size, own in alphabet.blocks.items()}
    spoken = {*free, *(n for own in blocks.values() for n in own)}
    size = alphabet.size_name
    return {
        "names": {**{alphabet.names[n]: name for n, name in free.items()}, **writer.names},
        "matrices": {
            alphabet.names[n]: [size(side) for side in alphabet.shapes[n]] for n in sorted(spoken)
        },
        "facts": {alphabet.names[n]: [*letters[name].facts] for n, name in free.items()},
        "blocks": {name: [alphabet.names[n] for n in own] for name, own in blocks.items()},
        "lines": writer.lines,
        "claims": claims,
    }


@dataclass
class _Writer:
    alphabet: Alphabet
    expand: Expander
    lines: list[list[str]] = field(default_factory=list)
    names: dict[str, str] = field(default_factory=dict)
    _defined: dict[str, str] = field(default_factory=dict)
    _opened: dict[str, str] = field(default_factory=dict)

    def relation(self, left: Node, operator: str, right: Node) -> str:
        if operator[0] == "<":
            left, operator, right = right, operator.replace("<", ">"), left
        sign = "==" if operator == "=" else operator
        return f"{self.text(left)} {sign} {self.text(right)}"

    def text(self, node: Node) -> str:
        """An atom, or in brackets. Raises Unsupported."""
        alphabet = self.alphabet
        if is_number(node):
            return f"({value_of(node)})"
        parts = node.parts
        match node.kind:
            case "name":
                return self._name(node.name)
            case "unit" if node.shape is not None:
                size = alphabet.size_name(node.shape[0])
                line = ["unit", f"unit_{size} = {size}"]
                self.lines += [line] if line not in self.lines else []
                return f"unit_{size}"
            case "zero":
                return "0"
            case "negative":
                return f"(-{self.text(parts[0])})"
            case "transpose":
                return f"{self.text(parts[0])}.T"
            case "sum":
                return f"({' + '.join(map(self.text, parts))})"
            case "product":
                return f"({'*'.join(map(self.text, parts))})"
            case "inverse":
                return self._inverse(parts[0])
            case "expectation":
                return f"E({self.text(parts[0])})"
            case "matrix":
                heights, widths = Shapes(alphabet.setting.letters, alphabet.setting.sizes).blocks(
                    node
                )
                cells, down = list[str](), ZERO
                for i, height in enumerate(heights):
                    across = ZERO
                    for j, width in enumerate(widths):
                        cell = parts[i * len(widths) + j]
                        if self.expand.of(cell).terms:
                            left = alphabet.embedded(sum(heights, ZERO), down, height)
                            right = alphabet.embedded(sum(widths, ZERO), across, width)
                            cells.append(
                                f"{self._poly(left)}*{self.text(cell)}*{self._poly(right)}.T"
                            )
                        across = across + width
                    down = down + height
                return f"({' + '.join(cells) or '0'})"
        raise Unsupported(f"a {node.kind} as text")

    def _name(self, name: str) -> str:
        alphabet = self.alphabet
        letter = alphabet.setting.letters[name]
        if letter.scalar:
            raise Unsupported(f"{name} as text")
        if letter.definition is None:
            plain = alphabet.names[alphabet.number(name)]
            if letter.variance is not None:
                line = ["random", f"{plain} = {self.text(letter.variance)}"]
                self.lines += [line] if line not in self.lines else []
            return plain
        if name not in self._defined:
            text = self.text(letter.definition)
            taken = {*alphabet.names, *self.names}
            plain = f"d_{''.join(c for c in name if c.isascii() and c.isalnum())}"
            while plain in taken:
                plain += "x"
            self.names[plain] = name
            self._defined[name] = plain
            self.lines.append(["with", f"{plain} = {text}"])
            self._opened[plain] = self._without_definitions(text)
        return self._defined[name]

    def _without_definitions(self, text: str) -> str:
        return re.sub(r"\w+", lambda name: self._opened.get(name[0], name[0]), text)

    def _inverse(self, node: Node) -> str:
        """Of a letter as it stands, or of what is let be one, in one form everywhere: another that
        is the same would be a step of the proof.
        """
        alphabet, value, text = self.alphabet, self.expand.of(node), self.text(node)
        meant = self._without_definitions(text)
        (word, factor), *more = [*value.terms.items()] or [((), 0)]
        if more or len(word) != 1 or factor != 1:
            if not more and not word:
                raise Unsupported("the inverse of a number times the unit matrix")
            number = alphabet.short_for(value)
            short = alphabet.names[number]
            if short not in self._opened:
                self.lines.append(["let", f"{short} = {text}"])
            if self._opened.setdefault(short, meant) != meant:
                raise Unsupported("the inverse of one matrix in two forms")
        else:
            number = word[0] // 2
            if number in alphabet.base or meant != alphabet.names[number]:
                raise Unsupported("the inverse of a letter in another form")
        name = alphabet.names[alphabet.inverse_of(number)]
        line = ["inverse", f"{name} = {alphabet.names[number]}**-1"]
        self.lines += [line] if line not in self.lines else []
        return name

    def _poly(self, value: Polynomial) -> str:
        """Of selections of rows."""
        words = [
            "*".join(
                [f"({Fraction(c)})"] * (c != 1 or not word)
                + [self.alphabet.names[n // 2] + ".T" * (n % 2) for n in word]
            )
            for word, c in value.terms.items()
        ]
        return f"({' + '.join(words) or '0'})"
