"""Declarations and claims made to do harm, or slips: errors with their place, or nothing proved."""

from __future__ import annotations

import copy
from typing import Any

import pytest
from matrix_claims import SYMBOLS, claim, judged_matrices, text_of

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.matrices.certificate import rejected
from gainproof.verify.judge.matrices.claim_directions import cases_of
from gainproof.verify.judge.matrices.ideal_membership import Budget, UnprovedError
from gainproof.verify.judge.matrices.layered_proof import Layers
from gainproof.verify.judge.matrices.shapes import Shapes

BAD_LETTERS = {
    "'K' = { definition = '-Q', is = ['positive definite'], meaning = 'no' }": "nothing else",
    "'K' = { definition = 'K Q', meaning = 'circle' }": "circle",
    "'K' = { definition = 'A A', meaning = 'misfit' }": "n columns, m rows",
    "'K' = { shape = ['m', 'n'], is = ['symmetric'], meaning = 'no square' }": "m x n",
    "'K' = { shape = ['n', 'n'], is = ['orthogonal'], meaning = 'unknown' }": "known are",
    "'K' = { shape = ['n - m', 'n'], meaning = 'negative' }": "may be negative",
    "'K' = { shape = ['k', 'n'], meaning = 'undeclared' }": "no size k",
    "'K' = { shape = ['n', 'n'], variance = 'Q', meaning = 'no column' }": "a column",
    "'y' = { shape = ['n', '1'], variance = 'X', meaning = 'may be negative' }": "semidefinite",
    "'y' = { shape = ['n', '1'], variance = 'x x^T', meaning = 'of a column' }": "semidefinite",
    "'K' = { shape = ['n', 'n'], blocks = [['V_1']], meaning = 'again' }": "already a block of V",
    "'K' = { meaning = 'nothing' }": "this field is missing",
    "'K' = { shape = ['n', 'n'], color = 'red', meaning = 'unknown field' }": "not known",
    "'A' = { shape = ['n', 'n'], meaning = 'twice' }": "TOML",
    "'p' = { shape = ['n', 'n'], meaning = 'a size' }": "declared twice",
    "'K' = { definition = 'E_1', meaning = 'undeclared' }": "not declared",
    "'K' = { shape = ['n', 'n'], blocks = [['V_1']], meaning = 'small' }": "two|fill|block",
}


@pytest.mark.parametrize("line", list(BAD_LETTERS))
def test_bad_declarations_are_refused_with_their_place(line: str) -> None:
    text = text_of(claim("A = A"), SYMBOLS + line + "\n")
    with pytest.raises(ClaimFileError, match=BAD_LETTERS[line]) as caught:
        read_claim_text(text)
    assert "line" in str(caught.value)


BAD_CLAIMS = {
    "A = T": "not declared",
    "A = A^5": "power of a matrix",
    "A = " + "(" * 12 + "A" + "^4)^4" * 6 + "^4)" * 6: "a power of more than",
    r"A = \frac{A}": r"wanted \{",
    "A = (A": r"wanted \)",
    "A + = A": "a matrix is wanted",
    "I_{k} = I_n": "no size k",
    r"A = A \quad n > 1": "parentheses",
    r"\begin{pmatrix} B & C \\ B \end{pmatrix} = B": "different lengths",
    "(" * 60 + "A" + ")" * 60 + " = A": "inside one another",
    "A = " + "A + " * 1500 + "A": "more than|characters",
    r"A = \frac{1}{0} A": "division by zero",
    r"\underline{AB} = A": "more than one symbol",
    r"A + \hat{A_0} = A": "not declared",
    r"A + \mathrm{0}_5 = A": "not declared",
    r"\hat{\hat{a}} = \hat{a}": "not declared",
    "B" + 5 * "^{-T}" + " = B": "powers",
}


@pytest.mark.parametrize("latex", list(BAD_CLAIMS))
def test_bad_formulas_are_refused_with_their_place(latex: str) -> None:
    with pytest.raises(ClaimFileError, match=BAD_CLAIMS[latex]) as caught:
        read_claim_text(text_of(claim(latex)))
    assert "line" in str(caught.value)


