"""Forms that the reader reads and the judge cannot decide: the verdict says so and names them."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file

HEAD = r"""
format = "gainproof claims 1"
[source]
key = "trial"
title = "trial"
authors = ["A. Reader"]
publication = "unpublished"
[settings.algebra]
title = "no model"
kind = "algebra"
[settings.algebra.symbols]
'x' = { unit = "1", meaning = "x" }
'k' = { unit = "1", integer = true, domain = '1 \leq k', meaning = "index" }
'b_k' = { unit = "1", meaning = "entry" }
'b_1' = { unit = "1", meaning = "entry" }
'b_3' = { unit = "1", meaning = "entry" }
'A' = { unit = "1", shape = [2, 2], meaning = "matrix" }
'v' = { unit = "1", shape = [1, 3], meaning = "row" }
'u' = { arguments = ["x"], definition = 'x^2', meaning = "function" }
[[claims]]
id = "1"
place = "here"
setting = "algebra"
"""


@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", r"v = (b_1, \cdots, b_3)"),
        ("identity", r"A = \begin{bmatrix} A & A \\ A & A \end{bmatrix}"),
        ("identity", r"A = A \otimes A"),
        ("identity", r"A + x = A"),
        ("identity", r"\frac{x}{A} = x"),
        ("inequality", r"A \geq 0"),
        ("identity", r"A^x = A"),
        ("identity", r"\operatorname{rank} A = 2"),
        ("identity", r"\operatorname{diag}(x, x) = A"),
        ("identity", r"\prod_{k=1}^{x} k = x"),
        ("identity", r"\left. u(x) \right|_{x=\infty} = 0"),
        ("identity", r"x = x + O(x^2)"),
        ("identity", r"E[x] = 0"),
        ("identity", r"\operatorname{cov}(x, x) = x"),
        ("limit", r"\lim_{x \to 0} A = A"),
    ],
)
def test_undecided_with_a_reason(kind: str, latex: str) -> None:
    text = f"{HEAD}kind = \"{kind}\"\nlatex = '{latex}'\n"
    (found,) = judge_file(read_claim_text(text, "trial.toml"), [])
    assert found.verdict == "undecided", (found.verdict, found.reason)
    assert found.reason


def test_terms_of_a_sequence_are_not_all_one_number() -> None:
    text = f"{HEAD}kind = \"identity\"\nlatex = 'b_1 + \\cdots + b_3 = 3 b_k'\n"
    (found,) = judge_file(read_claim_text(text, "trial.toml"), [])
    assert found.verdict == "refuted", (found.verdict, found.reason)
