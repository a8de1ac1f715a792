"""Expression graphs as text and LaTeX: what is written must read back as what was meant."""

from __future__ import annotations

import ast
import re
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gainproof.formulas.formula_latex import formula_latex
from gainproof.formulas.formula_term import LONGEST
from gainproof.formulas.formula_text import formula_text, plain_name

VALUES = {"a": Fraction(3, 7), "b": Fraction(5, 11), "c": Fraction(13, 17)}

Node = list[Any]


@st.composite
def graphs(draw: st.DrawFn) -> dict[str, Any]:
    """Random rational expressions in three symbols."""
    nodes: list[Node] = [["symbol", name] for name in VALUES]
    nodes += [["number", text] for text in ("2", "-3", "1/2", "-5/4")]
    for _ in range(draw(st.integers(1, 8))):
        child = st.integers(0, len(nodes) - 1)
        kind = draw(st.sampled_from(["add", "mul", "div", "neg", "pow"]))
        if kind == "neg":
            nodes.append(["neg", draw(child)])
        elif kind == "pow":
            nodes.append(["pow", draw(child), draw(st.sampled_from(["2", "3", "-1", "-2"]))])
        elif kind == "div":
            nodes.append(["div", draw(child), draw(child)])
        else:
            nodes.append([kind, *draw(st.lists(child, min_size=2, max_size=4))])
    return {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}


def value_of(graph: dict[str, Any]) -> Fraction:
    found: list[Fraction] = []
    for kind, *rest in graph["nodes"]:
        if kind == "number":
            found.append(Fraction(rest[0]))
        elif kind == "symbol":
            found.append(VALUES[rest[0]])
        elif kind == "pow":
            found.append(found[rest[0]] ** int(rest[1]))
        else:
            parts = [found[i] for i in rest]
            total = parts[0]
            for part in parts[1:]:
                total = (
                    total + part
                    if kind == "add"
                    else total * part
                    if kind == "mul"
                    else total / part
                )
            found.append(-total if kind == "neg" else total)
    return found[-1]


def read_back(text: str) -> Fraction:
    """The value of our text: juxtaposed factors are multiplied, then divided by the one after /."""
    python = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text).replace("^", "**")
    python = re.sub(r"\b(\d+)\b", r"Fraction(\1)", python)
    python = re.sub(r"\*\*Fraction\((\d+)\)", r"**\1", python)
    python = re.sub(r"\*\*\(-Fraction\((\d+)\)\)", r"**(-\1)", python)
    tree = ast.parse(python, mode="eval")
    value: Fraction = eval(compile(tree, "text", "eval"), {"Fraction": Fraction, **VALUES})  # noqa: S307
    return value


@given(graphs())
def test_text_means_what_the_graph_means(graph: dict[str, Any]) -> None:
    try:
        expected = value_of(graph)
    except (ZeroDivisionError, OverflowError):
        return
    assert read_back(formula_text(graph, {})) == expected


def single(*nodes: Node) -> dict[str, Any]:
    return {"nodes": list(nodes), "outputs": {"value": len(nodes) - 1}}


SUM = single(["symbol", "a"], ["number", "-1/2"], ["symbol", "b"], ["neg", 2], ["add", 0, 1, 3])
QUOTIENT = single(["symbol", "a"], ["symbol", "b"], ["mul", 0, 1], ["add", 0, 1], ["div", 2, 3])


@pytest.mark.parametrize(
    ("graph", "text", "latex"),
    [
        (SUM, "a - 1/2 - b", r"a - \frac{1}{2} - b"),
        (QUOTIENT, "a b/(a + b)", r"\frac{a b}{a + b}"),
        (single(["symbol", "a"], ["pow", 0, "1/2"]), "sqrt(a)", r"\sqrt{a}"),
        (single(["symbol", "a"], ["pow", 0, "-2"]), "1/a^2", r"\frac{1}{{a}^{2}}"),
        (
            single(
                ["symbol", "a"], ["number", "-3/4"], ["symbol", "b"], ["mul", 1, 0], ["add", 3, 2]
            ),
            "b - 3 a/4",
            r"b - \frac{3 a}{4}",
        ),
        (
            single(["symbol", "a"], ["pow", 0, "2"], ["pow", 1, "3"]),
            "(a^2)^3",
            r"{\left({a}^{2}\right)}^{3}",
        ),
        (
            single(
                ["number", "1/4"], ["symbol", "a"], ["div", 0, 1], ["symbol", "b"], ["div", 2, 3]
            ),
            "1/(4 a b)",
            r"\frac{1}{4 a b}",
        ),
        (
            single(["symbol", "a"], ["number", "2"], ["matrix", 2, 1, 0, 1]),
            "[a; 2]",
            r"\begin{pmatrix}a \\ 2\end{pmatrix}",
        ),
        (single(["symbol", "a"], ["derivative", 0, "b"]), "(d/db) a", r"\frac{d}{db} a"),
        (
            single(["symbol", "a"], ["derivative", 0, "b"], ["derivative", 1, "b"]),
            "(d/db)^2 a",
            r"\frac{d^{2}}{db^{2}} a",
        ),
        (
            single(["symbol", "a"], ["derivative", 0, "b"], ["derivative", 1, "c"]),
            "(d/dc) (d/db) a",
            r"\frac{d}{dc} \frac{d}{db} a",
        ),
        (
            single(["symbol", "a"], ["number", "2"], ["at", 0, "b", 1]),
            "a[b := 2]",
            r"\left.a\right|_{b = 2}",
        ),
        (
            single(["symbol", "a"], ["call", "abs", 0]),
            "abs(a)",
            r"\operatorname{abs}\left(a\right)",
        ),
    ],
)
def test_known_forms(graph: dict[str, Any], text: str, latex: str) -> None:
    assert formula_text(graph, {}) == text
    assert formula_latex(graph, {}) == latex


def test_names_are_replaced() -> None:
    graph = single(["symbol", "tracking_index"])
    assert formula_text(graph, {"tracking_index": "Lambda"}) == "Lambda"
    assert formula_latex(graph, {"tracking_index": r"\Lambda"}) == r"\Lambda"
    assert formula_latex(graph, {}) == r"\mathrm{tracking\_index}"


@pytest.mark.parametrize(
    ("latex", "word"),
    [
        (r"\alpha", "alpha"),
        ("M_{11}", "M11"),
        (r"\alpha_k", "alpha_k"),
        ("(FK)_1", "(FK)1"),
        (r"\operatorname{Re} z_1", "Re z1"),
        ("p", "p"),
    ],
)
def test_plain_name(latex: str, word: str) -> None:
    assert plain_name(latex) == word


def test_text_that_would_explode_is_cut_short() -> None:
    nodes: list[Node] = [["symbol", "a"]]
    nodes += [["add", i, i] for i in range(60)]
    assert len(formula_text(single(*nodes), {})) < LONGEST
    assert len(formula_latex(single(*nodes), {})) < LONGEST
