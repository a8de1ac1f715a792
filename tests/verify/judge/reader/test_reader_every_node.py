"""Graphs of all kinds of nodes are printed, as LaTeX and as plain text, and read again as they
were.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from declared import Declared
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.reader.plain_printer import graph_to_plain
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_expression
from gainproof.verify.judge.reader.words import FUNCTION_WORDS

NUMBERS = (r"\alpha", r"\sigma_{vk}", "k", "T", r"\hat{x}_k(+)", "x^{-}", "E", "e", "d", "O", "x'")
MATRICES = ("A", r"\underline{x}_{sk-1}", r"\Phi", r"\mathbf{0}")
SYMBOLS: Mapping[str, Declared] = (
    {canonical_token(token): Declared() for token in NUMBERS if token not in ("E", "O", "e", "d")}
    | {canonical_token(token): Declared(shape=(2, 2)) for token in MATRICES}
    | {"S": Declared(("k", "T")), r"\tilde{P}": Declared(("k",), (2, 2))}
)
PLAIN_SYMBOLS = tuple(name for name, entry in SYMBOLS.items() if entry == Declared())
MANY = ("max", "min")
TWO = ("atan2", "mod")
CASES = ("cases > -", "cases <,!=", "cases >=,<= = -")
OF_MATRIX = ("det", "trace", "rank")
ONE = tuple(
    sorted(
        set(FUNCTION_WORDS.values())
        - {*TWO, *MANY, *OF_MATRIX, "diag", "block_diagonal", "covariance"}
    )
)

Tree = tuple[Any, ...]
"""A node with its arguments in place of their numbers."""


def graph_of(tree: Tree) -> Graph:
    """The tree as a graph, numbered from left to right, arguments first, equal parts shared."""
    numbers: dict[Tree, int] = {}
    nodes: list[list[Any]] = []

    def number(part: Tree) -> int:
        if part not in numbers:
            node = [number(item) if isinstance(item, tuple) else item for item in part]
            numbers[part] = len(nodes)
            nodes.append(node)
        return numbers[part]

    return {"nodes": nodes, "outputs": {"value": number(tree)}}


def numbers() -> st.SearchStrategy[Tree]:
    values = ("0", "1", "2", "17", "1/2", "11/4", "1/1000")
    return st.sampled_from(values).map(lambda value: ("number", value))


def symbols() -> st.SearchStrategy[Tree]:
    return st.sampled_from(PLAIN_SYMBOLS).map(lambda name: ("symbol", name))


def matrix_symbols() -> st.SearchStrategy[Tree]:
    names = [name for name, entry in SYMBOLS.items() if entry.shape and not entry.arguments]
    return st.sampled_from(names).map(lambda name: ("symbol", name))


INFINITY: Tree = ("symbol", "infinity")


NODES = (
    *("add", "mul", "div", "neg", "pow", "power", "power T", "at", "derivative", "sum", "product"),
    *("integral", "abs", "norm", "order", "expectation", "one", "two", "many", "of matrix", "S"),
    "cases",
)
MATRIX_NODES = (
    *("matrix", "stacked", "add", "transpose", "inverse", "inverse transpose", "kronecker", "mul"),
    *("div", "neg", "pow", "power", "expectation", "function", "inverse function", "diag"),
    *("block_diagonal", "covariance", "derivative", "at"),
)


@st.composite
def larger_number(draw: st.DrawFn, inner: st.SearchStrategy[Tree]) -> Tree:
    """One more node round numbers and matrices of numbers."""
    kind, a = draw(st.sampled_from(NODES)), draw(inner)
    match kind:
        case "add" | "mul":
            return (kind, *draw(st.lists(inner, min_size=2, max_size=3)))
        case "div":
            return ("div", a, draw(inner))
        case "neg":
            return ("neg", a)
        case "pow":
            return ("pow", a, draw(st.sampled_from(("2", "-1", "3", "1/2", "1/3", "-3/2", "64"))))
        case "power":
            return ("call", "power", a, ("add", draw(inner), draw(symbols())))
        case "power T":
            return ("call", "power", a, ("symbol", "T"))
        case "at":
            return ("at", a, draw(symbols())[1], draw(st.one_of(inner, st.just(INFINITY))))
        case "derivative":
            return ("derivative", a, draw(symbols())[1])
        case "sum" | "product" | "integral":
            upper = draw(st.one_of(inner, st.just(INFINITY)))
            return ("call", kind, a, draw(symbols()), draw(inner), upper)
        case "one":
            return ("call", draw(st.sampled_from(ONE)), a)
        case "two":
            return ("call", draw(st.sampled_from(TWO)), a, draw(inner))
        case "S":
            return ("call", "S", a, draw(inner))
        case "cases":
            name = draw(st.sampled_from(CASES))
            count = sum(1 if each == "-" else 3 + 2 * each.count(",") for each in name.split()[1:])
            return ("call", name, a, *[draw(inner) for _ in range(count - 1)])
        case "many":
            return ("call", draw(st.sampled_from(MANY)), a, draw(inner))
        case "of matrix":
            return ("call", draw(st.sampled_from(OF_MATRIX)), draw(matrices(inner)))
    return ("call", kind, a)


@st.composite
def matrices(draw: st.DrawFn, inner: st.SearchStrategy[Tree]) -> Tree:
    """A matrix of one or two storeys over numbers."""
    below = draw(matrix_symbols())
    if draw(st.booleans()):
        rows, columns = draw(st.sampled_from(((1, 1), (1, 2), (2, 1), (2, 2))))
        entries = draw(st.lists(inner, min_size=rows * columns, max_size=rows * columns))
        below = ("matrix", rows, columns, *entries)
    kind, other = draw(st.sampled_from(MATRIX_NODES)), draw(matrix_symbols())
    match kind:
        case "matrix":
            return below
        case "stacked":
            return ("matrix", 2, 1, other, below)
        case "add":
            return ("add", below, other)
        case "transpose" | "inverse" | "neg":
            return (kind, below)
        case "inverse transpose":
            return ("transpose", ("inverse", below))
        case "kronecker":
            return ("kronecker", ("kronecker", other, below), other)
        case "mul":
            return ("mul", draw(inner), below, other)
        case "div":
            return ("div", below, draw(inner))
        case "pow":
            return ("pow", below, "2")
        case "power":
            return ("call", "power", below, ("symbol", "k"))
        case "expectation":
            return ("call", kind, ("mul", below, ("transpose", other)))
        case "function":
            return ("call", r"\tilde{P}", draw(inner))
        case "inverse function":
            return ("inverse", ("call", r"\tilde{P}", draw(inner)))
        case "diag":
            return ("call", kind, draw(inner), draw(inner))
        case "derivative":
            return (kind, below, "k")
        case "at":
            return (kind, below, "k", ("number", "0"))
    return ("call", kind, other, below)


def trees() -> st.SearchStrategy[Tree]:
    return st.recursive(st.one_of(numbers(), symbols()), larger_number, max_leaves=8)


MANY_EXAMPLES = settings(
    max_examples=samples(75),
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


def is_readable(tree: Tree) -> bool:
    """Numbers such as 1/3 are quotients in print; no other node is out of reach."""
    return len(graph_to_latex(graph_of(tree))) < 3000


@MANY_EXAMPLES
@given(trees().filter(is_readable))
def test_numbers(tree: Tree) -> None:
    graph = graph_of(tree)
    assert read_expression(graph_to_latex(graph), SYMBOLS) == (graph,)
    assert read_expression(graph_to_plain(graph), SYMBOLS, plain=True) == (graph,)


@MANY_EXAMPLES
@given(matrices(trees()).filter(is_readable))
def test_matrices(tree: Tree) -> None:
    graph = graph_of(tree)
    assert read_expression(graph_to_latex(graph), SYMBOLS) == (graph,)
    assert read_expression(graph_to_plain(graph), SYMBOLS, plain=True) == (graph,)


@pytest.mark.parametrize("kind", ["select", "boolean"])
def test_a_node_without_printed_form_is_named(kind: str) -> None:
    graph = {"nodes": [["symbol", "k"], [kind, 0]], "outputs": {"value": 1}}
    for printer in (graph_to_latex, graph_to_plain):
        with pytest.raises(ValueError, match=kind):
            printer(graph)
