"""Matrices are compared entry by entry, products in the order printed, shapes checked."""

from __future__ import annotations

import pytest
from small_claims import check, judged

SHAPED = "{ unit = '1', shape = [2, 2], meaning = 'a matrix' }"
SYMBOLS = {
    "A": SHAPED,
    "B": SHAPED,
    "C": "{ unit = '1', shape = [1, 2], meaning = 'a row' }",
    "F": r"{ definition = '\begin{pmatrix} 1 & t \\ 0 & 1 \end{pmatrix}', "
    "shape = [2, 2], meaning = 'transition' }",
    "I": r"{ definition = '\begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}', meaning = 'unit' }",
}
FULL = r"\begin{pmatrix} a & b \\ c & u \end{pmatrix}"
DOUBLED = r"\begin{pmatrix} 1 & 0 \\ 0 & 2 \end{pmatrix}"
TRUE = [
    FULL + DOUBLED + r"= \begin{pmatrix} a & 2b \\ c & 2u \end{pmatrix}",
    FULL + r"^{-1} = \frac{1}{a u - b c} \begin{pmatrix} u & -b \\ -c & a \end{pmatrix}",
    r"\begin{pmatrix} a & b \end{pmatrix} \begin{pmatrix} a \\ b \end{pmatrix} = a^2 + b^2",
    r"A A^{-1} = I",
    r"(A B)^T = B^T A^T",
    r"(A B)^{-1} = B^{-1} A^{-1}",
    r"A \otimes x = x A",
    r"F^3 = \begin{pmatrix} 1 & 3 t \\ 0 & 1 \end{pmatrix}",
    r"F F^{-1} = I",
    r"A - A = 0",
    r"\det(A B) = \det(A) \det(B)",
    r"\begin{pmatrix} A \\ C \end{pmatrix} I = \begin{pmatrix} A \\ C \end{pmatrix}",
    r"C A C^T = C A^T C^T",
    r"\ln \det F^3 = 0",
    r"\ln \det \begin{pmatrix} a^2 & b \\ 0 & 1 \end{pmatrix} = 2 \ln \left| a \right|",
    r"\ln \lvert A A^T \rvert = 2 \ln \left| \det A \right|",
    r"\left| A B \right| = \left| A \right| \left| B \right|",
    r"\left\| \begin{pmatrix} a \\ b \end{pmatrix} \right\|^2 = a^2 + b^2",
    r"\| C A \|^2 = C A A^T C^T",
    r"\lVert C \rVert = \left| C \right|",
    r"\| a \| = \left| a \right|",
    r"\frac{d}{d a} \| \begin{pmatrix} a & 1 \end{pmatrix} \| = \frac{a}{\sqrt{a^2 + 1}}",
]  # fmt: skip
FALSE = [
    DOUBLED + FULL + r"= \begin{pmatrix} a & 2b \\ c & 2u \end{pmatrix}",
    FULL + r"^{-1} = \frac{1}{a u - b c} \begin{pmatrix} u & -c \\ -b & a \end{pmatrix}",
    r"A B = B A",
    r"(A B)^T = A^T B^T",
    r"F F^T = F^T F",
    r"\det(A + B) = \det(A) + \det(B)",
    r"A \otimes B = B \otimes A",
    r"\ln \det A^2 = 2 \ln \det A + 1",
    r"\ln \det \begin{pmatrix} a & b \\ 0 & c \end{pmatrix} = \ln a - \ln c",
    r"\left| A + B \right| = \left| A \right| + \left| B \right|",
    r"\| C A \| = \| C \| \left| A \right|",
    r"\left\| \begin{pmatrix} a \\ b \end{pmatrix} \right\| = a + b",
]  # fmt: skip
WITHOUT_MEANING = [
    (r"A + C = 0", "a sum of a 2 x 2 matrix and a 1 x 2 matrix"),
    (r"A C = 0", "a product of a 2 x 2 matrix and a 1 x 2 matrix"),
    (r"A = C", "a 2 x 2 matrix on the left, a 1 x 2 matrix on the right"),
    (r"A + 1 = 0", "a sum of a 2 x 2 matrix and a number"),
    (r"\| A \| = 1", "the norm of a 2 x 2 matrix: which of its norms is not said"),
    (r"\ln A = 1", "a 2 x 2 matrix stands where a number is wanted"),
    (r"A = x", "a 2 x 2 matrix on the left, a number on the right"),
]


@pytest.mark.alike
@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "refuted")


@pytest.mark.parametrize(("latex", "why"), WITHOUT_MEANING)
def test_shapes_that_do_not_fit_are_named(latex: str, why: str) -> None:
    found = judged("identity", latex, SYMBOLS)
    check(found, "undecided")
    assert why in found.reason


def test_orders_between_matrices_are_not_taken_entry_by_entry() -> None:
    check(judged("inequality", "A > 0", SYMBOLS), "undecided")
