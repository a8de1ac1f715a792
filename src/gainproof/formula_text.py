"""Expression graphs as plain text, for pages that are read in a terminal.

The order of terms and factors is that of the graph. Names are written as `names` says, else as they are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

Graph = Mapping[str, Any]

LONGEST = 20_000  # characters; a shared node is written out each time, so text can grow without end

_SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(1, 6)


@dataclass(frozen=True)
class Piece:
    """Text and how tightly its outermost operation binds."""

    text: str
    binding: int

    def within(self, binding: int) -> str:
        """The text, in parentheses if what surrounds it binds more tightly."""
        return self.text if self.binding >= binding else f"({self.text})"


def formula_text(graph: Graph, names: Mapping[str, str], output: str = "value") -> str:
    """One output of a graph. Text beyond `LONGEST` characters is replaced by its number of nodes."""
    nodes: Sequence[Sequence[Any]] = graph["nodes"]
    pieces: list[Piece] = []
    for node in nodes:
        piece = _piece(node, pieces, names)
        if len(piece.text) > LONGEST:
            return f"(an expression of {len(nodes)} nodes)"
        pieces.append(piece)
    return pieces[graph["outputs"][output]].text


def plain_name(latex: str) -> str:
    """A LaTeX symbol as a word: `\\alpha` alpha, `M_{11}` M11, `\\operatorname{Re} z_1` Re z1."""
    bare = re.sub(r"\\operatorname\{([^}]*)\}", r"\1", latex)
    bare = re.sub(r"\\(?:mathrm|text|bar|hat|dot|tilde)\{([^}]*)\}", r"\1", bare)
    return re.sub(r"[\\{}_]", "", bare).strip()


def _piece(node: Sequence[Any], pieces: Sequence[Piece], names: Mapping[str, str]) -> Piece:
    kind = node[0]
    if kind == "number":
        text = str(node[1])
        return Piece(text, _SIGN if text.startswith("-") else _PRODUCT if "/" in text else _ATOM)
    if kind == "symbol":
        text = names.get(node[1], node[1])
        return Piece(text, _ATOM)
    if kind == "matrix":
        rows, columns = node[1], node[2]
        entries = [pieces[i].text for i in node[3:]]
        lines = [", ".join(entries[r * columns : (r + 1) * columns]) for r in range(rows)]
        return Piece("[" + "; ".join(lines) + "]", _ATOM)
    if kind == "derivative":
        return Piece(f"d/d{names.get(node[2], node[2])} {pieces[node[1]].within(_POWER)}", _PRODUCT)
    if kind == "at":
        symbol = names.get(node[2], node[2])
        return Piece(f"{pieces[node[1]].within(_ATOM)}[{symbol} := {pieces[node[3]].text}]", _ATOM)
    if kind == "pow":
        return _power(pieces[node[1]], str(node[2]))
    if kind == "call":
        return Piece(f"{node[1]}({', '.join(pieces[i].text for i in node[2:])})", _ATOM)
    return _arithmetic(kind, [pieces[i] for i in node[1:]])


def _power(base: Piece, exponent: str) -> Piece:
    if exponent == "1/2":
        return Piece(f"sqrt({base.text})", _ATOM)
    shown = exponent if exponent.isdigit() else f"({exponent})"
    return Piece(f"{base.within(_ATOM)}^{shown}", _POWER)


def _arithmetic(kind: str, parts: Sequence[Piece]) -> Piece:
    if kind == "add":
        text = parts[0].text
        for part in parts[1:]:
            term = part.within(_SUM)
            text += f" - {term[1:]}" if term.startswith("-") else f" + {term}"
        return Piece(text, _SUM)
    if kind == "mul":
        return Piece(" ".join(_factors(parts)), _PRODUCT)
    if kind == "div":
        return Piece(f"{parts[0].within(_PRODUCT)}/{parts[1].within(_POWER)}", _PRODUCT)
    if kind == "neg":
        return Piece(f"-{parts[0].within(_PRODUCT)}", _SIGN if parts[0].binding > _SIGN else _SUM)
    return Piece(f"{kind}({', '.join(part.text for part in parts)})", _ATOM)


def _factors(parts: Sequence[Piece]) -> list[str]:
    """Factors side by side; a fraction or a number after another factor gets parentheses."""
    shown = [parts[0].within(_PRODUCT)]
    for part in parts[1:]:
        plain = part.binding >= _POWER and not part.text[0].isdigit()
        shown.append(part.text if plain else f"({part.text})")
    if "/" in shown[0] and parts[0].binding < _POWER:
        shown[0] = f"({shown[0]})"
    return shown
