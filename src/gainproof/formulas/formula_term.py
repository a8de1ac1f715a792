"""Expression graphs laid out as people write them: one sign, one number, factors above and below.

Layout only: a quotient of quotients becomes one quotient, a negative power goes below the line, a
sum does not start with a minus sign if it can start without. The value stays that of the graph.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Graph = Mapping[str, Any]

LONGEST = 20_000  # characters; a shared node is written out each time, so text can grow without end


@dataclass(frozen=True)
class Style:
    """How the pieces are written. Factors given to these functions need no more parentheses."""

    symbol: Callable[[str], str]
    group: Callable[[str], str]
    power: Callable[[str, str], str]
    root: Callable[[str], str]
    quotient: Callable[[Sequence[str], Sequence[str]], str]
    matrix: Callable[[Sequence[Sequence[str]]], str]
    call: Callable[[str, Sequence[str]], str]
    derivative: Callable[[str, str, int], str]
    at: Callable[[str, str, str], str]
    transpose: Callable[[str], str]
    too_long: Callable[[int], str]


@dataclass(frozen=True)
class Term:
    """number * (top factors) / (bottom factors).

    `total`: the text if it is one sum; `raised`: it is one power.
    """

    number: Fraction
    top: tuple[str, ...] = ()
    bottom: tuple[str, ...] = ()
    total: str | None = None
    raised: bool = False

    def times(self, other: Term) -> Term:
        return Term(self.number * other.number, self.top + other.top, self.bottom + other.bottom)

    def inverse(self) -> Term:
        if self.number == 0:
            return Term(Fraction(1), self.bottom, ("0", *self.top))
        return Term(1 / self.number, self.bottom, self.top)


def factor(text: str) -> Term:
    """One factor that needs no parentheses."""
    return Term(Fraction(1), (text,))


def lay_out(graph: Graph, style: Style, output: str = "value") -> str:
    """One output of a graph in a style; beyond `LONGEST` characters only its number of nodes."""
    nodes: Sequence[Sequence[Any]] = graph["nodes"]
    terms: list[Term] = []
    for node in nodes:
        if node[0] == "derivative":
            term = _derivative(nodes, node, terms, style)
        else:
            term = _term(node, terms, style)
        if sum(map(len, term.top)) + sum(map(len, term.bottom)) > LONGEST:
            return style.too_long(len(nodes))
        terms.append(term)
    return written(terms[graph["outputs"][output]], style)


def written(term: Term, style: Style) -> str:
    """A term with its sign."""
    if term.total is not None:
        return term.total
    number = abs(term.number)
    sign = "-" if term.number < 0 else ""
    top = [str(number.numerator)] if number.numerator != 1 or not term.top else []
    bottom = [str(number.denominator)] if number.denominator != 1 else []
    return sign + style.quotient([*top, *term.top], [*bottom, *term.bottom])


def _as_factor(term: Term, style: Style) -> str:
    """The term as a single factor."""
    if term.total is None and term.number == 1 and len(term.top) == 1 and not term.bottom:
        return term.top[0]
    whole = term.number >= 0 and term.number.denominator == 1
    if term.total is None and whole and not term.top and not term.bottom:
        return str(term.number)
    return style.group(written(term, style))


def _sum(terms: Sequence[Term], style: Style) -> Term:
    ordered = list(terms)
    if _negative(terms[0]):
        ordered.sort(key=_negative)
    text = written(ordered[0], style)
    for term in ordered[1:]:
        shown = written(term, style)
        text += f" - {shown[1:]}" if _negative(term) else f" + {shown}"
    return Term(Fraction(1), (style.group(text),), total=text)


def _negative(term: Term) -> bool:
    return term.total is None and term.number < 0


def _power(base: Term, exponent: Fraction, style: Style) -> Term:
    if exponent < 0:
        return _power(base, -exponent, style).inverse()
    if exponent == Fraction(1, 2):
        return factor(style.root(written(base, style)))
    if exponent == 1:
        return base
    inner = _as_factor(base, style)
    shown = style.group(inner) if base.raised else inner
    return Term(Fraction(1), (style.power(shown, str(exponent)),), raised=True)


def _term(node: Sequence[Any], terms: Sequence[Term], style: Style) -> Term:
    kind = node[0]
    if kind == "number":
        return Term(Fraction(node[1]))
    if kind == "symbol":
        return factor(style.symbol(node[1]))
    if kind == "matrix":
        columns = node[2]
        entries = [written(terms[i], style) for i in node[3:]]
        rows = [entries[r : r + columns] for r in range(0, len(entries), columns)]
        return factor(style.matrix(rows))
    if kind == "at":
        inner, value = _as_factor(terms[node[1]], style), written(terms[node[3]], style)
        return factor(style.at(inner, style.symbol(node[2]), value))
    if kind == "pow":
        return _power(terms[node[1]], Fraction(node[2]), style)
    if kind == "call":
        return factor(style.call(node[1], [written(terms[i], style) for i in node[2:]]))
    return _arithmetic(kind, [terms[i] for i in node[1:]], style)


def _derivative(
    nodes: Sequence[Sequence[Any]], node: Sequence[Any], terms: Sequence[Term], style: Style
) -> Term:
    """The derivative of a derivative by the same symbol is one of second order."""
    inner, order = node[1], 1
    while nodes[inner][0] == "derivative" and nodes[inner][2] == node[2]:
        inner, order = nodes[inner][1], order + 1
    text = _as_factor(terms[inner], style)
    return factor(style.derivative(text, style.symbol(node[2]), order))


def _turned(kind: str, matrix: Term, style: Style) -> Term:
    """A matrix transposed or inverted."""
    inner = _as_factor(matrix, style)
    shown = style.group(inner) if matrix.raised else inner
    text = style.transpose(shown) if kind == "transpose" else style.power(shown, "-1")
    return Term(Fraction(1), (text,), raised=True)


def _arithmetic(kind: str, parts: Sequence[Term], style: Style) -> Term:
    if kind == "add":
        return _sum(parts, style)
    if kind == "neg":
        return Term(Fraction(-1)).times(parts[0])
    if kind == "div":
        return parts[0].times(parts[1].inverse())
    if kind in ("transpose", "inverse"):
        return _turned(kind, parts[0], style)
    if kind == "mul":
        product = parts[0]
        for part in parts[1:]:
            product = product.times(part)
        return product
    return factor(style.call(kind, [written(part, style) for part in parts]))
