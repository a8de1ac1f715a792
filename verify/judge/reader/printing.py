"""What the printers of LaTeX and of plain text share: how tightly a text binds, numbers, the order
of nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import takewhile
from typing import NamedTuple

from gainproof.verify.judge.formula import Decimals, Graph, Relation
from gainproof.verify.judge.reader.decimals import power_of_ten
from gainproof.verify.judge.reader.formula_limits import MOST_PRINTED_CHARACTERS

SUM, PRODUCT, POWER, ATOM = range(4)


class Printed(NamedTuple):
    """The text of a node, how tightly it binds, whether it begins with a digit or is a negated
    term.
    """

    text: str
    level: int
    digit: bool = False
    negated: bool = False


PrintNode = Callable[[Sequence[str | int], Sequence[Printed]], Printed]


def print_graph(graph: Graph, output: str, node_text: PrintNode) -> Printed:
    """One output of a graph, its nodes printed in their order, without recursion: a deep graph is
    no danger. ValueError if the text is too long.
    """
    printed: list[Printed] = []
    for node in graph["nodes"]:
        printed.append(node_text(node, printed))
        if len(printed[-1].text) > MOST_PRINTED_CHARACTERS:
            raise ValueError(f"a formula of more than {MOST_PRINTED_CHARACTERS} characters")
    value: int = graph["outputs"][output]
    return printed[value]


def case_texts(
    name: str, texts: Sequence[str], behind: str, joint: str, operators: Mapping[str, str]
) -> list[str]:
    """The cases of a call, each with what stands `behind` its value before the conditions."""
    rest = iter(texts)
    found = []
    for signs in name.split(" ")[1:]:
        value = next(rest)
        each = [] if signs == "-" else signs.split(",")
        rels = [f"{next(rest)} {operators.get(sign, sign)} {next(rest)}" for sign in each]
        found.append(f"{value}{behind}{joint.join(rels)}" if rels else value)
    return found


def decimal(value: Fraction) -> str | None:
    """A number that is not negative with a decimal point, or None where it does not end."""
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
    return f"{digits[:-places]}.{digits[-places:]}" if places else digits


def with_decimals(graph: Graph, text: str, decimals: Decimals | None) -> str:
    """A side that is one number, with as many decimals as the print showed: `0.50`, not `0.5`."""
    power = power_of_ten(graph)
    if not isinstance(decimals, int) or power is None or decimals + power <= 0:
        return text
    sign = "-" if text.startswith("-") else ""
    digits = "".join(takewhile(lambda c: c.isdigit() or c == ".", text[len(sign) :]))
    whole, _, places = digits.partition(".")
    return f"{sign}{whole}.{places.ljust(decimals + power, '0')}{text[len(sign + digits) :]}"


def _side_text(graph: Graph, decimals: Decimals | None, text: Callable[[Graph], str]) -> str:
    """A side, with the decimals that it showed: also those of the entries of a matrix."""
    if not isinstance(decimals, tuple):
        return with_decimals(graph, text(graph), decimals)
    nodes = [*graph["nodes"]]
    top = nodes[graph["outputs"]["value"]]
    turned = top[0] == "transpose"
    kind, rows, columns, *parts = nodes[top[1]] if turned else top
    for place, part in enumerate(parts):
        entry = {"nodes": graph["nodes"], "outputs": {"value": part}}
        r, c = divmod(place, columns)
        count = decimals[c * rows + r if turned else place]
        nodes.append(["symbol", with_decimals(entry, text(entry), count)])
    nodes.append([kind, rows, columns, *range(len(nodes) - len(parts), len(nodes))])
    if turned:
        nodes.append(["transpose", len(nodes) - 1])
    return text({"nodes": nodes, "outputs": {"value": len(nodes) - 1}})


def is_continued(before: Relation, relation: Relation) -> bool:
    """Whether `a = b` and then `b = c` may be printed as one chain."""
    return before.right == relation.left and "->" not in (relation.operator, before.operator)


def relation_texts(
    relations: Sequence[Relation],
    operators: Mapping[str, str],
    text: Callable[[Graph], str],
    minus_zero: str,
) -> list[str]:
    """Relations one by one; `a = b` before `b = c` becomes a chain again."""
    pieces: list[str] = []
    for number, relation in enumerate(relations):
        operator = operators.get(relation.operator, relation.operator)
        right = _side_text(relation.right, relation.right_decimals, text)
        if right == "-0" and relation.operator == "->":
            right = minus_zero  # else it would say from which side
        if number and is_continued(relations[number - 1], relation):
            pieces[-1] += f" {operator} {right}"
        else:
            left = _side_text(relation.left, relation.left_decimals, text)
            pieces.append(f"{left} {operator} {right}")
    return pieces