@pytest.mark.parametrize(
    ("latex", "kind", "more"),
    [
        ("A = A", "steady_state", ""),
        ("A = A", "identity", "domain = 'n > 1'"),
        ("A = A", "identity", "using = ['later']"),
        ("A = A", "dimension", ""),
        ("A = 2 A", "dimension", "shape = ['m', 'n']"),
        ("A = A", "unbiased", ""),
        ("A = A", "inequality", ""),
        ("A = A", "identity", "given = ['A']"),
        (r"A \Rightarrow A", "implication", ""),
    ],
)
def test_fields_that_do_not_belong_are_refused(latex: str, kind: str, more: str) -> None:
    with pytest.raises(ClaimFileError):
        read_claim_text(text_of(claim(latex, kind, more)))


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ("hint = ['A + B']", "m x n and n x n"),
        ("hint = ['B^T', '0^{-1}']", "zero is not said"),
        ("given = ['A < A^T']", "are compared"),
        ("given = ['A = B']", "are compared"),
        ("invertible = ['A']", "inverse of a matrix of shape m x n"),
    ],
)
def test_shapes_of_what_the_author_adds_are_his_own(more: str, message: str) -> None:
    """A true claim was refuted for the shapes of a hint."""
    with pytest.raises(ClaimFileError, match=message) as caught:
        read_claim_text(text_of(claim("B = B", more=more)))
    assert "line" in str(caught.value)


@pytest.mark.parametrize("hint", ["(A A^T)^{-1}", "(B - B)^{-1}", "B^{-1}", "A^T"])
def test_a_hint_is_no_hypothesis(hint: str) -> None:
    """That an inverse in it may not exist says nothing of the claim."""
    assert judged_matrices("Q + S > 0", "inequality", f"hint = ['{hint}']").verdict == "proved"
    assert judged_matrices("S > 0", "inequality", f"hint = ['{hint}']").verdict == "refuted"


@pytest.mark.alike
@pytest.mark.parametrize(
    "given",
    [
        "given = ['Q < 0']",
        "given = ['X > 0', 'X < 0']",
        r"given = ['B = 2 B', '0 < B^T B']",
        "given = ['I_n = O_{n,n}']",
        "given = ['Q = -Q']",
        "invertible = ['B - B']",
    ],
)
def test_hypotheses_that_nothing_satisfies_prove_nothing(given: str) -> None:
    verdict = judged_matrices("B C = C B", more=given)
    assert verdict.verdict == "undecided"
    assert "no exact instance" in verdict.reason


def test_large_formulas_are_given_up() -> None:
    power = " ".join(["(B + C + X + Y)"] * 12)
    assert judged_matrices(f"{power} = {power}").verdict in ("undecided", "proved")
    deep = "B"
    for _ in range(9):
        deep = f"(({deep})^{{-1}} + I_n)"
    assert judged_matrices(f"{deep} = B").verdict in ("undecided", "refuted", "conditional")


def altered(value: Any) -> list[Any]:
    """Every copy of plain data in which one number, sign or place of a proof is another."""
    found: list[Any] = []
    if isinstance(value, dict):
        for key, inner in value.items():
            found += [{**value, key: other} for other in altered(inner)]
    elif isinstance(value, list):
        for at, inner in enumerate(value):
            found += [[*value[:at], other, *value[at + 1 :]] for other in altered(inner)]
        if value:
            found.append(value[1:])
    elif isinstance(value, str) and value.lstrip("-").isdigit():
        found.append(str(int(value) + 1))
    elif type(value) is int:
        found.append(value + 1)
    return found


def test_an_altered_proof_is_rejected() -> None:
    verdict = judged_matrices("0 < V_1 - V_{12} V_2^{-1} V_{12}^T", "inequality")
    (part,) = verdict.certificate["words"]
    assert rejected(part) is None
    count = 0
    for number, statement in enumerate(part["statements"]):
        for evidence in altered(statement["evidence"]):
            changed = copy.deepcopy(part)
            changed["statements"][number]["evidence"] = evidence
            assert rejected(changed) is not None, evidence
            count += 1
    assert count > 50


TWO_BY_TWO = """
'K' = { shape = ["n", "n"], blocks = [['K_1', 'K_2'], ['CELL', 'K_3']], meaning = "in blocks" }
'K_1' = { shape = ["p", "p"], meaning = "block" }
'K_2' = { shape = ["p", "n-p"], meaning = "block" }
'K_3' = { shape = ["n-p", "n-p"], meaning = "block" }
"""


@pytest.mark.parametrize(
    ("cell", "problem"),
    [("K_2^T", "K is not said to be symmetric"), ("K_1^T", "not opposite to K_1")],
)
def test_a_transpose_as_a_block_is_no_fact_by_itself(cell: str, problem: str) -> None:
    text = text_of(claim("A = A"), SYMBOLS + TWO_BY_TWO.replace("CELL", cell))
    with pytest.raises(ClaimFileError, match=problem.replace("^", r"\^")):
        read_claim_text(text)


HIDDEN = r"""
'K' = { definition = '(B - C)^{-1}', meaning = "perhaps none" }
'L' = { definition = '\begin{pmatrix} K & O_{n,n} \\ O_{n,n} & I_n \end{pmatrix}', meaning = "n" }
"""


