"""Nodes of calls: declared functions, named functions, and the words of plain text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from lark import Token

from gainproof.verify.judge.reader.constant import constant_value
from gainproof.verify.judge.reader.matrix_nodes import inverse, transposed
from gainproof.verify.judge.reader.syntax_tree import Branch, children, sole, tokens
from gainproof.verify.judge.reader.words import PLAIN_FORMS

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.graph_building import Builder

_COUNTS = {"atan2": (2, 2), "mod": (2, 2), "max": (1, 8), "min": (1, 8), "diag": (1, 16)} | {
    "block_diagonal": (1, 16),
    "covariance": (1, 2),
}
_BOUNDS = {"at": (2,), "sum": (2, 3), "product": (2, 3), "integral": (2, 3), "family": (2, 3)}
"""Which arguments may be infinite, counted from 0."""


def call(builder: Builder, tree: Branch) -> int:
    """A declared function of its arguments; between name and brackets only the inverse or the
    transpose of a matrix may stand.
    """
    name = str(tokens(tree, "FUNCTION")[0])
    arguments = children(tree)
    above = arguments.pop(0) if tree.data == "call_raised" else None
    number = builder.nodes.add("call", name, *[builder.value(item) for item in arguments])
    if tree.data == "call_transposed":
        return transposed(builder, number, tokens(tree, "TRANSPOSE")[0])
    if above is None:
        return number
    if not builder.nodes.is_matrix(number):
        problem = f"an exponent between {name} and its brackets: write it behind them"
        raise builder.error(problem, above)
    return builder.power(number, above)


def named(builder: Builder, word: Token, arguments: list[Branch], tree: Branch) -> int:
    """A function of the reader's own table, or a word of plain text."""
    name = str(word)
    if name in PLAIN_FORMS:
        return _plain_form(builder, word, arguments, tree)
    least, most = _COUNTS.get(name, (1, 1))
    if not least <= len(arguments) <= most:
        wanted = str(least) if least == most else f"{least} to {most}"
        problem = f"{name} takes {wanted} arguments, not {len(arguments)}"
        raise builder.error(problem, tree)
    _refuse_infinity(builder, arguments)
    return builder.nodes.add("call", name, *[builder.value(item) for item in arguments])


def named_raised(builder: Builder, tree: Branch) -> int:
    """`\\sin^2 x`. ReaderError for a negative exponent, which may mean the inverse function."""
    above, arguments = children(tree)
    exponent = constant_value(above)
    name = str(tokens(tree, "NAMED")[0])
    if exponent is not None and exponent <= 0:
        problem = f"{name} with exponent {exponent} may be its inverse: write 1/{name} or arc{name}"
        raise builder.error(problem, above)
    least, most = _COUNTS.get(name, (1, 1))
    inner = children(arguments)
    if not least <= len(inner) <= most:
        raise builder.error(f"{name} does not take {len(inner)} arguments", tree)
    _refuse_infinity(builder, inner)
    number = builder.nodes.add("call", name, *[builder.value(item) for item in inner])
    return builder.power(number, above)


def _refuse_infinity(builder: Builder, arguments: list[Branch]) -> None:
    for argument in arguments:
        if argument.data == "infinity":
            raise builder.error("\\infty may only be a bound, or the end of an arrow", argument)


def _plain_form(builder: Builder, word: Token, arguments: list[Branch], tree: Branch) -> int:
    """What LaTeX prints with signs: `transpose(A)`, `sum(f, i, 0, k)`, `diff(f, x)`."""
    name = str(word)
    if len(arguments) != PLAIN_FORMS[name]:
        problem = f"{name} takes {PLAIN_FORMS[name]} arguments, not {len(arguments)}"
        raise builder.error(problem, tree)
    finite = [a for n, a in enumerate(arguments) if n not in _BOUNDS.get(name, ())]
    _refuse_infinity(builder, finite)
    numbers = [builder.value(argument) for argument in arguments]
    add = builder.nodes.add
    match name:
        case "abs" | "norm":
            return add("call", name, numbers[0])
        case "transpose":
            return transposed(builder, numbers[0], word)
        case "inverse":
            return inverse(builder, numbers[0], tree)
        case "matrix":
            return add("matrix", 1, 1, numbers[0])
        case "kron":
            return add("kronecker", *numbers)
        case "pow":
            builder.refuse_entries(tree, *numbers)
            return builder.power(numbers[0], arguments[1], of_code=True)
        case "hypot":
            builder.refuse_entries(tree, *numbers)
            squares = [add("pow", number, "2") for number in numbers]
            return add("pow", add("add", *squares), "1/2")
    symbol = sole(arguments[1])
    if symbol.data != "symbol":
        raise builder.error(f"the second argument of {name} must be a symbol", arguments[1])
    variable = str(symbol.children[0])
    if name == "diff":
        return add("derivative", numbers[0], variable)
    if name == "at":
        return add("at", numbers[0], variable, numbers[2])
    return add("call", name, *numbers)
