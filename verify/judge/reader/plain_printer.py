"""Expression graphs and relations printed as plain text that reads back to the same graphs."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.reader.plain_names import plain_name
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
from gainproof.verify.judge.reader.words import BASED, CASES, OF_CASES

_OPERATORS = {"approx": "~=", "sim": "~"}
_CONNECTIVES = {"iff": "<=>", "implies": "=>"}
_WORDS = {
    "log": "ln",
    "trace": "tr",
    "block_diagonal": "blkdiag",
    "covariance": "cov",
    "variance": "var",
}


def reading_to_plain(reading: Reading) -> str:
    """All relations and conditions of one reading."""
    relations = relations_to_plain(reading.relations)
    if not reading.conditions:
        return relations
    conditions = relations_to_plain(reading.conditions)
    if reading.connective == "if":
        return f"{relations} if {conditions}"
    return f"{relations} {_CONNECTIVES[reading.connective]} {conditions}"


def relations_to_plain(relations: Sequence[Relation]) -> str:
    """Relations joined by `and`; `a = b` before `b = c` becomes a chain again."""
    return " and ".join(relation_texts(relations, _OPERATORS, graph_to_plain, "(-0)"))


def graph_to_plain(graph: Graph, output: str = "value") -> str:
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
            return Printed("inf" if rest[0] == "infinity" else plain_name(str(rest[0])), ATOM)
        case "pow":
            return _power(done[int(rest[0])], Fraction(str(rest[1])))
        case "derivative":
            return _called("diff", [done[int(rest[0])].text, plain_name(str(rest[1]))])
        case "at":
            body, place = done[int(rest[0])].text, done[int(rest[2])].text
            return _called("at", [body, plain_name(str(rest[1])), place])
        case "call":
            return _call(str(rest[0]), [done[int(number)] for number in rest[1:]])
        case "matrix":
            return _matrix(int(rest[1]), [done[int(number)].text for number in rest[2:]])
    parts = [done[int(number)] for number in rest]
    texts = [part.text for part in parts]
    match kind:
        case "add":
            return _add(parts)
        case "mul":
            return Printed("*".join(_at_least(part, POWER) for part in parts), PRODUCT)
        case "div":
            return Printed("/".join(_at_least(part, POWER) for part in parts), PRODUCT)
        case "neg":
            return Printed(f"-{_at_least(parts[0], PRODUCT)}", SUM, negated=True)
        case "transpose" | "inverse":
            return _called(kind, texts)
        case "kronecker":
            return _called("kron", texts)
    raise ValueError(f"a node of kind {kind!r} has no printed form")


def _called(name: str, texts: Sequence[str]) -> Printed:
    return Printed(f"{name}({', '.join(texts)})", ATOM)


def _at_least(printed: Printed, level: int) -> str:
    return printed.text if printed.level >= level else f"({printed.text})"


def _number(value: Fraction) -> Printed:
    if value < 0:
        return Printed(f"-{_number(-value).text}", SUM, negated=True)
    text = decimal(value)
    return Printed(str(value), PRODUCT) if text is None else Printed(text, ATOM)


def _add(terms: list[Printed]) -> Printed:
    text = terms[0].text if terms[0].negated else _at_least(terms[0], PRODUCT)
    for term in terms[1:]:
        text += f" - {term.text[1:]}" if term.negated else f" + {_at_least(term, PRODUCT)}"
    return Printed(text, SUM)


def _power(base: Printed, exponent: Fraction) -> Printed:
    if exponent == Fraction(1, 2):
        return Printed(f"sqrt({base.text})", POWER)
    above = str(exponent) if exponent.denominator == 1 else f"({exponent})"
    return Printed(f"{_at_least(base, ATOM)}^{above}", POWER)


def _call(name: str, arguments: Sequence[Printed]) -> Printed:
    texts = [argument.text for argument in arguments]
    match name:
        case "pi" if not texts:
            return Printed("pi", ATOM)
        case "expectation":
            return Printed(f"E[{texts[0]}]", ATOM)
        case "order":
            return Printed(f"O({texts[0]})", ATOM)
        case "power":
            return Printed(f"{_at_least(arguments[0], ATOM)}^({texts[1]})", POWER)
    if name.startswith(OF_CASES):
        return Printed(f"{CASES}({'; '.join(case_texts(name, texts, ', ', ' and ', {}))})", ATOM)
    if name.startswith(BASED):
        return _called(name.replace(" ", ""), texts)
    return _called(_WORDS.get(name, plain_name(name)), texts)


def _matrix(columns: int, texts: list[str]) -> Printed:
    if len(texts) == 1:
        return _called("matrix", texts)
    rows = [", ".join(texts[n : n + columns]) for n in range(0, len(texts), columns)]
    return Printed(f"[{'; '.join(rows)}]", ATOM)
