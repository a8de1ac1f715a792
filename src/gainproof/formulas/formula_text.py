"""Expression graphs as plain text, for pages that are read in a terminal: `beta^2/(1 - alpha)`.

Factors stand side by side; a slash divides what stands before it by the one factor after it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from gainproof.formulas.formula_term import Graph, Style, lay_out


def inline_matrix(rows: Sequence[Sequence[str]]) -> str:
    """`[a, b; c, d]`"""
    return "[" + "; ".join(", ".join(row) for row in rows) + "]"


def replaced(text: str, symbol: str, value: str) -> str:
    """An expression with a value for a symbol, as the reader of formulas reads it: `a[k := 1]`."""
    return f"{text}[{symbol} := {value}]"


def indexed(text: str, symbol: str, value: str) -> str:
    """The same as pages for people write it: `alpha_k` as alpha_1, `M11` as M11(k - 1)."""
    if not re.fullmatch(r"[A-Za-z]\w*", text):
        return replaced(text, symbol, value)
    if text.endswith(f"_{symbol}"):
        return text.removesuffix(symbol) + (value if value.isalnum() else f"({value})")
    return f"{text}({value})"


def _derivative(text: str, symbol: str, order: int) -> str:
    return f"(d/d{symbol}){f'^{order}' if order > 1 else ''} {text}"


def formula_text(
    graph: Graph,
    names: Mapping[str, str],
    output: str = "value",
    matrix: Callable[[Sequence[Sequence[str]]], str] = inline_matrix,
    at: Callable[[str, str, str], str] = replaced,
) -> str:
    """One output of a graph; names are written as `names` says, else as they are."""
    style = Style(
        symbol=lambda name: names.get(name, name),
        group=lambda text: f"({text})",
        power=_power,
        root=lambda text: f"sqrt({text})",
        quotient=_quotient,
        matrix=matrix,
        call=lambda name, arguments: f"{name}({', '.join(arguments)})",
        derivative=_derivative,
        at=at,
        transpose=lambda text: f"{text}'",
        too_long=lambda nodes: f"(an expression of {nodes} nodes)",
    )
    return lay_out(graph, style, output)


def plain_name(latex: str) -> str:
    """A LaTeX symbol as a word: `\\alpha_k` alpha_k, `M_{11}` M11, `\\mathrm{Re} z_1` Re z1."""
    bare = re.sub(r"\\(?:operatorname|mathrm|text|bar|hat|dot|tilde)\{([^}]*)\}", r"\1", latex)
    bare = re.sub(r"\\(?:bar|hat|dot|tilde) ", "", bare)
    bare = re.sub(r"\\sqrt\{([^}]*)\}", r"sqrt(\1)", bare)
    return re.sub(r"[\\{}]|_(?=\{?\d)", "", bare).strip()


def _power(base: str, exponent: str) -> str:
    plain = exponent.removeprefix("-").isdigit()
    return f"{base}^{exponent}" if plain else f"{base}^({exponent})"


def _quotient(top: Sequence[str], bottom: Sequence[str]) -> str:
    shown = " ".join(_apart(top))
    if not bottom:
        return shown
    below = " ".join(_apart(bottom))
    return f"{shown}/({below})" if len(bottom) > 1 else f"{shown}/{below}"


def _apart(factors: Sequence[str]) -> list[str]:
    """Numbers after the first factor in parentheses, so that two never run together."""
    rest = [f"({text})" if text[0].isdigit() else text for text in factors[1:]]
    return [*factors[:1], *rest]
