"""True statements that any reader takes for granted, and false ones beside them."""

from __future__ import annotations

import pytest
from matrix_claims import SYMBOLS, judged_matrices
from one_of_each import further

from gainproof.verify.judge.matrices.certificate import rejected

RECTANGLES = """
'K' = { shape = ["n", "n"], meaning = "any" }
'M' = { shape = ["n", "m"], meaning = "any" }
"""
TRUE = [
    ("C B = I_n", "identity", "given = ['B C = I_n']"),
    ("C = B^{-1}", "identity", "given = ['B C = I_n']"),
    further("C K B = I_n", "identity", "given = ['K B C = I_n']"),
    (r"\det(B) \neq 0 \Leftrightarrow \det(B^T) \neq 0", "equivalence", ""),
    (r"\det(B C) \neq 0 \Leftrightarrow \det(C B) \neq 0", "equivalence", ""),
    further(r"\det(B) \neq 0 \Leftrightarrow \det(B^T B) \neq 0", "equivalence", ""),
    further(r"\det(B) \neq 0 \Leftrightarrow B^T B > 0", "equivalence", ""),
    (r"Q^{-1} \geq (Q + S)^{-1}", "inequality", ""),
    further(r"(I_n + S)^{-1} \leq I_n", "inequality", ""),
    further(r"Q^{-1} > (Q + V)^{-1}", "inequality", ""),
    further(r"(I_n + A^T A)^{-1} \leq I_n", "inequality", ""),
    further(r"2 I_n \geq 2 Q^{-1}", "inequality", r"given = ['Q \geq I_n']"),
    (r"2 I_n \geq Q^{-1}", "inequality", r"given = ['4 Q \geq 2 I_n']"),
    further(r"3 V^{-1} \geq 2 Q^{-1}", "inequality", r"given = ['3 Q \geq 2 V']"),
    (r"\frac{1}{2} Q > \frac{1}{2} V", "inequality", "given = ['Q > V']"),
    (r"Q + Q^{-1} \geq 2 I_n", "inequality", ""),
    (r"Q Q \geq 2 Q - I_n", "inequality", ""),
]
FALSE = [
    ("M A = I_n", "identity", "given = ['A M = I_m']"),
    ("C B = 2 I_n", "identity", "given = ['B C = I_n']"),
    ("K C B = I_n", "identity", "given = ['B C = I_n']"),
    (r"\det(A M) \neq 0 \Leftrightarrow \det(M A) \neq 0", "equivalence", ""),
    (r"\det(B + C) \neq 0 \Leftrightarrow \det(B) \neq 0", "equivalence", ""),
    (r"Q^{-1} > (Q + S)^{-1}", "inequality", ""),
    (r"(I_n + S)^{-1} < I_n", "inequality", ""),
    (r"(Q + S)^{-1} \geq Q^{-1}", "inequality", ""),
    (r"3 I_n \geq 4 Q^{-1}", "inequality", r"given = ['Q \geq I_n']"),
    (r"I_n > 2 Q^{-1}", "inequality", r"given = ['Q \geq 2 I_n']"),
    (r"Q + Q^{-1} \geq 3 I_n", "inequality", ""),
    (r"Q Q \geq 3 Q - 2 I_n", "inequality", ""),
    (r"Q^{-1} \geq (Q + X)^{-1}", "inequality", "invertible = ['Q + X']"),
]


@pytest.mark.parametrize(("latex", "kind", "more"), TRUE)
def test_what_is_plain_is_proved(latex: str, kind: str, more: str) -> None:
    found = judged_matrices(latex, kind, more, symbols=SYMBOLS + RECTANGLES)
    assert found.verdict == "proved", found.reason
    parts = found.certificate.get("words") or [
        part for inner in found.certificate.values() for part in inner["words"]
    ]
    assert all(rejected(part) is None for part in parts)


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "kind", "more"), FALSE)
def test_what_is_like_it_and_false_is_not(latex: str, kind: str, more: str) -> None:
    found = judged_matrices(latex, kind, more, symbols=SYMBOLS + RECTANGLES)
    assert found.verdict in ("refuted", "conditional"), found.reason


def test_sizes_may_be_zero() -> None:
    """A matrix without rows has no entry that differs; an instance has to be of another size."""
    found = judged_matrices("B = C", "identity")
    assert found.verdict == "refuted"
    assert found.witness is not None
    assert found.witness["left"] != found.witness["right"]
