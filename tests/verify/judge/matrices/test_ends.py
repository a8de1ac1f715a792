"""The search for a proof ends: no question waits for itself, and what is too deep is said to be."""

from __future__ import annotations

from itertools import pairwise

import pytest
from matrix_claims import SYMBOLS, judged_matrices
from one_of_each import further

DEFINED = SYMBOLS + (
    r"""
'T' = { shape = ["n", "2n"], meaning = "any" }
'K' = { definition = '\begin{pmatrix} (Q + X)^{-1} & I_n \\ O_{n,n} & B \end{pmatrix}', """
    'meaning = "closed, with an inverse in it" }\n'
)


@pytest.mark.parametrize(
    ("latex", "given", "verdict"),
    [
        (r"I_n \geq Q^{-1}", [r"Q \geq I_n"], "proved"),
        ("Q^{-1} < I_n", ["Q > I_n"], "proved"),
        (r"Q \leq I_n", [r"Q^{-1} \geq I_n"], "proved"),
        (r"V^{-1} \geq X^{-1}", [r"X \geq Q", r"Q \geq V"], "proved"),
        (r"Y^{-1} \geq X^{-1}", [r"X \geq Y", "Y > 0"], "proved"),
        (r"I_n \leq Q^{-1}", [r"Q \geq I_n"], "refuted"),
        ("Q^{-1} < I_n", [r"Q \geq I_n"], "refuted"),
        ("X - Y < 0", [], "refuted"),
        (r"X^{-1} \leq Q^{-1}", [r"X \geq Y", "Y > 0"], "refuted"),
    ],
)
def test_orders_of_inverses_and_of_their_bases(latex: str, given: list[str], verdict: str) -> None:
    """X >= Y > 0 gives Y^{-1} >= X^{-1}, and the other way round, which is asked only once."""
    hypotheses = ", ".join(f"'{one}'" for one in given)
    found = judged_matrices(latex, "inequality", f"given = [{hypotheses}]")
    assert found.verdict == verdict


def test_a_false_equation_with_inverses_of_differences() -> None:
    assert judged_matrices("(Q - V)^{-1} Q = I_n + (Q + V)^{-1} V").verdict == "refuted"


@pytest.mark.parametrize("hypothesis", ["K = K", "T K = T"])
@pytest.mark.parametrize(("latex", "verdict"), [("T K = T K", "proved"), ("T K = K", "refuted")])
def test_an_inverse_in_a_closed_definition_that_a_hypothesis_speaks_of(
    hypothesis: str, latex: str, verdict: str
) -> None:
    """That Q + X has an inverse is not asked again while K, which has it inside, is closed."""
    given = f"given = ['Q + X > 0', '{hypothesis}']"
    assert judged_matrices(latex, more=given, symbols=DEFINED).verdict == verdict


@pytest.mark.parametrize(("before", "after"), [("(Q + ", ")"), ("(I_n + ", ")^{-1}"), ("Q (", ")")])
@pytest.mark.parametrize("relation", ["=", further("<")])
def test_definitions_too_deep_inside_one_another(before: str, after: str, relation: str) -> None:
    names = ["B", *(f"L_{{{n}}}" for n in range(1, 61))]
    lines = [
        f"'{name}' = {{ definition = '{before * 6}{last}{after * 6}', meaning = 'deeper' }}"
        for last, name in pairwise(names)
    ]
    kind = "identity" if relation == "=" else "inequality"
    latex = f"{names[-1]} {relation} B"
    found = judged_matrices(latex, kind, symbols=SYMBOLS + "\n".join(lines) + "\n")
    assert found.verdict == "undecided"
    assert "too deep" in found.reason
