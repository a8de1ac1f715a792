"""What follows from hypotheses though no sum of their multiples says it, and false ones beside it:
lemmas of books on linear algebra, each true, or with an instance that shows that it is not.
"""

from __future__ import annotations

import pytest
from matrix_claims import SYMBOLS, judged_matrices
from one_of_each import cases, further

from gainproof.verify.judge.matrices.certificate import rejected

LETTERS = (
    SYMBOLS
    + """
'M' = { shape = ["n", "n"], is = ["invertible"], meaning = "regular" }
'N' = { shape = ["n", "n"], is = ["invertible"], meaning = "regular" }
'T' = { shape = ["n", "n"], is = ["positive semidefinite"], meaning = "at least 0" }
"""
)
CANCELLED = [
    ("B = C", "B M = C M", "proved"),
    ("B = C", "M B = M C", "proved"),
    ("B = C", "N B M = N C M", "proved"),
    ("A B = O_{m,n}", "A B Q = O_{m,n}", "proved"),
    ("M = N", "M^{-1} = N^{-1}", "proved"),
    ("M N = N M", "M^{-1} N^{-1} = N^{-1} M^{-1}", "proved"),
    ("B M = I_n", "M B = I_n", "proved"),
    ("Q = 2 V", "Q M = 2 V M", "proved"),
    ("B = C", "B S = C S", "refuted"),
    ("B = C", "A B = A C", "refuted"),
    ("B = C", "S B M = S C M", "refuted"),
    ("B M = M B", "M^{-1} B = C M^{-1}", "refuted"),
]
DIVIDED = [
    ("B = C", "B + B Q = C + C Q", "proved"),
    ("B = C", "B (I_n + S) = C (I_n + S)", "proved"),
    ("x = a", "(S + Q) x = (S + Q) a", "proved"),
    ("B = C", "B + B Q = C + 2 C Q", "refuted"),
    ("B = C", "B (I_n - S) = C (I_n - S)", "refuted"),
    ("x = a", "(S + T) x = (S + T) a", "refuted"),
]
SQUARES = [
    ("A = O_{m,n}", "A^T A = O_{n,n}", "proved"),
    ("A = O_{m,n}", "A A^T = O_{m,m}", "proved"),
    ("A = O_{m,n}", "A Q A^T = O_{m,m}", "proved"),
    ("A B = A C", "A^T A B = A^T A C", "proved"),
    ("B = O_{n,n}", "B B^T + C C^T = O_{n,n}", "proved"),
    ("A x = 0", "x^T A^T R A x + x^T S x = 0", "proved"),
    ("S x = 0", "x^T A^T R A x + x^T S x = 0", "proved"),
    ("S x = 0", "x^T S x = 0", "proved"),
    ("x^T S = 0", "x^T S x = 0", "proved"),
    ("S T x = 0", "x^T T x = 0", "proved"),
    (r"B = O_{n,n}", r"B B^T \\leq O_{n,n}", "proved"),
    ("B = O_{n,n}", "B B = O_{n,n}", "conditional"),
    ("A = O_{m,n}", "A S A^T = O_{m,m}", "refuted"),
    ("B = O_{n,n}", "B B^T = C C^T", "refuted"),
    ("x = O_{n,1}", "x^T S x = 0", "refuted"),
    ("S x = 0", "x^T T x = 0", "refuted"),
    ("X x = 0", "x^T X x = 0", "conditional"),
]
ORDERS = [
    ("X > 0", "M^T X M = Q", "proved"),
    (r"X \\geq 0", "M^T X M = S", "proved"),
    further("X > 0", "M^T X M = Q + S", "proved"),
    further("X < Y", "M^T X M < M^T Y M", "proved"),
    (r"X \\leq Y", r"M^T X M \\leq M^T Y M", "proved"),
    ("X < Y", r"M^T X M \\leq M^T Y M", "refuted"),
    further(r"X \\leq Y", r"B^T X B \\leq B^T Y B", "refuted"),
    further("X > 0", "M^T X M = S", "refuted"),
    ("X > 0", "M^T X M = Q - S", "refuted"),
]


def _tables(*lists: list[tuple[str, str, str]]) -> list[tuple[str, str, str]]:
    return [one for some in lists for one in some]


EQUATIONS = _tables(CANCELLED, DIVIDED, SQUARES)
ONE_OF_EACH = _tables(CANCELLED[::2], DIVIDED[2:4], SQUARES[::2], SQUARES[11:])


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "given", "verdict"), cases(EQUATIONS, lambda case: case in ONE_OF_EACH)
)
def test_equations_that_follow_from_one(latex: str, given: str, verdict: str) -> None:
    found = judged_matrices(latex, "identity", f'given = ["{given}"]', symbols=LETTERS)
    assert found.verdict == verdict, found.reason
    if verdict == "proved":
        assert all(rejected(part) is None for part in found.certificate["words"])


