"""Formulas about matrices of any size, asked for in a line: shapes follow from the formula, letters
are what they usually are in a filter, and what is said of them counts.

What is true is in any textbook on matrices or Kalman filters; what is false is checked here against
NumPy at random matrices of the shapes that the answer names.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gainproof
from gainproof.answers.judge import Judge
from gainproof.answers.possible_filters import Options
from gainproof.bad_input import BadInputError

OPTIMAL = "K = P H^T (H P H^T + R)^{-1}"
JOSEPH = "(I - K H) P (I - K H)^T + K R K^T"


@pytest.fixture(scope="module")
def judge() -> Iterator[Judge]:
    with Judge(fresh=True) as judge:
        yield judge


@pytest.mark.parametrize(
    ("formula", "said", "assumed"),
    [
        (f"{JOSEPH} = P - K H P", {}, OPTIMAL),
        (f"{JOSEPH} = P - P H^T K^T", {}, OPTIMAL),
        ("K = (P^{-1} + H^T R^{-1} H)^{-1} H^T R^{-1}", {}, OPTIMAL),
        ("(P^{-1} + H^T R^{-1} H)^{-1} = (I - K H) P", {}, OPTIMAL),
        ("K S K^T = P H^T S^{-1} H P", {}, "K = P H^T S^{-1}"),
        (r"P C^\top (C P C^\top + R)^{-1} = K", {}, "K = P C^T (C P C^T + R)^{-1}"),
        ("K = P*H'*inv(H*P*H' + R)", {}, OPTIMAL),
        ("K = P @ H.T @ inv(H @ P @ H.T + R)", {}, OPTIMAL),
        ("PH' = (HP)'", {}, "P: n x n, positive definite"),
        ("(K H)^T = H^T K^T", {}, "K: n x m"),
        ("F P F^T + G Q G^T >= 0", {}, "Q: l x l, positive semidefinite"),
        ("x^T P x >= 0", {}, "x: n x 1"),
        ("x' P y = y' P x", {}, "y: n x 1"),
        ("(A B)^{-1} = B^{-1} A^{-1}", {"model": "matrices"}, "inverse: that of A B exists"),
        (
            "(A + B D E)^{-1} = A^{-1} - A^{-1} B (D^{-1} + E A^{-1} B)^{-1} E A^{-1}",
            {"model": "matrices"},
            "inverse: that of A + B D E exists",
        ),
        (r"\lambda P + (1 - \lambda) P = P", {"model": "matrices"}, r"\lambda: number"),
        ("A^T = A", {"symbols": {"A": "3 x 3, symmetric"}}, "A: 3 x 3, symmetric"),
        ("a A = A a", {"symbols": {"a": "number", "A": "n x m"}}, "a: number"),
        ("D H P = 0", {"symbols": {"D": "n x m"}, "given": ("P H^T = 0",)}, "given: P H^T = 0"),
        ("W = W^T", {"symbols": {"W": "= A^T R A"}}, "W: short for A^T R A"),
        ("(I - K H) K = K (I - H K)", {"model": "matrices"}, "n x m"),
        ("P*H'*(H*P*H' + R)^-1*H*P = K*H*P", {}, OPTIMAL),
        ("x'*A*x = 0", {"given": ("A' = -A",)}, "x: n x 1"),
        ("I*A' = A'", {}, "I: identity matrix"),
        ("x'*P*x >= 0", {}, "x: n x 1"),
        (f"{JOSEPH} = P - K H P".replace("^T", "^{T}"), {}, OPTIMAL),
        (
            r"(\mathbf I - \mathbf K \mathbf H)^T = \mathbf I - \mathbf H^T \mathbf K^T",
            {},
            "identity",
        ),
        (r"\hat I A^T = \hat I A^T", {}, r"\hat{I}: "),
        ("inv(A.T@A)@A.T@A = I", {}, "inverse: that of"),
        (r"\lambda_1 A^T = A^T \lambda_1", {}, r"\lambda_1: number"),
        (r"\lambda^T x = x^T \lambda", {}, r"\lambda: n x 1"),
        (r"\lambda I - A^T = (\lambda I - A)^T", {}, r"\lambda: number"),
        ("h P h^T >= 0", {}, "h: "),
        ("(I-KH)P^-(I-KH)^T + KRK^T = (I-KH)P^-", {}, "K = P_{prior} H^T"),
        ("P^+ = (I-KH) P^- (I-KH)^T + K R K^T", {}, "P_{posterior} = P_{prior} - K H P_{prior}"),
        (
            "P_{k|k}^{-1} = P_{k|k-1}^{-1} + H_k^T R_k^{-1} H_k",
            {},
            "P_{k|k}: P_{k|k-1} - P_{k|k-1} H_k^T",
        ),
        ("(I-WH)P(I-WH)^T+WRW^T = P-WSW^T", {}, "W = P H^T S^{-1}"),
        ("$(A B)^T = B^T A^T$", {}, "A: n x m"),
        (
            "P^+ = (I-KH) P^- (I-KH)^T + K R K^T",
            {"symbols": {"P^+": "= (I - K H) P^-", "K": "= P^- H^T (H P^- H^T + R)^{-1}"}},
            "P_{posterior}: short for (I - K H) P^-",
        ),
        (r"\Phi P \Phi^T + Q >= 0", {}, "Q: n x n, positive semidefinite"),
        (r"A^T P A \succeq 0", {}, "A: n x m"),
        ("H^TR^{-1}H = (H^TR^{-1}H)^T", {}, "H: m x n"),
        ("(AB)' = B'A'", {}, "A: n x m"),
        ("(eye(n) - K*H)*P = P - K*H*P", {"model": "matrices"}, "identity matrix"),
        ("(A^T + I_2)^T = A + I_2", {"symbols": {"A": "2 x 2"}}, "identity matrix"),
        ("A >= 0", {"given": ("A = B^T B",)}, "B: "),  # a hypothesis says what it is about too
        ("A^T B A >= 0", {"given": ("B >= 0",)}, "B: n x n"),  # what has an order is square
        ("2 A > A", {"given": ("A > 0",), "model": "matrices"}, "A: n x n"),
        # its identity matrices have the size that the gain gives them
        ("K^T (I + K K^T) K = (I + K^T K) S^{-1} H P P H^T S^{-1}", {}, "K = P H^T S^{-1}"),
    ],
)
def test_what_is_true_is_proved(
    judge: Judge, formula: str, said: Mapping[str, Any], assumed: str
) -> None:
    found = judge.ask(formula, **said)
    assert found.verdict == "proved", found
    assert assumed in "; ".join(f"{each.of}: {each.meaning}" for each in found.assumed)
    tomllib.loads(found.text)


@pytest.mark.parametrize("letter", ["P", "Q_k", r"\Sigma", "S"])
def test_a_hypothesis_about_a_letter_counts_more_than_what_it_usually_is(
    judge: Judge, letter: str
) -> None:
    """A covariance is usually taken for definite; zero is a matrix that is none, and >= 0."""
    found = judge.ask(f"{letter} > 0", given=[f"0 <= {letter}"], model="matrices")
    assert found.verdict == "refuted"
    (meaning,) = (each.meaning for each in found.assumed if each.of == letter)
    assert meaning in ("n x n", "m x m")
    turned = judge.ask(f"x^T {letter} x >= 0", given=[f"{letter} = {letter}^T"])
    assert turned.verdict != "proved"  # of a symmetric matrix
    for scale in ("", r"\lambda "):
        reflection = judge.ask(f"x^T {letter} x >= 0", given=[f"{letter} {letter}^T = {scale}I"])
        assert reflection.verdict != "proved"  # -I is one
    other = judge.ask(f"{letter} >= 0", given=[f"{letter} > 0"], model="matrices")
    assert other.verdict == "proved"
    assert judge.ask(f"{letter} >= 0", model="matrices").verdict != "proved"  # by a guess


def _definite(rng: np.random.Generator, size: int) -> Any:
    root = rng.normal(size=(size, size))
    return root @ root.T + np.eye(size)


def _kalman(p: Any, h: Any, r: Any) -> Any:
    return p @ h.T @ np.linalg.inv(h @ p @ h.T + r)


@pytest.mark.parametrize(
    ("formula", "difference"),
    [
        (f"{JOSEPH} = P + K H P", lambda p, h, r, k: _joseph(p, h, r, k) - (p + k @ h @ p)),
        (
            "(I - K H) P (I - K H)^T - K R K^T = P - K H P",
            lambda p, h, r, k: _joseph(p, h, -r, k) - (p - k @ h @ p),
        ),
        (
            "K = (P^{-1} + H^T R^{-1} H)^{-1} H^T R",
            lambda p, h, r, k: k - np.linalg.inv(_information(p, h, r)) @ h.T @ r,
        ),
        (
            "P^{-1} + H^T R^{-1} H = (P + K H P)^{-1}",
            lambda p, h, r, k: _information(p, h, r) - np.linalg.inv(p + k @ h @ p),
        ),
        ("K H = H^T K^T", lambda _p, h, _r, k: k @ h - h.T @ k.T),
        ("K H P = P H^T K", None),
        ("A@inv(A.T@A)@A.T = I", None),
        ("I_{xx} A^T = A^T I_{xx}", None),
        ("X^T X > 0", None),
        ("K = F P H^T (H P H^T + R)^{-1}", None),
    ],
)
def test_what_is_false_is_refuted(judge: Judge, formula: str, difference: Any) -> None:
    found = judge.ask(formula)
    if (
        difference is None
    ):  # by hand: a projection, matrices that do not commute, columns that are 0
        assert found.verdict == "refuted"
        return
    rng = np.random.default_rng(1)
    p, r, h = _definite(rng, 3), _definite(rng, 2), rng.normal(size=(2, 3))
    assert np.abs(difference(p, h, r, _kalman(p, h, r))).max() > 1e-3
    assert found.verdict == "refuted"
    assert found.witness


def _joseph(p: Any, h: Any, r: Any, k: Any) -> Any:
    left = np.eye(len(p)) - k @ h
    return left @ p @ left.T + k @ r @ k.T


def _information(p: Any, h: Any, r: Any) -> Any:
    return np.linalg.inv(p) + h.T @ np.linalg.inv(r) @ h


@pytest.mark.parametrize(
    "formula", ["A'*A = A*A'", "H'*R^-1*H = H*R^-1*H'", "A^{T} A = A A^{T}", "(B'*B)*B = B*(B*B')"]
)
def test_what_holds_of_some_matrices_is_not_proved(judge: Judge, formula: str) -> None:
    """Of numbers these are true: a prime and a T in braces are read as transposes."""
    assert judge.ask(formula).verdict in ("conditional", "refuted")


def test_without_a_gain_of_its_own_a_letter_is_any_matrix(judge: Judge) -> None:
    """Of any gain the short form of the covariance is false, and K may be said to be any."""
    found = judge.ask(f"{JOSEPH} = P - K H P", symbols={"K": "n x m"})
    assert found.verdict == "refuted"
    assert all(other[0] != OPTIMAL for other in found.others)


def test_what_is_alone_on_one_side_is_defined(judge: Judge) -> None:
    assert judge.ask("P_k = F P_{k-1} F^T + Q").verdict == "definition"
    assert judge.ask("P_k = F P_{k-1} F^T + Q", given=["P_k > 0"]).verdict != "definition"


@pytest.mark.parametrize(
    ("formula", "said", "message"),
    [
        ("A^T B = C", {"symbols": {"A": "2 x 3", "B": "3 x 2"}}, "a product: sizes do not fit"),
        ("A^T = A", {"symbols": {"A": "2 x 3"}}, "both sides: sizes do not fit, 2 beside 3"),
        ("A^T = A", {"symbols": {"A": "n x n, round"}}, "of a matrix a shape is wanted"),
        ("A^T = A", {"symbols": {"B": "n x n"}}, "the formula has no B; its symbols: A"),
        ("e^{aT} = b^T", {}, r"an exponent T is written \^\{\(T\)\}"),
        ("E[x x^T] = P", {}, "expectation in a formula about matrices of any size"),
        ("A^T = A", {"domain": "a > 0", "model": "matrices"}, "--domain: a formula about matrices"),
        ("A^T = A", {"model": "random-velocity", "symbols": {"A": "n x n"}}, "--model random-vel"),
        ("I.T = I", {"model": "matrices"}, "needs a letter beside the identity"),
        ("I_5 A^T = A^T I_7", {"symbols": {"A": "2 x 3"}}, "sizes do not fit, "),
        ("A B C D E F G J L N U W Y^T = 0", {}, "more than 11 sizes"),
        ("n A = A n", {"symbols": {"A": "n x n"}}, "n is a size and a letter"),
        ("A^T = A", {"symbols": {"A": "="}}, "a formula is wanted behind ="),
        (r"\Delta t A^T = A^T \Delta t", {}, r"\\Delta t in a formula about matrices"),
        ("(" * 300 + "A" + ")" * 300 + "^T = A", {}, "deep|nested|too many"),
    ],
)
def test_bad_input_is_told(
    judge: Judge, formula: str, said: Mapping[str, Any], message: str
) -> None:
    with pytest.raises(BadInputError, match=message):
        judge.ask(formula, **said)


def test_an_error_shows_the_identity_as_it_was_typed(judge: Judge) -> None:
    with pytest.raises(BadInputError) as caught:
        judge.ask("P(k+1|k+1) = [I - K H] P^T I ( |")
    _, shown, mark = str(caught.value).split("\n")
    assert "I_{1" not in shown
    assert shown[mark.index("^")] == "|"


def test_a_prime_of_a_number_stays_one(judge: Judge) -> None:
    assert "matrices" not in str(judge.ask("x' - x = v*T").assumed)


def test_the_saved_file_says_the_same(tmp_path: Path, judge: Judge) -> None:
    asked = judge.question("P - K H P = (P^{-1} + H^T R^{-1} H)^{-1}", Options())
    file = tmp_path / "asked.toml"
    file.write_text(asked.text, encoding="utf-8")
    verdicts = [claim.verdict for claim in gainproof.check(str(file), seconds=20)]
    assert verdicts == ["proved", "refuted"]
