"""Expression graphs as LaTeX, without surrounding dollar signs."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from gainproof.formulas.formula_term import Graph, Style, lay_out


def replaced(text: str, symbol: str, value: str) -> str:
    """An expression at a value of a symbol, with a bar."""
    return rf"\left.{text}\right|_{{{symbol} = {value}}}"


def indexed(text: str, symbol: str, value: str) -> str:
    """The same without the bar for a single name: `\alpha_k` as `\alpha_{1}`."""
    if not re.fullmatch(r"\\?[A-Za-z]+(_\w|_\{\w+\})?", text):
        return replaced(text, symbol, value)
    if text.endswith(f"_{symbol}"):
        return f"{text.removesuffix(symbol)}{{{value}}}"
    return f"{text}({value})"


def formula_latex(
    graph: Graph,
    names: Mapping[str, str],
    output: str = "value",
    at: Callable[[str, str, str], str] = replaced,
) -> str:
    """One output of a graph; names are written as `names` says, else upright as they are."""
    style = Style(
        symbol=lambda name: symbol_latex(name, names),
        group=lambda text: rf"\left({text}\right)",
        power=lambda base, exponent: rf"{{{base}}}^{{{exponent}}}",
        root=lambda text: rf"\sqrt{{{text}}}",
        quotient=_quotient,
        matrix=_matrix,
        call=lambda name, parts: rf"\operatorname{{{name}}}\left({', '.join(parts)}\right)",
        derivative=_derivative,
        at=at,
        transpose=lambda text: rf"{{{text}}}'",
        too_long=lambda nodes: rf"\text{{an expression of {nodes} nodes}}",
    )
    return lay_out(graph, style, output)


def symbol_latex(name: str, names: Mapping[str, str]) -> str:
    """A symbol by its declared LaTeX, a single letter as it is, a word upright."""
    if name in names:
        return names[name]
    return name if len(name) == 1 else r"\mathrm{" + name.replace("_", r"\_") + "}"


def _derivative(text: str, symbol: str, order: int) -> str:
    power = f"^{{{order}}}" if order > 1 else ""
    return rf"\frac{{d{power}}}{{d{symbol}{power}}} {text}"


def _quotient(top: Sequence[str], bottom: Sequence[str]) -> str:
    if not bottom:
        return _product(top)
    return rf"\frac{{{_alone(top)}}}{{{_alone(bottom)}}}"


def _alone(factors: Sequence[str]) -> str:
    """Factors above or below a line, where a single sum needs no parentheses."""
    text = _product(factors)
    opening, ending = r"\left(", r"\right)"
    grouped = len(factors) == 1 and text.startswith(opening) and text.endswith(ending)
    return text[len(opening) : -len(ending)] if grouped else text


def _product(factors: Sequence[str]) -> str:
    shown = factors[0] if factors else "1"
    for text in factors[1:]:
        shown += rf" \cdot {text}" if text[0].isdigit() else f" {text}"
    return shown


def _matrix(rows: Sequence[Sequence[str]]) -> str:
    lines = [" & ".join(row) for row in rows]
    return r"\begin{pmatrix}" + r" \\ ".join(lines) + r"\end{pmatrix}"
