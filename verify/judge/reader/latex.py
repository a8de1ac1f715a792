"""Expression graphs and relations printed as LaTeX that reads back to the same graphs.

Quotients are printed as fractions, so that no slash has two readings.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.reader.limits import MOST_PRINTED_CHARACTERS

_SUM, _PRODUCT, _POWER, _ATOM = range(4)
_OPERATORS = {
    "=": "=",
    "!=": "\\ne",
    "<": "<",
    "<=": "\\le",
    ">": ">",
    ">=": "\\ge",
    "approx": "\\approx",
    "->": "\\to",
}
_CONNECTIVES = {"iff": "\\Leftrightarrow", "implies": "\\Rightarrow"}


class Printed(NamedTuple):
    """The text of a node, how tightly it binds, whether it begins with a digit or is a negated
    term.
    """

    text: str
    level: int
    digit: bool = False
    negated: bool = False


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
    pieces: list[str] = []
    for number, relation in enumerate(relations):
        operator, right = _OPERATORS[relation.operator], graph_to_latex(relation.right)
        if (
            number
            and relations[number - 1].right == relation.left
            and "->"
            not in (
                relation.operator,
                relations[number - 1].operator,
            )
        ):
            pieces[-1] += f" {operator} {right}"
        else:
            pieces.append(f"{graph_to_latex(relation.left)} {operator} {right}")
    return ", \\quad ".join(pieces)


def graph_to_latex(graph: Graph, output: str = "value") -> str:
    """One output of a graph. ValueError if a node is of a kind that has no printed form, or if the
    text is too long.

    The nodes are printed in their order, without recursion: a deep graph is no danger.
    """
    printed: list[Printed] = []
    for node in graph["nodes"]:
        printed.append(_node(node, printed))
        if len(printed[-1].text) > MOST_PRINTED_CHARACTERS:
            raise ValueError(f"a formula of more than {MOST_PRINTED_CHARACTERS} characters")
    value: int = graph["outputs"][output]
    return printed[value].text


def _node(node: Sequence[str | int], done: Sequence[Printed]) -> Printed:
    kind, *rest = node
    match kind:
        case "number":
            return _number(Fraction(str(rest[0])))
        case "symbol":
            name = str(rest[0])
            return Printed("\\infty" if name == "infinity" else name, _ATOM)
        case "pow":
            return _power(done[int(rest[0])], Fraction(str(rest[1])))
        case "derivative":
            body = _at_least(done[int(rest[0])], _PRODUCT)
            return Printed(f"\\frac{{\\partial}}{{\\partial {rest[1]}}} {body}", _PRODUCT)
        case "call":
            return _call(str(rest[0]), [done[int(number)] for number in rest[1:]])
    printers: dict[str | int, Callable[[list[Printed]], Printed]] = {
        "add": _add,
        "mul": _mul,
        "div": _div,
        "neg": _neg,
    }
    if kind not in printers:
        raise ValueError(f"a node of kind {kind!r} has no printed form")
    return printers[kind]([done[int(number)] for number in rest])


def _at_least(printed: Printed, level: int) -> str:
    if printed.level >= level:
        return printed.text
    return f"\\left( {printed.text} \\right)"


def _number(value: Fraction) -> Printed:
    if value < 0:
        return Printed(f"-{_number(-value).text}", _SUM, negated=True)
    if value.denominator == 1:
        return Printed(str(value.numerator), _ATOM, digit=True)
    decimal = _decimal(value)
    if decimal is None:
        return Printed(f"\\frac{{{value.numerator}}}{{{value.denominator}}}", _POWER)
    return Printed(decimal, _ATOM, digit=True)


def _decimal(value: Fraction) -> str | None:
    """The number with a decimal point, or None where it does not end."""
    twos = fives = 0
    rest = value.denominator
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest != 1:
        return None
    places = max(twos, fives)
    digits = str(value.numerator * 10**places // value.denominator).rjust(places + 1, "0")
    return f"{digits[:-places]}.{digits[-places:]}"


def _add(terms: list[Printed]) -> Printed:
    text = terms[0].text if terms[0].negated else _at_least(terms[0], _PRODUCT)
    for term in terms[1:]:
        if term.negated:
            text += f" - {term.text[1:]}"
        else:
            text += f" + {_at_least(term, _PRODUCT)}"
    return Printed(text, _SUM)


def _mul(factors: list[Printed]) -> Printed:
    text = _at_least(factors[0], _POWER)
    for before, factor in pairwise(factors):
        # a digit beside a digit or a fraction is refused: one number to some
        is_mixed = before.digit and factor.text.startswith("\\frac")
        joint = " \\cdot " if factor.digit or is_mixed else " "
        text += joint + _at_least(factor, _POWER)
    return Printed(text, _PRODUCT, digit=factors[0].digit)


def _div(parts: list[Printed]) -> Printed:
    return Printed(f"\\frac{{{parts[0].text}}}{{{parts[1].text}}}", _POWER)


def _neg(parts: list[Printed]) -> Printed:
    return Printed(f"-{_at_least(parts[0], _PRODUCT)}", _SUM, negated=True)


def _power(base: Printed, exponent: Fraction) -> Printed:
    if exponent.numerator == 1 and exponent.denominator > 1:
        index = "" if exponent.denominator == 2 else f"[{exponent.denominator}]"
        return Printed(f"\\sqrt{index}{{{base.text}}}", _POWER)
    return Printed(f"{_at_least(base, _ATOM)}^{{{exponent}}}", _POWER, digit=base.digit)


def _call(name: str, arguments: list[Printed]) -> Printed:
    if name == "abs" and len(arguments) == 1:
        return Printed(f"\\left| {arguments[0].text} \\right|", _ATOM)
    if name == "sum" and len(arguments) == 4:
        summand, index, lower, upper = arguments
        bounds = f"_{{{index.text} = {lower.text}}}^{{{upper.text}}}"
        return Printed(f"\\sum{bounds} {_at_least(summand, _PRODUCT)}", _PRODUCT)
    inner = ", ".join(argument.text for argument in arguments)
    return Printed(f"{name} \\left( {inner} \\right)", _ATOM)
