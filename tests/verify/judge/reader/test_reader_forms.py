"""What the reader makes of matrices, functions, derivatives, integrals, bars, dots and limits,
written out by hand: no printer has a say here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from declared import Declared

from gainproof.verify.judge.formula import INFINITY, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_expression, read_formula

NUMBERS = r"a b c k n T x y \alpha \theta \sigma_v x_k^{-} \hat{x}_k(+) b_i b_1 b_2 b_n P(k|k-1)"
SYMBOLS = (
    {canonical_token(name): Declared() for name in NUMBERS.split()}
    | {name: Declared(shape=(2, 2)) for name in ("A", "B", canonical_token(r"\underline{x}"))}
    | {"i": Declared(integer=True), "f": Declared(("x",)), "P": Declared(("n",), (2, 2))}
    | {"w": Declared(("i",))}
)


def written(graph: Mapping[str, Any]) -> str:
    """The graph as nested calls."""
    done: list[str] = []
    for kind, *rest in graph["nodes"]:
        match kind:
            case "number" | "symbol":
                done.append(rest[0])
            case "pow" | "derivative":
                done.append(f"{kind}({done[rest[0]]}, {rest[1]})")
            case "at":
                done.append(f"at({done[rest[0]]}, {rest[1]}, {done[rest[2]]})")
            case "call":
                done.append(f"{rest[0]}({', '.join(done[i] for i in rest[1:])})")
            case "matrix":
                inner = ", ".join(done[i] for i in rest[2:])
                done.append(f"matrix({rest[0]} by {rest[1]}: {inner})")
            case _:
                done.append(f"{kind}({', '.join(done[i] for i in rest)})")
    value: int = graph["outputs"]["value"]
    return done[value]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (r"\log a", "log 10(a)"),
        (r"\log^2 \frac{a}{b}", "pow(log 10(div(a, b)), 2)"),
        (r"\operatorname{log}(a) + \mathrm{log} b", "add(log 10(a), log 10(b))"),
        (r"\ln a + \operatorname{ln} b", "add(log(a), log(b))"),
        (r"\log_e a + \log_2 a + \lg a", "add(log(a), log 2(a), log 10(a))"),
    ],
)
def test_what_a_source_means_by_a_logarithm_without_a_base(text: str, wanted: str) -> None:
    (graph,) = read_expression(text, SYMBOLS, logarithm=10)
    assert written(graph) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("log(a) + ln(b)", "add(log 10(a), log(b))"),
        ("log2(a) + lg(b)", "add(log 2(a), log 10(b))"),
    ],
)
def test_in_plain_text_too(text: str, wanted: str) -> None:
    (graph,) = read_expression(text, SYMBOLS, plain=True, logarithm=10)
    assert written(graph) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (r"{a + b \over c}", "div(add(a, b), c)"),
        (r"a^\frac12", "pow(a, 1/2)"),
        (r"\log_{10} a", "log 10(a)"),
        (r"\log_2^3(a b)", "pow(log 2(mul(a, b)), 3)"),
        (r"\operatorname{log}_{ 10 } a + \mathrm{lg}(b)",
         "add(log 10(a), log 10(b))"),
        (r"\log_e a", "log(a)"),
        (r"a 10^{b/10}", "mul(a, power(10, div(b, 10)))"),
        (r"e^{-T} + 2^T + 10^{T}", "add(exp(neg(T)), power(2, T), power(10, T))"),
        ("c^{k+1}", "power(c, add(k, 1))"),
        (r"\sigma^2_v", r"pow(\sigma_v, 2)"),
        (r"x^-_k + \hat x_k (+)", r"add(x_k^{-}, \hat{x}_k(+))"),
        (r"P(k \mid k{-}1)", "P(k|k-1)"),
        (r"\begin{pmatrix} 1 & T \\ 0 & 1 \end{pmatrix}", "matrix(2 by 2: 1, T, 0, 1)"),
        (r"\left[\begin{smallmatrix} a \\ b \\[2pt] \end{smallmatrix}\right]",
         "matrix(2 by 1: a, b)"),
        (r"\begin{vmatrix} a & b \\ b & a \end{vmatrix}", "det(matrix(2 by 2: a, b, b, a))"),
        (r"[1\ 0]", "matrix(1 by 2: 1, 0)"),
        (r"(a \quad b + c)^\top", "transpose(matrix(1 by 2: a, add(b, c)))"),
        (r"\begin{bmatrix} A & B \end{bmatrix}", "matrix(1 by 2: A, B)"),
        ("A B^{-1} A^{-T}", "mul(A, inverse(B), transpose(inverse(A)))"),
        ("(A + B)^{-1}", "inverse(add(A, B))"),
        ("a^{-1} A^2", "mul(pow(a, -1), pow(A, 2))"),
        (r"A \otimes B \otimes A", "kronecker(kronecker(A, B), A)"),
        ("P^{-1}(n) P(n+1)^T", "mul(inverse(P(n)), transpose(P(add(n, 1))))"),
        (r"E[\underline{x}\underline{x}^T]",
         r"expectation(mul(\underline{x}, transpose(\underline{x})))"),
        (r"\mathbb{E} \left\{ x \right\} + 1", "add(expectation(x), 1)"),
        (r"2 \sin^2 \theta \cos 2\theta", r"mul(2, pow(sin(\theta), 2), cos(mul(2, \theta)))"),
        (r"\ln(a b) \arctan \frac{a}{b}", "mul(log(mul(a, b)), atan(div(a, b)))"),
        (r"\log \left|a\right| + b", "add(log(abs(a)), b)"),
        (r"2 \log^2 \lvert a - b \rvert", "mul(2, pow(log(abs(add(a, neg(b)))), 2))"),
        (r"\det \begin{pmatrix} a & b \\ c & 1 \end{pmatrix} \cdot \det A",
         "mul(det(matrix(2 by 2: a, b, c, 1)), det(A))"),
        (r"\operatorname{atan2}(x, y)", "atan2(x, y)"),
        ("e^{-a/2}", "exp(neg(div(a, 2)))"),
        (r"a + O(k^2)", "add(a, order(pow(k, 2)))"),
        (r"\sum_{k=1}^n k a + b", "add(sum(mul(k, a), k, 1, n), b)"),
        (r"\prod^{T}_{k=0} k", "product(k, k, 0, T)"),
        # one over the same index does not stand under it, one that holds the index does
        (r"\prod_{k=0}^T a k \prod_{k=1}^T b",
         "mul(product(mul(a, k), k, 0, T), product(b, k, 1, T))"),
        (r"a \sum_{k=0}^T k \cdot \sum^T_{k=1} b \prod_{k=2}^T c",
         "mul(a, mul(sum(k, k, 0, T), mul(sum(b, k, 1, T), product(c, k, 2, T))))"),
        (r"\prod_{k=0}^T a \sum_{n=0}^{k} n",
         "product(mul(a, sum(n, n, 0, k)), k, 0, T)"),
        (r"\prod_{k=0}^T \prod_{n=0}^T a", "product(product(a, n, 0, T), k, 0, T)"),
        (r"\prod_{k=0}^T (a \prod_{n=0}^T b)", "product(mul(a, product(b, n, 0, T)), k, 0, T)"),
        (r"\sum_{k=0}^T a \prod_{n=0}^T b", "sum(mul(a, product(b, n, 0, T)), k, 0, T)"),
        (r"\sum_{k=0}^\infty \frac{1}{k}", "sum(div(1, k), k, 0, infinity)"),
        (r"a \int_0^T x + 1 \, dx", "mul(a, integral(add(x, 1), x, 0, T))"),
        (r"\int_{-\infty}^{\infty} x \, \mathrm{d} x",
         "integral(x, x, neg(infinity), infinity)"),
        (r"\frac{dx}{dy} + \frac{\mathrm{d}}{\mathrm{d} y} x",
         "add(derivative(x, y), derivative(x, y))"),
        (r"\frac{\partial^3 a}{\partial x^2 \partial y}",
         "derivative(derivative(derivative(a, y), x), x)"),
        (r"\left. a + b \right|_{x = 1, y = 2}", "at(at(add(a, b), x, 1), y, 2)"),
        (r"a|_{x=\infty} b", "mul(at(a, x, infinity), b)"),
        (r"b_1 + b_2 + \cdots + b_n", "sum(b_i, i, 1, n)"),
        (r"b_1^2 b_2^2 \dots b_n^2", "product(pow(b_i, 2), i, 1, n)"),
        (r"w(1) a + \cdots + w(n) a", "sum(mul(w(i), a), i, 1, n)"),
        (r"(b_1, \cdots, b_n)", "family(b_i, i, 1, n)"),
        (r"\begin{pmatrix} b_1 \\ \vdots \\ b_n \end{pmatrix}",
         "transpose(family(b_i, i, 1, n))"),
    ],
)  # fmt: skip
def test_expression(text: str, wanted: str) -> None:
    (graph,) = read_expression(text, SYMBOLS)
    assert written(graph) == wanted


@pytest.mark.parametrize(
    "text",
    [
        r"\begin{align} a &= b \\ &= c - k, \\ -x &= y \end{align}",
        r"a = b = c \\ - k \\ -x &= y".replace("&", ""),
        r"a = b \\ = c - k \quad -x = y",
        r"\begin{split} a &= b = c \\ &- k, \\ &-x = y \end{split}".replace("&-x", "-x &"),
        r"a = b = c - \\ k, -x = y",
    ],
)
def test_lines(text: str) -> None:
    if r"\\ -x = y" in text:
        with pytest.raises(ReaderError, match="not clear"):
            read_formula(text, SYMBOLS)
        return
    (reading,) = read_formula(text, SYMBOLS).readings
    shown = [(r.operator, written(r.left), written(r.right)) for r in reading.relations]
    assert shown == [("=", "a", "b"), ("=", "b", "add(c, neg(k))"), ("=", "neg(x)", "y")]


def test_a_star_of_plain_text_ends_what_a_slash_divides_by() -> None:
    (graph,) = read_expression("a/b*c", SYMBOLS, plain=True)
    assert written(graph) == "mul(div(a, b), c)"
    assert len(read_expression("a/b c", SYMBOLS, plain=True)) == 2
    assert len(read_expression(r"a/b \cdot c", SYMBOLS)) == 2


def test_a_bar_behind_a_quotient_has_two_readings() -> None:
    readings = read_formula(r"c = a/b|_{x=0}", SYMBOLS).readings
    assert [written(reading.relations[0].right) for reading in readings] == [
        "div(a, at(b, x, 0))",
        "at(div(a, b), x, 0)",
    ]
    assert [reading.text for reading in readings] == [
        "the bar of column 8 applies to b",
        "the bar of column 8 applies to a/b",
    ]


@pytest.mark.parametrize(
    "text",
    [
        r"\lim_{x \to \infty} f(x) = 0.50",
        r"f(x) \to 0.50 \quad (x \to \infty)",
        r"f(x) \rightarrow 0.50 \text{ as } x \to \infty",
    ],
)
def test_limit(text: str) -> None:
    (reading,) = read_formula(text, SYMBOLS).readings
    (relation,) = reading.relations
    assert (relation.operator, written(relation.left), written(relation.right)) == (
        "->",
        "f(x)",
        "1/2",
    )
    assert relation.right_decimals == 2
    (condition,) = reading.conditions
    assert condition == Relation("->", condition.left, INFINITY)


@pytest.mark.parametrize("side", ["0+", "0^+", "0^{+}", "+0"])
def test_one_sided(side: str) -> None:
    (reading,) = read_formula(rf"f(x) \to a \quad (x \to {side})", SYMBOLS).readings
    shown = [(c.operator, written(c.left), written(c.right)) for c in reading.conditions]
    assert shown == [("->", "x", "0"), (">", "x", "0")]


@pytest.mark.parametrize(
    ("text", "decimals"),
    [
        *(("7", 0), ("0.50", 2), ("-0.5", 1), (r"3.0 \times 10^{-4}", 5), (r"2 \times 10^3", -3)),
        *(("a", None), ("0.5 a", None), ("1/2", None)),
    ],
)
def test_decimals_shown(text: str, decimals: int | None) -> None:
    (reading,) = read_formula(rf"a \approx {text}", SYMBOLS).readings
    assert reading.relations[0].right_decimals == decimals
    assert reading.relations[0].left_decimals is None


@pytest.mark.parametrize(
    ("branch", "wanted"), [("upper", "add(a, neg(b))"), ("lower", "add(neg(a), b)")]
)
def test_branch(branch: str, wanted: str) -> None:
    (reading,) = read_formula(r"c = \pm a \mp b", SYMBOLS, branch).readings
    assert written(reading.relations[0].right) == wanted


def test_whole_numbers_listed() -> None:
    (reading,) = read_formula(r"a = b \quad (i = 1, 2, \ldots, n)", SYMBOLS).readings
    shown = [(c.operator, written(c.left), written(c.right)) for c in reading.conditions]
    assert shown == [("<=", "1", "i"), ("<=", "i", "n")]
