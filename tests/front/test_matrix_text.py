"""Statements on matrices of every size, as people read them: with what they take for granted."""

from __future__ import annotations

import functools
from typing import Any

from word_certificates import equation, graph, known

from gainproof.formulas.formula_latex import formula_latex
from gainproof.formulas.formula_text import formula_text
from gainproof.formulas.latex_display import aligned
from gainproof.formulas.relation_text import Writer, relation_lines

NAMES = {"S": "S", "K1": "K1"}
TEXT = Writer(NAMES, formula_text)
LATEX = Writer(
    {"K1": "K_1"},
    functools.partial(formula_latex),
    words=lambda text: rf"\text{{{text}}}",
    at_least=r"\geq",
)
JOSEPH = ("mul", ("add", "I", ("neg", ("mul", "K1", "H"))), "P", ("transpose", "H"))


def claim(**fields: Any) -> dict[str, Any]:
    return {"given": [], **fields}


def test_products_keep_their_order_and_their_parentheses() -> None:
    found = relation_lines("matrix_equal", claim(left=graph(JOSEPH), right=graph("0")), TEXT)
    assert found == ["(I - K1 H) P H' = 0"]
    turned = ("transpose", ("inverse", "S"))
    both = ("mul", ("inverse", "S"), ("transpose", ("mul", "A", "B")))
    found = relation_lines("matrix_equal", claim(left=graph(turned), right=graph(both)), TEXT)
    assert found == ["(S^-1)' = S^-1 (A B)'"]


def test_what_is_taken_for_granted_stands_below() -> None:
    given = [
        known("semidefinite", "P"),
        known("definite", "S"),
        known("symmetric", "Q"),
        known("invertible", "K1"),
        known("full_column_rank", "A"),
        equation(("mul", "K1", "S"), ("mul", "S", "K1")),
    ]
    sides = {"larger": graph("P"), "smaller": graph("0")}
    found = relation_lines("matrix_order", claim(**sides, relation=">=", given=given), TEXT)
    assert found == [
        "P >= 0",
        "    if P >= 0, S > 0, Q = Q', K1 is invertible, A has full column rank, K1 S = S K1",
    ]
    found = relation_lines("matrix_order", claim(**sides, relation=">", given=given[1:2]), TEXT)
    assert found == ["P > 0", "    if S > 0"]
    found = relation_lines("matrix_invertible", claim(matrix="S", given=given[1:2]), TEXT)
    assert found == ["S is invertible", "    if S > 0"]


def test_traces() -> None:
    sides = {"left": graph(("mul", "A", "B")), "right": graph(("mul", "B", "A"))}
    assert relation_lines("matrix_trace", claim(**sides), TEXT) == ["tr (A B) = tr (B A)"]


def test_latex_sets_conditions_in() -> None:
    given = [known("semidefinite", "P"), equation("K1", "S")]
    sides = {"left": graph(("transpose", "K1")), "right": graph(("inverse", "S"))}
    lines = relation_lines("matrix_equal", claim(**sides, given=given), LATEX)
    assert lines == ["{K_1}' = {S}^{-1}", r"\text{    if }P \geq 0, K_1 = S"]
    assert aligned(lines).splitlines() == [
        r"{K_1}' &= {S}^{-1}\\",
        r"&\quad \text{    if }P \geq 0, K_1 = S",
    ]
