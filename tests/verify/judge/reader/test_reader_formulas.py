"""What the reader makes of printed formulas."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import pytest

from gainproof.verify.judge.formula import INFINITY, MINUS_INFINITY, Relation
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_conditions, read_expression, read_formula


@dataclass(frozen=True)
class Declared:
    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False


TOKENS = (
    r"\alpha \beta \gamma \alpha_k \beta_k k T a b c i x By x_{sk} x_{sk-1} x_{ok}"
    r" \dot{x}_{sk-1} \ddot{x} x' x'_k \sigma_p e_{\text{fin}} \underline{x}_k"
)
SYMBOLS: dict[str, Declared] = {canonical_token(token): Declared() for token in TOKENS.split()}
SYMBOLS["S"] = Declared(("a", "b"))


def expression(text: str) -> Mapping[str, Any]:
    (graph,) = read_expression(text, SYMBOLS)
    return graph


def written(graph: Mapping[str, Any]) -> str:
    """The graph as nested calls, independent of the printer under test."""
    done: list[str] = []
    for kind, *rest in graph["nodes"]:
        match kind:
            case "number" | "symbol":
                done.append(rest[0])
            case "pow":
                done.append(f"pow({done[rest[0]]}, {rest[1]})")
            case "derivative":
                done.append(f"derivative({done[rest[0]]}, {rest[1]})")
            case "call":
                done.append(f"{rest[0]}({', '.join(done[i] for i in rest[1:])})")
            case _:
                done.append(f"{kind}({', '.join(done[i] for i in rest)})")
    value: int = graph["outputs"]["value"]
    return done[value]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (r"2\alpha\beta", r"mul(2, \alpha, \beta)"),
        ("kT", "mul(k, T)"),
        ("By", "By"),
        ("aBy", "mul(a, By)"),
        ("aiT + b", "add(mul(a, i, T), b)"),
        ("a - b - c", "add(a, neg(b), neg(c))"),
        ("-a b + c", "add(neg(mul(a, b)), c)"),
        ("-a^2", "neg(pow(a, 2))"),
        ("(-a)^2", "pow(neg(a), 2)"),
        ("(a + b) + c", "add(add(a, b), c)"),
        ("a (b c)", "mul(a, mul(b, c))"),
        ("a / b / c", "div(div(a, b), c)"),
        ("a b / c", "div(mul(a, b), c)"),
        (r"\frac12", "div(1, 2)"),
        (r"\frac1{k+1}", "div(1, add(k, 1))"),
        (r"\tfrac ab", "div(a, b)"),
        (r"\dfrac{a}2c", "mul(div(a, 2), c)"),
        (r"\frac\alpha\beta", r"div(\alpha, \beta)"),
        (r"\frac{\alpha_k}{\frac{1}{2}}", r"div(\alpha_k, div(1, 2))"),
        (r"\sqrt2", "pow(2, 1/2)"),
        (r"\sqrt{a + \sqrt b}", "pow(add(a, pow(b, 1/2)), 1/2)"),
        (r"\sqrt[3]{a}", "pow(a, 1/3)"),
        ("a^{1/2}", "pow(a, 1/2)"),
        (r"a^{-\frac32}", "pow(a, -3/2)"),
        ("a^{-1}b", "mul(pow(a, -1), b)"),
        ("a^2b", "mul(pow(a, 2), b)"),
        ("0.095", "19/200"),
        (r"1.50 \cdot 2", "mul(3/2, 2)"),
        (r"\left( a + \frac{b}{2} \right)^2", "pow(add(a, div(b, 2)), 2)"),
        (r"\{a [b - (c)]\}", "mul(a, add(b, neg(c)))"),
        (r"\Bigl\{a\Bigr\}", "a"),
        (r"{a} {(b)}^2", "mul(a, pow(b, 2))"),
        (r"\left| a - b \right|", "abs(add(a, neg(b)))"),
        (r"\lvert a \rvert b", "mul(abs(a), b)"),
        ("S(a, b) c", "mul(S(a, b), c)"),
        ("a(b)", "mul(a, b)"),
        (r"a \times b \cdot c * k", "mul(a, b, c, k)"),
        (r"\sum_{i=0}^k i a", "sum(mul(i, a), i, 0, k)"),
        (r"a \cdot \sum_{i=1}^{k+1} (i + b)", "mul(a, sum(add(i, b), i, 1, add(k, 1)))"),
        (r"\frac{\partial}{\partial a} S(a,b)", "derivative(S(a, b), a)"),
        (r"\frac{\partial a^2b}{\partial a} c", "mul(derivative(mul(pow(a, 2), b), a), c)"),
        (r"x'_k x' x", "mul(x'_k, x', x)"),
        (r"a \, b \; c \: k ~ T", "mul(a, b, c, k, T)"),
    ],
)
def test_expression(text: str, wanted: str) -> None:
    assert written(expression(text)) == wanted


@pytest.mark.parametrize(
    "text",
    [
        r"\dot{x}_{sk-1}",
        r"\dot x_{s k-1}",
        r"\dot{ x }_{ sk - 1 }",
        r"\dot{{x}}_{sk-1}",
    ],
)
def test_spellings_of_one_symbol(text: str) -> None:
    assert written(expression(text)) == r"\dot{x}_{sk-1}"


def test_longest_declared_name_wins() -> None:
    assert written(expression("x_{sk-1}")) == "x_{sk-1}"
    assert written(expression("x_{sk}-1")) == "add(x_{sk}, neg(1))"


def test_equal_parts_share_a_node() -> None:
    graph = expression("(a + b)(a + b) + (a + b)^2")
    assert [node[0] for node in graph["nodes"]].count("add") == 2


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (r"1/2\sqrt2", {"mul(div(1, 2), pow(2, 1/2))", "div(1, mul(2, pow(2, 1/2)))"}),
        ("4a/bT^2", {"mul(div(mul(4, a), b), pow(T, 2))", "div(mul(4, a), mul(b, pow(T, 2)))"}),
        (r"a/T\cdot(b)", {"mul(div(a, T), b)", "div(a, mul(T, b))"}),
        (
            r"a/bc\cdot k",
            {"mul(div(a, b), c, k)", "mul(div(a, mul(b, c)), k)", "div(a, mul(b, c, k))"},
        ),
        ("a/bc/k", {"div(mul(div(a, b), c), k)", "div(div(a, mul(b, c)), k)"}),
    ],
)
def test_every_reading_of_a_slash(text: str, wanted: set[str]) -> None:
    assert {written(graph) for graph in read_expression(text, SYMBOLS)} == wanted


def test_readings_are_named() -> None:
    formula = read_formula(r"a = \beta_k / T \cdot (b - c)", SYMBOLS)
    assert [reading.text for reading in formula.readings] == [
        "the slash of column 13 divides by T",
        r"the slash of column 13 divides by T \cdot (b - c)",
    ]
    assert read_formula("a = b/c", SYMBOLS).readings[0].text is None


def relations(found: tuple[Relation, ...]) -> list[str]:
    return [f"{written(r.left)} {r.operator} {written(r.right)}" for r in found]


def test_chain_and_conditions() -> None:
    formula = read_formula(r"a = b = c \quad (1 \leq k, a > 0) (b \ne 0)", SYMBOLS)
    (reading,) = formula.readings
    assert relations(reading.relations) == ["a = b", "b = c"]
    assert relations(reading.conditions) == ["1 <= k", "a > 0", "b != 0"]
    assert reading.connective == "if"
    assert formula.symbols == ("a", "b", "c", "k")


def test_limit() -> None:
    (reading,) = read_formula(r"\alpha_k \rightarrow 0 \quad (k \to \infty)", SYMBOLS).readings
    assert relations(reading.relations) == [r"\alpha_k -> 0"]
    assert reading.conditions == (Relation("->", expression("k"), INFINITY),)
    (reading,) = read_formula(r"a \to 0 (k \to -\infty)", SYMBOLS).readings
    assert reading.conditions[0].right == MINUS_INFINITY


@pytest.mark.parametrize(
    "text",
    [
        r"0 < \alpha \quad \text{and} \quad 0 < \beta < 4 - 2\alpha",
        r"0 < \alpha and 0 < \beta < 4 - 2\alpha",
        r"0 < \alpha, 0 < \beta < 4 - 2\alpha",
        r"0 < \alpha \quad 0 < \beta < 4 - 2\alpha \qquad",
        r"0 < \alpha, \qquad 0 < \beta < 4 - 2\alpha",
        r"\begin{aligned}0 &< \alpha \\ 0 &< \beta < 4 - 2\alpha\end{aligned}",
    ],
)
def test_several_relations(text: str) -> None:
    (reading,) = read_formula(text, SYMBOLS).readings
    assert relations(reading.relations) == [
        r"0 < \alpha",
        r"0 < \beta",
        r"\beta < add(4, neg(mul(2, \alpha)))",
    ]


@pytest.mark.parametrize(
    ("arrow", "connective"), [(r"\Leftrightarrow", "iff"), (r"\Rightarrow", "implies")]
)
def test_relations_between_relations(arrow: str, connective: str) -> None:
    (reading,) = read_formula(rf"a = b {arrow} b = a", SYMBOLS).readings
    assert relations(reading.relations) == ["a = b"]
    assert relations(reading.conditions) == ["b = a"]
    assert reading.connective == connective


def test_operators() -> None:
    text = r"a \le b, a \leqq b, a <= b, a \geq b, a >= b, a \approx b, a \simeq b, a -> b"
    operators = [relation.operator for relation in read_conditions(text, SYMBOLS)]
    assert operators == ["<=", "<=", "<=", ">=", ">=", "approx", "approx", "->"]
