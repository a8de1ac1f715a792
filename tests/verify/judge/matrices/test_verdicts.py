"""Claims about matrices of every size: what is true is proved, and each slip in it refuted."""

from __future__ import annotations

import pytest
from matrix_claims import claim, judged_matrices
from one_of_each import cases

from gainproof.verify.judge.matrices.certificate import rejected

IDENTITIES = {
    r"(A B)^T = B^T A^T": r"(A B)^T = B A^T",
    r"H^T H = I_{n-p}": r"H^T H = 2 I_{n-p}",
    r"H^T V H = V_2": r"H^T V H = V_2 V_2",
    r"V = \begin{pmatrix} V_1 & V_{12} \\ V_{12}^T & V_2 \end{pmatrix}": (
        r"V = \begin{pmatrix} V_1 & -V_{12} \\ V_{12}^T & V_2 \end{pmatrix}"
    ),
    r"(Q B Q)^T = Q B^T Q": r"(Q B Q)^T = Q B Q",
    r"(I_n + S)^{-1} S = S (I_n + S)^{-1}": r"(I_n + S)^{-1} S = S (I_n + S)^{-1} S",
    r"(Q + A^T R A)^{-1} = Q^{-1} - Q^{-1} A^T (R^{-1} + A Q^{-1} A^T)^{-1} A Q^{-1}": (
        r"(Q + A^T R A)^{-1} = Q^{-1} + Q^{-1} A^T (R^{-1} + A Q^{-1} A^T)^{-1} A Q^{-1}"
    ),
    r"H^T V^{-1} H = (V_2 - V_{12}^T V_1^{-1} V_{12})^{-1}": (
        r"H^T V^{-1} H = (V_2 + V_{12}^T V_1^{-1} V_{12})^{-1}"
    ),
    r"H^T V^{-1} H (V_2 - V_{12}^T V_1^{-1} V_{12}) = I_{n-p}": r"H^T V^{-1} H V_2 = I_{n-p}",
    r"E[z] = A a": r"E[z] = - A a",
    r"E[v v^T] = R": r"E[v v^T] = 2 R",
    r"E[v w^T] = 0": r"E[v w^T] = R",
    r"(x, X x) = x^T X x": r"(x, X x) = - x^T X x",
}
LONGEST = r"(I_n + S)^{-1} S = S (I_n + S)^{-1}"


@pytest.mark.parametrize("latex", cases(IDENTITIES, lambda latex: latex != LONGEST))
def test_identities_are_proved_and_slips_refuted(latex: str) -> None:
    verdict = judged_matrices(latex)
    assert (verdict.verdict, verdict.method) == ("proved", "words"), verdict.reason
    assert all(rejected(part) is None for part in verdict.certificate["words"])
    wrong = judged_matrices(IDENTITIES[latex])
    # some slips do not matter for symmetric matrices, and that is said
    assert wrong.verdict == "refuted" or "is symmetric" in str(wrong.domain), wrong.reason
    assert wrong.witness is not None
    assert wrong.witness["left"] != wrong.witness["right"]


ORDERS = [
    (r"0 \leq A^T A", "", r"0 < A^T A"),
    (r"0 < Q + A^T A", "", r"0 < A^T A - Q"),
    (r"0 \leq A^T R A", "", r"A^T R A \leq 0"),
    (
        r"0 < V_1 - V_{12} V_2^{-1} V_{12}^T \leq V_1",
        "",
        r"V_1 \leq V_1 - V_{12} V_2^{-1} V_{12}^T",
    ),
    (r"0 < D_2 - D_{12}^T D_1^{-1} D_{12}", "", r"0 < D_{12}^T D_1^{-1} D_{12} - D_2"),
    (r"H (H^T V H)^{-1} H^T \leq V^{-1}", "", r"H (H^T V H)^{-1} H^T \geq V^{-1}"),
    (r"Y^{-1} \geq X^{-1} > 0", r"given = ['X \geq Y > 0']", r"Y^{-1} \leq X^{-1}"),
    (r"X \geq Z", r"given = ['X \geq Y', 'Y \geq Z']", r"X \leq Z"),
    (r"B^T X B \geq 0", r"given = ['X \geq 0']", r"B^T X B \leq 0"),
    (r"0 < A^T R^{-1} A", r"given = ['0 < A^T A']", r"A^T R^{-1} A \leq I_n"),
]


@pytest.mark.parametrize(("latex", "given", "wrong"), ORDERS)
def test_orders_are_proved_and_false_ones_refuted(latex: str, given: str, wrong: str) -> None:
    verdict = judged_matrices(latex, "inequality", given)
    assert verdict.verdict == "proved", verdict.reason
    other = judged_matrices(wrong, "inequality", given)
    assert other.verdict == "refuted", other.reason


@pytest.mark.parametrize(
    ("latex", "kind", "given"),
    [
        (r"0 < A^T R^{-1} A", "inequality", r"given = ['0 < A^T A']"),
        (r"B^T X B \geq 0", "inequality", r"given = ['X \geq 0']"),
        (r"X = Y", "identity", r"given = ['X \geq Y', 'Y \geq X']"),
        (r"B C = C B", "identity", r"given = ['B C = C B']"),
        (r"V^{-1} H = H V_2^{-1}", "identity", r"given = ['V_{12} = O_{p,n-p}']"),
        (r"A^T R^{-1} A", "invertible", r"given = ['0 < A^T A']"),
    ],
)
def test_what_a_claim_rests_on_is_needed(latex: str, kind: str, given: str) -> None:
    assert judged_matrices(latex, kind, given).verdict == "proved"
    assert judged_matrices(latex, kind).verdict in ("refuted", "conditional")


