"""Factors of one row and column: their own transposes, they commute; nothing else does."""

from __future__ import annotations

import pytest
from matrix_claims import SYMBOLS, judged_matrices

from gainproof.verify.judge.matrices.certificate import rejected

NUMBERS = """
'c' = { shape = ["1", "1"], meaning = "a matrix of one row and column" }
'd' = { shape = ["1", "1"], meaning = "another" }
'K' = { shape = ["n", "n"], meaning = "any" }
"""
TRUE = [
    ("(x, a) = (a, x)", "identity"),
    ("x^T B a = a^T B^T x", "identity"),
    ("x (a^T x) = x (x^T a)", "identity"),
    ("(x^T a)(x^T x) = (x^T x)(x^T a)", "identity"),
    ("x c a^T = x c^T a^T", "identity"),
    ("c d = d c", "identity"),
    ("x c d a^T B = x d^T c a^T B", "identity"),
    ("c^T = c", "identity"),
    (r"x c c x^T \geq 0", "inequality"),
    ("E[(x^T A^T v)(a^T A^T v)] = x^T A^T R A a", "covariance"),
    ("E[(x^T A^T v)(x^T x)(v^T A a)] = (x^T A^T R A a)(x^T x)", "covariance"),
    ("E[A^T v (x^T A^T v)] = A^T R A x", "covariance"),
    ("E[(x^T A^T v)(a^T A^T w)] = 0", "covariance"),
]
FALSE = [
    ("B K = K B", "identity"),
    ("x a^T = a x^T", "identity"),
    ("B^T = B", "identity"),
    ("x c a^T = a c x^T", "identity"),
    ("x^T B a = x^T B^T a", "identity"),
    ("x^T B K a = x^T K B a", "identity"),
    ("(x^T B a)(x^T K a) = x^T B K a", "identity"),
    (r"x c x^T \geq 0", "inequality"),
    ("E[(x^T A^T v)(a^T A^T v)] = x^T A^T A a", "covariance"),
    ("E[(x^T A^T v)(a^T A^T w)] = x^T A^T R A a", "covariance"),
]


@pytest.mark.parametrize(("latex", "kind"), TRUE)
def test_numbers_are_their_transposes_and_commute(latex: str, kind: str) -> None:
    found = judged_matrices(latex, kind, symbols=SYMBOLS + NUMBERS)
    assert found.verdict == "proved", found.reason
    assert all(rejected(part) is None for part in found.certificate["words"])


@pytest.mark.parametrize(("latex", "kind"), FALSE)
def test_larger_matrices_do_not(latex: str, kind: str) -> None:
    found = judged_matrices(latex, kind, symbols=SYMBOLS + NUMBERS)
    assert found.verdict in ("refuted", "conditional"), found.reason


def test_a_product_of_one_row_and_column_is_no_number_before_larger_ones() -> None:
    latex = "B (x^T x) = (x^T x) B"
    assert judged_matrices(latex, symbols=SYMBOLS + NUMBERS).verdict == "undecided"
