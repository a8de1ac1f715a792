"""Formulas and statements of pages: read as they are written, and taken for what they say."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import latex_of
from gainproof.derive.pages.evaluation import MAXIMUM_SIZE, Definition, Meanings
from gainproof.derive.pages.formula import FormulaError, nearest, read_formula
from gainproof.derive.pages.statement import FORMS, read_statement, relation_of

A, B, C, X = (real(name) for name in "abcx")
MATRIX = sp.ImmutableDenseMatrix([[A, B], [0, 1]])
MEANINGS = Meanings(
    symbols={name: real(name) for name in ("a", "b", "c", "x", "a'")},
    defined={"M": MATRIX, "k": sp.ImmutableDenseMatrix([A, B])},
    slots={"own": A + 1},
    models={"model": {"name": "a model"}},
)


FORMULAS = {
    "2 a^2/(1 + a)": 2 * A**2 / (1 + A),
    "a - b - c": A - B - C,
    "a - (b - c)": A - B + C,
    "-a^2": -(A**2),
    "(-a)^2": A**2,
    "a b/c": A * B / C,
    "a/(b c)": A / (B * C),
    "(a/b) c": A * C / B,
    "(a/b)/c": A / (B * C),
    "3/2 + a": sp.Rational(3, 2) + A,
    "a (b + c)": A * B + A * C,
    "sqrt(5) a": sp.sqrt(5) * A,
    "derivative(a, x, 2)": sp.Derivative(A, (X, 2)),
    "at(a x, x, 3)": sp.Subs(A * X, X, 3),
    "{own} b": (A + 1) * B,
    "a' a": real("a'") * A,
}


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_means_what_it_says(text: str) -> None:
    read = read_formula(text, MEANINGS.primed)
    assert str(read) == text
    assert sp.expand(MEANINGS.value(read) - FORMULAS[text]) == 0


ORDERS = {
    "as_written(b + a)": (B, A),
    "as_written((b + a) (a - 1))": (B + A, A - 1),
    "as_written(x ((1 + a)/2))": (X, (1 + A) / 2),
    "as_written(sum_of_both^2 x + 1)": ((A + 1) ** 2 * X, sp.Integer(1)),
}


@pytest.mark.parametrize("text", ORDERS)
def test_what_is_to_stay_as_written_keeps_its_order(text: str) -> None:
    meanings = MEANINGS.define("sum_of_both", Definition((), read_formula("a + 1")))
    value = meanings.value(read_formula(text))
    wanted = ORDERS[text]
    assert [sp.expand(part - other) for part, other in zip(value.args, wanted, strict=True)] == [
        0,
        0,
    ]
    assert isinstance(value, sp.Add if " + " in text.split("(")[1] else sp.Mul)


def test_a_slot_may_name_a_quantity() -> None:
    said = read_statement("a -> b as {running} -> 0")
    slots = {"running": "x"}
    relation = relation_of(said, replace(MEANINGS, slots=slots))
    assert relation.parts["variable"] == "x"
    with pytest.raises(FormulaError, match="'y' is no quantity of this page"):
        relation_of(said, replace(MEANINGS, slots={"running": "y"}))


def test_matrices_are_left_as_written_and_definitions_are_multiplied_out() -> None:
    square = read_formula("M M' + k k'", MEANINGS.primed)
    value = MEANINGS.value(square)
    assert [part.args for part in value.args] == [
        (MATRIX, MATRIX.T),
        (sp.ImmutableDenseMatrix([A, B]), sp.ImmutableDenseMatrix([[A, B]])),
    ]
    less = MEANINGS.value(read_formula("M - (M' + k k')", MEANINGS.primed))
    assert less.args[1].args[0] == -1
    assert [len(part.args) for part in less.args[1].args[1].args] == [3, 2]
    named = MEANINGS.define("N", Definition((), square)).defined["N"]
    assert named == sp.ImmutableDenseMatrix([[2 * A**2 + B**2, A * B + B], [A * B + B, 1 + B**2]])


def test_a_function_knows_what_is_above_it_and_takes_its_arguments_only() -> None:
    first = MEANINGS.define("f", Definition(("a",), read_formula("a x + b")))
    second = first.define("g", Definition(("x",), read_formula("f(x) + f(2)")))
    assert sp.expand(second.value(read_formula("g(c)"))) == sp.expand(C * X + B + 2 * X + B)
    with pytest.raises(FormulaError, match="'h' is no function"):
        MEANINGS.define("h", Definition(("a",), read_formula("h(a) + 1")))


def test_rows_and_columns_are_where_they_are_written() -> None:
    assert MEANINGS.value(read_formula("[a, b, c; 1, 2, x]")) == sp.Matrix([[A, B, C], [1, 2, X]])


STATEMENTS = {
    "a = b": ("equal", {"left": A, "right": B, "free": ()}),
    "a = b for any a, c": ("equal", {"left": A, "right": B, "free": ("a", "c")}),
    "a > b": ("positive", {"expression": A - B}),
    "a > 0": ("positive", {"expression": A}),
    "-a has the sign of b - c": ("same_sign", {"left": -A, "right": B - C}),
    "a b grows with x": (
        "monotone",
        {"expression": A * B, "variable": "x", "trend": "increasing"},
    ),
    "a falls with x": ("monotone", {"expression": A, "variable": "x", "trend": "decreasing"}),
    "a grows from 0 to infinity with x": (
        "increasing_onto",
        {"expression": A, "variable": "x", "from": 0, "to": "infinity"},
    ),
    "a -> 2 b as x -> infinity": (
        "limit",
        {"expression": A, "variable": "x", "point": "infinity", "value": 2 * B},
    ),
    "a -> infinity as x -> 0": (
        "limit",
        {"expression": A, "variable": "x", "point": "0", "value": "infinity"},
    ),
    "sum of a x^2 over x from 0 to b is c": (
        "sum",
        {"index": "x", "start": "0", "upper": "b", "summand": A * X**2, "closed": C},
    ),
    "a^2 stands for b c": ("definition", {"left": A**2, "right": B * C}),
    "gain [a, b] is stable in model": (
        "stable",
        {"model": {"name": "a model"}, "gain": ["a", "b"]},
    ),
    "gain [a; b] is steady in model with covariances [a, b; b, c] and [x] and index x": (
        "riccati",
        {
            "model": {"name": "a model"},
            "predicted": [["a", "b"], ["b", "c"]],
            "updated": [["x"]],
            "gain": ["a", "b"],
            "index": "x",
        },
    ),
    "[a, b; b, c] is positive definite": (
        "positive_definite",
        {"matrix": [["a", "b"], ["b", "c"]]},
    ),
}


@pytest.mark.parametrize("text", STATEMENTS)
def test_a_statement_is_the_relation_that_it_says(text: str) -> None:
    read = read_statement(text)
    assert str(read) == text
    relation = relation_of(read, MEANINGS)
    assert (relation.kind, relation.parts) == STATEMENTS[text]


OF_MATRICES = [
    "M >= S^-1",
    "M is invertible if M is positive semidefinite, M' N = 0",
    "where M",
    "M is symmetric",
    "M has full column rank",
    "M is positive semidefinite",
]


@pytest.mark.parametrize("text", OF_MATRICES)
def test_a_statement_on_matrices_of_every_size_is_printed_back(text: str) -> None:
    read = read_statement(text)
    assert str(read) == text
    with pytest.raises(FormulaError, match="only matrices of every size"):
        relation_of(read, MEANINGS)


def test_every_form_of_statement_is_tried() -> None:
    found = {read_statement(text).form for text in (*STATEMENTS, *OF_MATRICES)}
    assert found == set(FORMS)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a" * 5000, "at most 4000 characters"),
        ("(" * 41 + "a" + ")" * 41, "nested more than 40 deep"),
        ("a^99", "a whole number from 2 to 16"),
        ("1" * 41, "at most 40 digits"),
        ("a + __import__", "'_' is no part of a formula"),
        ("a; b", "wanted the end after 'a', came ';'"),
        ("a ** 2", "'*' is no part of a formula"),
        ("a) + b", "')' without '(' after 'a'"),
        ("f(a b)) + c", "')' without '(' after"),
        ("(a + b", "wanted ')' after 'a + b', came the end of the line"),
        ("(a]", "']' without '[' after"),
        ("a}", "'}' without '{' after 'a'"),
    ],
)
def test_hostile_formulas_end_with_an_error(text: str, said: str) -> None:
    with pytest.raises(FormulaError) as caught:
        read_formula(text)
    assert said in str(caught.value)
    assert len(str(caught.value)) < 5000


@pytest.mark.parametrize(
    ("name", "known", "found"),
    [
        ("Beta", ["eta", "beta", "theta"], ["beta"]),
        ("lambda", ["Lambda", "alpha"], ["Lambda"]),
        ("P_21", ["P_12", "P_11", "Q_21"], ["Q_21"]),
        ("sigma", ["zeta"], []),
    ],
)
def test_the_nearest_name_is_the_same_word_first(
    name: str, known: list[str], found: list[str]
) -> None:
    assert nearest(name, known) == found


@pytest.mark.parametrize("step", ["p{0} p{0} + 1", "(2 p{0})^16", "[p{0}, p{0}; p{0}, p{0}]"])
def test_definitions_that_grow_without_end_are_stopped(step: str) -> None:
    """Each is written out of the one above it, which would be of astronomical size."""

    def growing() -> None:
        meanings = MEANINGS.define("p0", Definition((), read_formula("a + b")))
        for number in range(60):
            formula = read_formula(step.format(number))
            meanings = meanings.define(f"p{number + 1}", Definition((), formula))

    with pytest.raises(FormulaError, match=f"more than {MAXIMUM_SIZE} parts|no value"):
        growing()


LATEX = {
    "e": "e",
    "Lambda": r"\Lambda",
    "Lambda_0": r"\Lambda_0",
    "alpha_0'": r"\alpha_0'",
    "R_theta": r"R_\theta",
    "c_v": "c_v",
    "P_11": "P_{11}",
    "x_+": "x_{+}",
    "V_l|d": "V_{l|d}",
    "I_m+n": "I_{m+n}",
    "1": "1",
    "along": "",
    "less_sine": "",
}


def test_names_are_printed_as_the_field_prints_them() -> None:
    assert {name: latex_of(name) for name in LATEX} == LATEX
