"""Expression graphs and relations printed as LaTeX that reads back to the same graphs.

Quotients are printed as fractions, so that no slash has two readings.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.reader.printing import (
    ATOM,
    POWER,
    PRODUCT,
    SUM,
    Printed,
    case_texts,
    decimal,
    print_graph,
    relation_texts,
)
from gainproof.verify.judge.reader.words import BASED, FUNCTION_WORDS, OF_CASES, TRANSPOSE_MARKS

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
_COMMANDS = {
    "asin": "\\arcsin",
    "acos": "\\arccos",
    "atan": "\\arctan",
    **{name: f"\\{name}" for name in ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh")},
    **{name: f"\\{name}" for name in ("tanh", "exp", "det", "max", "min")},
    "log": "\\ln",
    "trace": "\\operatorname{tr}",
    "block_diagonal": "\\operatorname{blkdiag}",
    "covariance": "\\operatorname{cov}",
    "variance": "\\operatorname{var}",
    "sign": "\\operatorname{sgn}",
    **{name: f"\\operatorname{{{name}}}" for name in ("atan2", "rank", "diag", "erf", "erfinv")},
    **{name: f"\\operatorname{{{name}}}" for name in ("floor", "ceil", "mod")},
}
assert _COMMANDS.keys() == set(FUNCTION_WORDS.values())


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


def call_text(name: str, arguments: Sequence[Printed]) -> Printed:
    """A function of its arguments, or what has signs of its own."""
    texts = [argument.text for argument in arguments]
    match name, len(arguments):
        case "pi", 0:
            return Printed("\\pi", ATOM)
        case "abs", 1:
            return Printed(f"\\left| {texts[0]} \\right|", ATOM)
        case "norm", 1:
            return Printed(f"\\left\\| {texts[0]} \\right\\|", ATOM)
        case (("sum" | "product"), 4):
            sign = "\\sum" if name == "sum" else "\\prod"
            bounds = f"_{{{texts[1]} = {texts[2]}}}^{{{texts[3]}}}"
            body = texts[0] if arguments[0].level >= PRODUCT else f"\\left( {texts[0]} \\right)"
            return Printed(f"{sign}{bounds} {body}", PRODUCT)
        case "integral", 4:
            bounds = f"_{{{texts[2]}}}^{{{texts[3]}}}"
            return Printed(f"\\int{bounds} {texts[0]} \\, \\mathrm{{d}} {texts[1]}", PRODUCT)
        case "family", 4:
            bounds = f"_{{{texts[1]} = {texts[2]}}}^{{{texts[3]}}}"
            return Printed(f"\\left( {texts[0]} \\right){bounds}", POWER)
        case "expectation", 1:
            return Printed(f"\\mathbb{{E}} \\left[ {texts[0]} \\right]", ATOM)
        case "order", 1:
            return Printed(f"\\mathcal{{O}} \\left( {texts[0]} \\right)", ATOM)
        case "power", 2:
            base = texts[0] if arguments[0].level >= ATOM else f"\\left( {texts[0]} \\right)"
            above = f"\\left( {texts[1]} \\right)" if texts[1] in TRANSPOSE_MARKS else texts[1]
            return Printed(f"{base}^{{{above}}}", POWER, digit=arguments[0].digit)
    if name.startswith(OF_CASES):
        lines = case_texts(name, texts, " & ", ", \\ ", _OPERATORS)
        lines[-1] += "" if " & " in lines[-1] else " & \\text{otherwise}"
        inner = " \\\\ ".join(lines)
        return Printed(f"\\begin{{cases}} {inner} \\end{{cases}}", ATOM)
    if name in ("floor", "ceil"):
        return Printed(f"\\left\\l{name} {texts[0]} \\right\\r{name}", ATOM)
    inner = ", ".join(texts)
    if name.startswith(BASED):
        base = name.removeprefix(BASED)
        return Printed(f"\\log_{{{base}}} \\left( {inner} \\right)", POWER)
    if name in _COMMANDS:
        return Printed(f"{_COMMANDS[name]} \\left( {inner} \\right)", POWER)
    return Printed(f"{name} \\left( {inner} \\right)", ATOM)


def matrix_text(columns: int, entries: Sequence[Printed]) -> Printed:
    """A matrix in round brackets, whose entries may be matrices."""
    texts = [entry.text for entry in entries]
    rows = [" & ".join(texts[n : n + columns]) for n in range(0, len(texts), columns)]
    inner = " \\\\ ".join(rows)
    return Printed(f"\\begin{{pmatrix}} {inner} \\end{{pmatrix}}", ATOM)


def evaluated_text(body: Printed, symbol: str, value: Printed) -> Printed:
    """A value at a place."""
    return Printed(f"\\left. {body.text} \\right|_{{{symbol} = {value.text}}}", ATOM)
