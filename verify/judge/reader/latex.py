"""Expression graphs and relations printed as LaTeX that reads back to the same graphs.

Quotients are printed as fractions, so that no slash has two readings.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.reader.latex_forms import call_text, evaluated_text, matrix_text
from gainproof.verify.judge.reader.printed import (
    ATOM,
    POWER,
    PRODUCT,
    SUM,
    Printed,
    decimal,
    print_graph,
    relation_texts,
)

_OPERATORS = {
    "=": "=",
    "!=": "\\ne",
    "<": "<",
    "<=": "\\le",
    ">": ">",
    ">=": "\\ge",
    "approx": "\\approx",
    "sim": "\\sim",
    "propto": "\\propto",
    "->": "\\to",
}
_CONNECTIVES = {"iff": "\\Leftrightarrow", "implies": "\\Rightarrow"}


def reading_to_latex(reading: Reading) -> str:
    """All relations and conditions of one reading."""
    relations = relations_to_latex(reading.relations)
    if not reading.conditions:
        return relations
    conditions = relations_to_latex(reading.conditions)
    if reading.connective == "if":
        return f"{relations} \\quad \\left( {conditions} \\right)"
    return f"{relations} {_CONNECTIVES[reading.connective]} {conditions}"


def relations_to_latex(relations: Sequence[Relation]) -> str:
    """Relations joined by commas; `a = b` before `b = c` becomes a chain again."""
    zero = "\\left( -0 \\right)"
    return ", \\quad ".join(relation_texts(relations, _OPERATORS, graph_to_latex, zero))


def graph_to_latex(graph: Graph, output: str = "value") -> str:
    """One output of a graph. ValueError if a node is of a kind that has no printed form, or if the
    text is too long.
    """
    return print_graph(graph, output, _node).text


def _node(node: Sequence[str | int], done: Sequence[Printed]) -> Printed:
    kind, *rest = node
    match kind:
        case "number":
            return _number(Fraction(str(rest[0])))
        case "symbol":
            name = str(rest[0])
            return Printed("\\infty" if name == "infinity" else name, ATOM)
        case "pow":
            return _power(done[int(rest[0])], Fraction(str(rest[1])))
        case "derivative":
            body = _at_least(done[int(rest[0])], POWER)
            return Printed(f"\\frac{{\\partial}}{{\\partial {rest[1]}}} {body}", PRODUCT)
        case "at":
            return evaluated_text(done[int(rest[0])], str(rest[1]), done[int(rest[2])])
        case "call":
            return call_text(str(rest[0]), [done[int(number)] for number in rest[1:]])
        case "matrix":
            columns, entries = int(rest[1]), [done[int(number)] for number in rest[2:]]
            return matrix_text(columns, entries)
    parts = [done[int(number)] for number in rest]
    match kind:
        case "add":
            return _add(parts)
        case "mul":
            return _mul(parts)
        case "div":
            return Printed(f"\\frac{{{parts[0].text}}}{{{parts[1].text}}}", POWER)
        case "neg":
            return Printed(f"-{_at_least(parts[0], PRODUCT)}", SUM, negated=True)
        case "transpose":
            return Printed(f"{_at_least(parts[0], ATOM)}^{{\\mathsf{{T}}}}", POWER)
        case "inverse":
            return Printed(f"{_at_least(parts[0], ATOM)}^{{-1}}", POWER)
        case "kronecker":
            left, right = (_at_least(part, POWER) for part in parts)
            return Printed(f"{left} \\otimes {right}", PRODUCT)
    raise ValueError(f"a node of kind {kind!r} has no printed form")


def _at_least(printed: Printed, level: int) -> str:
    return printed.text if printed.level >= level else f"\\left( {printed.text} \\right)"


def _number(value: Fraction) -> Printed:
    if value < 0:
        return Printed(f"-{_number(-value).text}", SUM, negated=True)
    text = decimal(value)
    if text is None:
        return Printed(f"\\frac{{{value.numerator}}}{{{value.denominator}}}", POWER)
    return Printed(text, ATOM, digit=True)


def _add(terms: list[Printed]) -> Printed:
    text = terms[0].text if terms[0].negated else _at_least(terms[0], PRODUCT)
    for term in terms[1:]:
        if term.negated:
            text += f" - {term.text[1:]}"
        else:
            text += f" + {_at_least(term, PRODUCT)}"
    return Printed(text, SUM)


def _mul(factors: list[Printed]) -> Printed:
    text = _at_least(factors[0], POWER)
    for before, factor in pairwise(factors):
        # a digit beside a digit or a fraction is refused: one number to some
        is_mixed = before.digit and factor.text.startswith("\\frac")
        joint = " \\cdot " if factor.digit or is_mixed else " "
        text += joint + _at_least(factor, POWER)
    return Printed(text, PRODUCT, digit=factors[0].digit)


def _power(base: Printed, exponent: Fraction) -> Printed:
    if exponent.numerator == 1 and exponent.denominator > 1:
        index = "" if exponent.denominator == 2 else f"[{exponent.denominator}]"
        return Printed(f"\\sqrt{index}{{{base.text}}}", POWER)
    return Printed(f"{_at_least(base, ATOM)}^{{{exponent}}}", POWER, digit=base.digit)
