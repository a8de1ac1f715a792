"""Random formulas mean what was written, and can be printed and read again.

The value of a formula is computed beside its text, not from what the reader made of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.judge.reader.latex_printer import graph_to_latex, reading_to_latex
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_expression, read_formula


@dataclass(frozen=True)
class Declared:
    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False


POINT = {
    r"\alpha": Fraction(3, 7),
    r"\beta_k": Fraction(-5, 3),
    "k": Fraction(4),
    "T": Fraction(11, 2),
    "By": Fraction(-2, 9),
    "x_{sk-1}": Fraction(13, 5),
    r"\dot{x}_{ok}": Fraction(-7, 4),
    "x'": Fraction(1, 6),
}
SYMBOLS: Mapping[str, Declared] = {canonical_token(token): Declared() for token in POINT} | {
    "S": Declared(("k", "T")),
}
SPELLINGS = {
    r"\alpha": (r"\alpha", r"{\alpha}"),
    r"\beta_k": (r"\beta_k", r"\beta_{k}", r"\beta _ k"),
    "k": ("k", "{k}"),
    "T": ("T",),
    "By": ("By",),
    "x_{sk-1}": ("x_{sk-1}", "x_{ s k - 1 }"),
    r"\dot{x}_{ok}": (r"\dot{x}_{ok}", r"\dot x_{ok}", r"\dot{{x}}_{o k}"),
    "x'": ("x'",),
}
BRACKETS = (("(", ")"), ("[", "]"), (r"\{", r"\}"), (r"\left(", r"\right)"), (r"\Bigl[", r"\Bigr]"))


@dataclass(frozen=True)
class Text:
    """A text with its value at POINT (None where it has none), how tightly it binds (0 sum, 1
    product, 2 power, 3 atom) and whether it begins with a digit.
    """

    text: str
    value: Fraction | None
    level: int
    digit: bool = False


def _combine(
    operation: Callable[[Fraction, Fraction], Fraction], a: Fraction | None, b: Fraction | None
) -> Fraction | None:
    if a is None or b is None:
        return None
    try:
        return operation(a, b)
    except ZeroDivisionError:
        return None


@st.composite
def _symbol(draw: st.DrawFn) -> Text:
    name = draw(st.sampled_from(sorted(POINT)))
    return Text(draw(st.sampled_from(SPELLINGS[name])), POINT[name], 3)


@st.composite
def _number(draw: st.DrawFn) -> Text:
    text = draw(st.sampled_from(("0", "1", "2", "17", "0.5", "2.75", "1.250")))
    return Text(text, Fraction(text), 3, digit=True)


def _bracketed(draw: st.DrawFn, inner: Text, level: int) -> Text:
    if inner.level >= level and not (level == 3 and inner.level < 3):
        return inner
    opening, closing = draw(st.sampled_from(BRACKETS))
    return Text(f"{opening} {inner.text} {closing}", inner.value, 3)


@st.composite
def _larger(draw: st.DrawFn, parts: st.SearchStrategy[Text]) -> Text:
    kind = draw(
        st.sampled_from(
            ("add", "subtract", "multiply", "fraction", "slash", "power", "root", "neg")
        )
    )
    a, b = draw(parts), draw(parts)
    if kind in ("add", "subtract"):
        sign = "+" if kind == "add" else "-"
        right = _bracketed(draw, b, 1)
        value = _combine(
            Fraction.__add__ if kind == "add" else Fraction.__sub__, a.value, right.value
        )
        return Text(f"{a.text} {sign} {right.text}", value, 0, a.digit)
    if kind == "neg":
        inner = _bracketed(draw, a, 1)
        value = None if inner.value is None else -inner.value
        return Text(f"({'-' + inner.text})", value, 3)
    if kind == "multiply":
        left, right = _bracketed(draw, a, 2), _bracketed(draw, b, 2)
        needs_dot = right.digit or "frac{" in right.text[:6]
        joint = (
            r" \cdot "
            if needs_dot
            else draw(st.sampled_from((" ", r" \cdot ", r" \times ", r"\,")))
        )
        value = _combine(Fraction.__mul__, left.value, right.value)
        return Text(f"{left.text}{joint}{right.text}", value, 1, left.digit)
    if kind == "fraction":
        value = _combine(Fraction.__truediv__, a.value, b.value)
        name = draw(st.sampled_from((r"\frac", r"\tfrac", r"\dfrac")))
        return Text(f"{name}{{{a.text}}}{{{b.text}}}", value, 2)
    if kind == "slash":
        left, right = _bracketed(draw, a, 2), _bracketed(draw, b, 2)
        value = _combine(Fraction.__truediv__, left.value, right.value)
        return Text(f"({left.text} / {right.text})", value, 3)
    base = _bracketed(draw, a, 3)
    if kind == "root":
        # an even power under the root, so that the value stays rational
        square = Text(f"({base.text})^2", base.value, 2)
        value = None if base.value is None else abs(base.value)
        return Text(rf"\sqrt{{{square.text}}}", value, 2)
    exponent = draw(st.integers(-3, 4))
    shown = str(exponent) if exponent >= 0 and draw(st.booleans()) else f"{{{exponent}}}"
    value = _combine(lambda x, y: x ** int(y), base.value, Fraction(exponent))
    return Text(f"{base.text}^{shown}", value, 2, base.digit)


def formula_texts() -> st.SearchStrategy[Text]:
    """Expressions over SYMBOLS."""
    return st.recursive(st.one_of(_symbol(), _number()), _larger, max_leaves=12)


def value_of(graph: Mapping[str, Any]) -> Fraction | None:
    """The value of a graph at POINT, by its nodes in order; square roots must come out rational."""
    done: list[Fraction | None] = []
    for kind, *rest in graph["nodes"]:
        done.append(_node_value(kind, rest, done))
    value: int = graph["outputs"]["value"]
    return done[value]


def _node_value(kind: str, rest: list[Any], done: list[Fraction | None]) -> Fraction | None:
    if kind == "number":
        return Fraction(rest[0])
    if kind == "symbol":
        return POINT[rest[0]]
    values = [done[i] for i in rest if isinstance(i, int)]
    if any(value is None for value in values):
        return None
    numbers = [value for value in values if value is not None]
    try:
        match kind:
            case "neg":
                return -numbers[0]
            case "div":
                return numbers[0] / numbers[1]
            case "pow":
                power = Fraction(rest[1])
                if power == Fraction(1, 2):
                    return _root(numbers[0])
                return numbers[0] ** int(power)
            case "add":
                return sum(numbers, Fraction(0))
            case "mul":
                product = Fraction(1)
                for number in numbers:
                    product *= number
                return product
    except ZeroDivisionError:
        return None
    raise AssertionError(kind)


def _root(square: Fraction) -> Fraction:
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    assert root * root == square
    return root


COMMON = settings(
    max_examples=samples(60), deadline=None, suppress_health_check=[HealthCheck.too_slow]
)


@COMMON
@given(formula_texts())
def test_value_is_that_of_the_text(written: Text) -> None:
    (graph,) = read_expression(written.text, SYMBOLS)
    assert value_of(graph) == written.value


@COMMON
@given(formula_texts())
def test_printed_and_read_again(written: Text) -> None:
    (graph,) = read_expression(written.text, SYMBOLS)
    assert read_expression(graph_to_latex(graph), SYMBOLS) == (graph,)


@st.composite
def _statements(draw: st.DrawFn) -> str:
    sides = st.one_of(
        formula_texts().map(lambda written: written.text),
        st.sampled_from(
            (
                r"1/k T",
                r"\sum_{k=0}^{T+1} k T",
                r"\frac{\partial}{\partial k} S(k, T) + 1",
                r"\frac{\partial k^2 T}{\partial T}",
                r"\left| k - T \right|^3",
                r"S(\alpha, S(1, T)) k",
            )
        ),
    )
    operators = st.sampled_from(("=", "<", r"\leq", r"\ge", r"\ne", r"\approx", r"\to"))
    chains = st.builds(
        lambda first, rest: first + "".join(f" {operator} {side}" for operator, side in rest),
        sides,
        st.lists(st.tuples(operators, sides), min_size=1, max_size=3),
    )
    joints = st.sampled_from((", ", r" \text{and} ", r" and ", r" \\ "))
    parts = draw(st.lists(chains, min_size=1, max_size=3))
    text = parts[0] + "".join(draw(joints) + part for part in parts[1:])
    ending = draw(
        st.sampled_from(("none", "condition", "limit", r"\Leftrightarrow", r"\Rightarrow"))
    )
    if ending == "condition":
        return rf"{text} \quad ({draw(chains)}) \left( {draw(chains)} \right)"
    if ending == "limit":
        return rf"{text} \quad (k \to -\infty)"
    return text if ending == "none" else f"{text} {ending} {draw(chains)}"


def _few_slashes(text: str) -> bool:
    """Each slash of this piece doubles the readings, whose number is limited."""
    return text.count("1/k T") <= 6


@settings(COMMON, max_examples=samples(20))
@given(_statements().filter(_few_slashes))
def test_statements_printed_and_read_again(text: str) -> None:
    for reading in read_formula(text, SYMBOLS).readings[:8]:
        again = read_formula(reading_to_latex(reading), SYMBOLS).readings
        assert len(again) == 1
        assert again[0].relations == reading.relations
        assert again[0].conditions == reading.conditions
        assert again[0].connective == reading.connective