@pytest.mark.parametrize("latex", ["K + K = 2 K", "L + L = 2 L", r"L^T L \geq 0"])
@pytest.mark.parametrize("more", ["", "using = ['0']"])
def test_a_definition_that_stays_closed_has_to_mean_something(latex: str, more: str) -> None:
    """(B - C)^{-1} is nothing where B = C, whatever would be true of any matrix. Instances, which
    rarely have B = C, are not asked.
    """
    kind = "inequality" if "geq" in latex else "identity"
    given = "invertible = ['B - C']"
    text = claim("I_n = I_n", name="0") + claim(latex, kind, more)
    text += claim(latex, kind, f"{more}\n{given}", name="2")
    read = read_claim_text(text_of(text, SYMBOLS + HIDDEN))
    setting = read.settings["s"].matrices
    assert setting is not None
    questions = [
        cases_of(each.matrices, Shapes(setting.letters, setting.sizes))[0].question
        for each in read.claims
        if each.matrices is not None
    ]
    with pytest.raises(UnprovedError, match="has an inverse"):
        Layers(setting, {}, Budget()).prove(questions[1])
    assert Layers(setting, {}, Budget()).prove(questions[2])


@pytest.mark.parametrize("latex", [r"(Q + V)^{-1} \leq Q^{-1}", r"(Q + V)^{-1} < Q^{-1}"])
def test_every_search_of_a_proof_is_paid_for(latex: str) -> None:
    """Also those of lemmas, of left inverses and of what is multiplied out: with a proof's own
    steps it is found, with half of them it is given up.
    """
    read = read_claim_text(text_of(claim(latex, "inequality")))
    setting, each = read.settings["s"].matrices, read.claims[0].matrices
    assert setting is not None
    assert each is not None
    question = cases_of(each, Shapes(setting.letters, setting.sizes))[0].question
    budget = Budget()
    whole = budget.remaining
    assert Layers(setting, {}, budget).prove(question)
    spent = whole - budget.remaining
    assert spent > 0
    with pytest.raises(UnprovedError):
        Layers(setting, {}, Budget(spent // 2)).prove(question)


@pytest.mark.parametrize("latex", ["Q \\geq Q^{-1}", "Q^{-1} \\geq Q", "Q^{-1} \\geq V"])
def test_a_matrix_and_its_inverse_are_not_compared_for_ever(latex: str) -> None:
    assert judged_matrices(latex, "inequality").verdict in ("refuted", "conditional")


def test_an_inner_product_is_of_columns() -> None:
    found = judged_matrices("(x^T, X x) = x^T X x")
    assert (found.verdict, found.method) == ("refuted", "shapes")


@pytest.mark.parametrize("latex", ["0 B = B", "a^T a B = B a^T a"])
def test_shapes_that_are_left_open_refute_nothing(latex: str) -> None:
    assert judged_matrices(latex).verdict == "undecided"


NAMED = """
'K' = { definition = 'B C', meaning = "a product" }
'L' = { definition = 'K v_0', meaning = "a column made of it" }
'v_0' = { shape = ["n", "1"], variance = 'Q', meaning = "random" }
'T' = { definition = 'B + C', meaning = "a sum" }
"""


def judged_with(latex: str, premises: list[tuple[str, str]], more: str = "") -> str:
    """The verdict on a claim that uses others, each a formula with its fields."""
    before = [claim(t, more=m, name=f"p{n}") for n, (t, m) in enumerate(premises)]
    names = ", ".join(f"'p{n}'" for n in range(len(premises)))
    kind = "covariance" if "E[" in latex else "identity"
    using = f"using = [{names}]\n{more}"
    return judged_matrices(latex, kind, using, before, SYMBOLS + NAMED).verdict


def test_what_a_premise_says_a_letter_is_has_to_be_true() -> None:
    assert judged_with("K C = B C C", [("K = B C", "")]) == "proved"
    assert judged_with("K C = C B C", [("K = C B", "")]) == "refuted"
    assert judged_with("T = C + B", [("T = B + C", ""), ("K = B C", "")]) == "proved"
    # true only under a hypothesis that the claim does not have
    given = "given = ['B C = C B']"
    assert judged_with("K = C B", [("K = C B", given)]) == "refuted"
    assert judged_with("K B = C B B", [("K = C B", given)], given) == "proved"
    # a letter that is said to be made of itself, and two that are made of one another
    assert judged_with("K = K + K", [("K = K B B^{-1} + K", "")]) in ("refuted", "conditional")
    circle = [("K = T C - C C", ""), ("T = T + K - B C", "")]
    assert judged_with("K + T = B C + B + C", circle) == "proved"
    assert judged_with("K + T = C B + B + C", circle) == "refuted"
    # a random letter stays one
    assert judged_with("E[L L^T] = K Q K^T", [("L = B C v_0", "")]) == "proved"
    assert judged_with("E[L L^T] = L L^T", [("L = B C v_0", "")]) != "proved"
    assert judged_with("E[L] = L", [("L = K v_0", "")]) != "proved"
