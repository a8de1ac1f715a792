"""Expression graphs as LaTeX. Names are written as `names` says, else upright as they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.formula_text import LONGEST, Graph

_SUM, _PRODUCT, _POWER, _ATOM = range(1, 5)


def formula_latex(graph: Graph, names: Mapping[str, str], output: str = "value") -> str:
    """One output of a graph, without surrounding dollar signs."""
    nodes: Sequence[Sequence[Any]] = graph["nodes"]
    pieces: list[tuple[str, int]] = []
    for node in nodes:
        piece = _piece(node, pieces, names)
        if len(piece[0]) > LONGEST:
            return rf"\text{{an expression of {len(nodes)} nodes}}"
        pieces.append(piece)
    return pieces[graph["outputs"][output]][0]


def symbol_latex(name: str, names: Mapping[str, str]) -> str:
    """A symbol by its declared LaTeX, a single letter as it is, a word upright."""
    if name in names:
        return names[name]
    return name if len(name) == 1 else rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


def _within(piece: tuple[str, int], binding: int) -> str:
    text, own = piece
    return text if own >= binding else rf"\left({text}\right)"


def _piece(
    node: Sequence[Any], pieces: Sequence[tuple[str, int]], names: Mapping[str, str]
) -> tuple[str, int]:
    kind = node[0]
    if kind == "number":
        return _number(str(node[1]))
    if kind == "symbol":
        return symbol_latex(node[1], names), _ATOM
    if kind == "matrix":
        columns = node[2]
        entries = [pieces[i][0] for i in node[3:]]
        rows = [" & ".join(entries[r : r + columns]) for r in range(0, len(entries), columns)]
        return r"\begin{pmatrix}" + r" \\ ".join(rows) + r"\end{pmatrix}", _ATOM
    if kind == "derivative":
        symbol = symbol_latex(node[2], names)
        return rf"\frac{{d}}{{d{symbol}}} {_within(pieces[node[1]], _POWER)}", _PRODUCT
    if kind == "at":
        symbol = symbol_latex(node[2], names)
        inner = pieces[node[1]][0]
        return rf"\left.{inner}\right|_{{{symbol} = {pieces[node[3]][0]}}}", _PRODUCT
    if kind == "pow":
        return _power(pieces[node[1]], str(node[2]))
    if kind == "call":
        arguments = ", ".join(pieces[i][0] for i in node[2:])
        return rf"\operatorname{{{node[1]}}}\left({arguments}\right)", _ATOM
    return _arithmetic(kind, [pieces[i] for i in node[1:]])


def _number(text: str) -> tuple[str, int]:
    sign, digits = ("-", text[1:]) if text.startswith("-") else ("", text)
    if "/" in digits:
        top, bottom = digits.split("/")
        return rf"{sign}\frac{{{top}}}{{{bottom}}}", _SUM if sign else _PRODUCT
    return sign + digits, _SUM if sign else _ATOM


def _power(base: tuple[str, int], exponent: str) -> tuple[str, int]:
    if exponent == "1/2":
        return rf"\sqrt{{{base[0]}}}", _ATOM
    return rf"{_within(base, _ATOM)}^{{{exponent}}}", _POWER


def _arithmetic(kind: str, parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
    if kind == "add":
        text = parts[0][0]
        for part, _ in parts[1:]:
            text += f" - {part[1:]}" if part.startswith("-") else f" + {part}"
        return text, _SUM
    if kind == "mul":
        shown = [_within(parts[0], _PRODUCT)]
        for piece in parts[1:]:
            factor = _within(piece, _PRODUCT)
            shown.append(rf"\cdot {factor}" if factor[0].isdigit() else factor)
        return " ".join(shown), _PRODUCT
    if kind == "div":
        return rf"\frac{{{parts[0][0]}}}{{{parts[1][0]}}}", _PRODUCT
    if kind == "neg":
        return f"-{_within(parts[0], _PRODUCT)}", _SUM
    arguments = ", ".join(text for text, _ in parts)
    return rf"\operatorname{{{kind}}}\left({arguments}\right)", _ATOM