def test_an_estimator_where_its_inverse_exists() -> None:
    latex = r"E[(\hat{a} - a)(\hat{a} - a)^T] = (A^T R^{-1} A)^{-1}"
    assert judged_matrices(latex, "covariance", "given = ['0 < A^T A']").verdict == "proved"
    verdict = judged_matrices(latex, "covariance")
    assert verdict.verdict == "conditional"
    assert "A^T R^{-1} A has an inverse" in str(verdict.domain)
    slip = r"E[(\hat{a} - a)(\hat{a} - a)^T] = (A^T R A)^{-1}"
    assert judged_matrices(slip, "covariance", "given = ['0 < A^T A']").verdict == "refuted"
    assert (
        judged_matrices(r"E[\hat{a}] = a", "unbiased", "given = ['0 < A^T A']").verdict == "proved"
    )


def test_both_directions_of_an_equivalence() -> None:
    true = r"0 < A^T A \Leftrightarrow \det(A^T R^{-1} A) \neq 0"
    assert judged_matrices(true, "equivalence").verdict == "proved"
    assert judged_matrices(r"X \geq 0 \Rightarrow X > 0", "implication").verdict == "refuted"
    one_way = r"X > 0 \Leftrightarrow X \geq 0"
    assert judged_matrices(one_way, "equivalence").verdict == "refuted"


def test_shapes_are_compared() -> None:
    assert judged_matrices("A^T R A", "dimension", "shape = ['n', 'n']").verdict == "proved"
    wrong = judged_matrices("A^T R A", "dimension", "shape = ['n', 'm']")
    assert (wrong.verdict, wrong.method) == ("refuted", "shapes")
    assert "n x n, not n x m" in wrong.reason
    misfit = judged_matrices("A B^T A = A")
    assert (misfit.verdict, misfit.method) == ("refuted", "shapes")
    assert "n columns, m rows" in misfit.reason
    also = judged_matrices("B C = B C", more="shape = ['n', 'm']")
    assert also.verdict == "refuted"


def test_earlier_claims_may_be_used_and_false_ones_do_not_help() -> None:
    given = "given = ['C B = I_n']\n"
    lemma = claim("B C B = B", more=given, name="lemma")
    use = given + "using = ['lemma']"
    assert judged_matrices("B C B C = B C", more=use, before=[lemma]).verdict == "proved"
    false = claim("B = C", name="false")
    misled = judged_matrices("B B = C C", more="using = ['false']", before=[false])
    assert misled.verdict == "refuted"
    # true, but asked for by way of something false
    detour = judged_matrices("B - B = C - C", more="using = ['false']", before=[false])
    assert detour.verdict == "proved"
    assert len(detour.certificate["words"]) == 1
    without = judged_matrices("B C B C = B C", more="using = ['lemma']", before=[lemma])
    assert without.verdict == "refuted"


def test_what_a_definite_form_vanishes_on_is_zero() -> None:
    given = "given = ['x^T A^T R^{-1} A x = 0']"
    assert judged_matrices("A x = 0", more=given).verdict == "proved"
    assert judged_matrices("S x = 0", more="given = ['x^T X x = 0']").verdict == "refuted"


def test_agreement_is_no_proof() -> None:
    # every matrix of one row and column commutes; instances that are larger refute it
    assert judged_matrices("B C = C B").verdict == "refuted"
    # true, and no sum of squares that is looked for: x^T X Z Y X Z Y x... of equal letters
    true = r"B (C B + I_n)^{-1} = (B C + I_n)^{-1} B"
    verdict = judged_matrices(true, more="invertible = ['C B + I_n', 'B C + I_n']")
    assert verdict.verdict == "proved"
    hard = r"(B C + I_n)^{-1} = I_n - B (C B + I_n)^{-1} C"
    assert judged_matrices(hard, more="invertible = ['C B + I_n']").verdict in (
        "proved",
        "undecided",
    )


def test_a_determinant_that_is_not_zero_is_an_inverse() -> None:
    more = r"given = ['\det(B) \neq 0']"
    assert judged_matrices("B^{-1} B = I_n", more=more).verdict == "proved"
    assert judged_matrices(r"B^T B > 0", "inequality", more).verdict == "proved"
    alone = judged_matrices("(B - 2 C)^{-1} (B - 2 C) = I_n")
    assert (alone.verdict, alone.domain) == ("conditional", "B - 2 C has an inverse")


def test_a_counterexample_lists_no_values_of_what_means_are_taken_of() -> None:
    found = judged_matrices("E[(A a + v) v^T] = 2 R", "covariance")
    assert found.witness is not None
    assert {"R", "m", "n"} <= set(found.witness["point"])
    assert "v" not in found.witness["point"]
    # outside of means its value matters
    found = judged_matrices("v^T R v = 2 v^T v")
    assert found.witness is not None
    assert "v" in found.witness["point"]


@pytest.mark.parametrize(
    "more", ["given = ['R = 0']", "given = ['R < 0']", "invertible = ['R - R']"]
)
def test_of_hypotheses_that_contradict_each_other_nothing_follows(more: str) -> None:
    """They hold of matrices without rows, of which everything is true."""
    found = judged_matrices("A = 5 A", more=more)
    assert found.verdict == "undecided"
    assert "without entries" in found.reason