@pytest.mark.parametrize(("latex", "given", "verdict"), ORDERS)
def test_orders_that_follow_from_an_equation_or_an_order(
    latex: str, given: str, verdict: str
) -> None:
    latex = latex.replace("\\\\", "\\")
    found = judged_matrices(latex, "inequality", f'given = ["{given}"]', symbols=LETTERS)
    assert found.verdict == verdict, found.reason


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        ("I_n + S Q", "proved"),
        ("I_n + Q S", "proved"),
        ("I_n + Q A^T R A", "proved"),
        ("I_n - Q (Q + V)^{-1}", "proved"),
        ("I_n - Q A^T (A Q A^T + R)^{-1} A", "proved"),
        ("I_n + B", "conditional"),
        ("I_n - Q (Q + S)^{-1}", "conditional"),
        ("I_n - S Q", "refuted"),
    ],
)
def test_what_is_not_symmetric_may_have_an_inverse(latex: str, verdict: str) -> None:
    found = judged_matrices(latex, "invertible", symbols=LETTERS)
    assert found.verdict == verdict, found.reason


@pytest.mark.parametrize(
    ("latex", "kind", "verdict"),
    [
        (
            "(I_n + Q A^T R^{-1} A)^{-1} Q A^T R^{-1} = Q A^T (A Q A^T + R)^{-1}",
            "identity",
            "proved",
        ),
        ("(I_n + S Q)^{-1} S = S (I_n + Q S)^{-1}", "identity", "proved"),
        further("(I_n + S Q)^{-1} S = (I_n + Q S)^{-1} S", "identity", "refuted"),
        (r"\det(I_n + B C) \neq 0 \Leftrightarrow \det(I_n + C B) \neq 0", "equivalence", "proved"),
        (
            r"\det(M + B C) \neq 0 \Leftrightarrow \det(I_n + C M^{-1} B) \neq 0",
            "equivalence",
            "proved",
        ),
        (
            r"\det(I_n + B C) \neq 0 \Leftrightarrow \det(I_n - C B) \neq 0",
            "equivalence",
            "refuted",
        ),
        ("0 < Q - Q A^T (A Q A^T + R)^{-1} A Q", "inequality", "proved"),
        (r"Q - Q A^T (A Q A^T + R)^{-1} A Q \leq Q", "inequality", "proved"),
        ("Q - Q A^T (A Q A^T + R)^{-1} A Q < Q", "inequality", "refuted"),
        (r"0 < (I_n - B) Q (I_n - B)^T + B V B^T", "inequality", "proved"),
        (r"0 < (I_n - B) Q (I_n - B)^T + B S B^T", "inequality", "refuted"),
    ],
)
def test_what_a_measurement_leaves(latex: str, kind: str, verdict: str) -> None:
    found = judged_matrices(latex, kind, symbols=LETTERS)
    assert found.verdict == verdict, found.reason


GAIN = (
    LETTERS
    + r"""
'K' = { definition = 'Q A^T (A Q A^T + R)^{-1}', meaning = "gain" }
'P' = { definition = '(I_n - K A) Q', meaning = "what a measurement leaves" }
'L' = { shape = ["n", "m"], meaning = "any gain" }
"""
)


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"P \leq (I_n - L A) Q (I_n - L A)^T + L R L^T", "proved"),
        (r"P < (I_n - L A) Q (I_n - L A)^T + L R L^T", "refuted"),
        further(r"Q^{-1} \leq P^{-1}", "proved"),
        (r"Q^{-1} < P^{-1}", "refuted"),
        ("A P A^T < R", "proved"),
        ("A P A^T < A Q A^T", "refuted"),
        ("2 A P A^T < R", "refuted"),
    ],
)
def test_no_gain_leaves_less_than_kalmans(latex: str, verdict: str) -> None:
    found = judged_matrices(latex, "inequality", symbols=GAIN)
    assert found.verdict == verdict, found.reason


@pytest.mark.parametrize(
    ("latex", "given", "verdict"),
    [
        (r"(A^T R^{-1} A)^{-1} \leq L R L^T", "L A = I_n", "proved"),
        (r"(A^T R^{-1} A)^{-1} \leq L R L^T", "2 L A = I_n", "refuted"),
        further(
            r"\frac{1}{3} Q^{-1} + \frac{2}{3} V^{-1} \geq (\frac{1}{3} Q + \frac{2}{3} V)^{-1}",
            "",
            "proved",
        ),
        (
            r"\frac{1}{3} Q^{-1} + \frac{1}{3} V^{-1} \geq (\frac{1}{3} Q + \frac{2}{3} V)^{-1}",
            "",
            "refuted",
        ),
        further(r"4 (Q^{-1} + V^{-1})^{-1} \leq Q + V", "", "proved"),
        (r"5 (Q^{-1} + V^{-1})^{-1} \leq Q + V", "", "refuted"),
        (r"X Y + Y X \leq X Q X + Y Q^{-1} Y", "", "proved"),
        further(r"X Y + Y X \leq X Q X + Y V^{-1} Y", "", "refuted"),
        (r"A^T A \leq I_n", r"A A^T \leq I_m", "proved"),
        further(r"A^T A < I_n", r"A A^T < I_m", "proved"),
        further(r"A^T A < I_n", r"A A^T \leq I_m", "refuted"),
        (r"x x^T \leq Q", r"x^T Q^{-1} x \leq 1", "proved"),
        further(r"x x^T \leq Q", r"x^T Q^{-1} x \leq 2", "refuted"),
    ],
)
def test_squares_with_an_inverse(latex: str, given: str, verdict: str) -> None:
    more = f"given = ['{given}']\n" if given else ""
    more += "invertible = ['A^T R^{-1} A']" if "L" in latex else ""
    found = judged_matrices(latex, "inequality", more, symbols=GAIN)
    assert found.verdict == verdict, found.reason
