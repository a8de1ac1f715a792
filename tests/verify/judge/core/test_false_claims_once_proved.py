"""False claims that once came out as proved; whatever their verdict, it must never be that."""

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
'y' = { unit = "1", meaning = "y" }
'z' = { unit = "1", meaning = "z" }
'a' = { unit = "1", meaning = "a" }
'i' = { unit = "1", integer = true, meaning = "index" }
'f' = { arguments = ["x"], definition = '\frac{\partial}{\partial x} (x^2)', meaning = "f" }
'g' = { arguments = ["x"], definition = 'x + w', meaning = "g" }
'w' = { definition = 'x + 1', meaning = "w" }
'q' = { definition = 'i + 1', meaning = "q" }
'r' = { arguments = ["a"], definition = 'a i', meaning = "r" }
'M' = { unit = "1", shape = [2, 2], meaning = "matrix" }
'N' = { unit = "1", shape = [2, 2], meaning = "matrix" }
'n' = { unit = "1", integer = true, domain = '2 \leq n', meaning = "count" }
'b_i' = { unit = "1", meaning = "entry" }
'b_1' = { unit = "1", meaning = "entry" }
'b_2' = { unit = "1", meaning = "entry" }
'b_n' = { unit = "1", meaning = "entry" }
[settings.line]
title = "least-squares line"
kind = "growing_memory"
degree = 1
gain = "filter"
[settings.line.symbols]
'k' = { quantity = "sample_number", meaning = "k" }
'\beta_k' = { quantity = "filter_gain.2", meaning = "gain" }
[[claims]]
id = "1"
place = "here"
"""

FALSE = [
    ("algebra", "identity", r"\left. b_i \right|_{i=2} = b_i", ""),
    ("algebra", "identity", r"\frac{d}{d i} b_i = 0", ""),
    ("algebra", "identity", r"b_1 + b_2 + \cdots + b_n = n b_i", ""),
    ("algebra", "identity", r"\sum_{i=1}^2 b_i = 2 b_i", ""),
    ("algebra", "identity", "M N = N M", ""),
    ("algebra", "inequality", r"M^2 \geq 0", ""),
    ("algebra", "identity", r"\frac{M N}{M} = N", ""),
    ("algebra", "limit", r"\lim_{x \to 0} \frac{\left| x \right|}{x} = 1", ""),
    ("algebra", "limit", r"\lim_{x \to 0-} \frac{\left| x \right|}{x} = 1", ""),
    ("algebra", "limit", r"\lim_{x \to 0+} \frac{1}{x} = -\infty", ""),
    ("algebra", "identity", "f(3) = 0", ""),
    ("algebra", "identity", "f(y) = 0", ""),
    ("algebra", "identity", "g(3) = x + 4", ""),
    ("algebra", "identity", r"\sum_{i=0}^2 q = 3 i + 3", ""),
    ("algebra", "identity", r"\sum_{i=0}^2 r(x) = 3 x i", ""),
    ("algebra", "inequality", "x^2 y^2 > 0", ""),
    ("algebra", "inequality", "x^2 y^2 > 0", "domain = '-1 < x < 1, -1 < y < 1'"),
    ("algebra", "inequality", "x^2 + y^2 > 0", ""),
    ("algebra", "inequality", r"x^2 + y^2 \neq 0", ""),
    ("algebra", "inequality", "-x^2 - y^2 < 0", ""),
    ("algebra", "identity", r"\frac{x^2 + y^2}{x^2 + y^2} = 1",
     r"domain = '-1 \leq x \leq 1, -1 \leq y \leq 1'"),
    ("algebra", "identity", "x = y", "given = ['x z^2 = y z^2']"),
    ("algebra", "identity", "x = y", "given = ['(x - y)(z^2 + a^2) = 0']"),
    ("algebra", "identity", r"\frac{x(y - x)}{y - x} = x", "domain = '-1 < y < 1'"),
    ("line", "identity", r"\beta_k = \frac{6}{(k + 1)(k + 2)}", r"domain = '-10 \leq k \leq -3'"),
]  # fmt: skip


@pytest.mark.parametrize(("setting", "kind", "latex", "more"), FALSE)
def test_is_not_proved(setting: str, kind: str, latex: str, more: str) -> None:
    text = f"{HEAD}kind = '{kind}'\nsetting = '{setting}'\nlatex = '{latex}'\n{more}\n"
    (found,) = judge_file(read_claim_text(text, "trial.toml"), [])
    assert found.to_json()["verdict"] != "proved", found.to_json()["reason"]


@pytest.mark.parametrize("latex", [r"x^2 y^2 \geq 0", r"-x^2 - y^2 \leq 0", "x^2 + y^2 + 1 > 0"])
def test_the_true_neighbour_is_proved(latex: str) -> None:
    text = f"{HEAD}kind = 'inequality'\nsetting = 'algebra'\nlatex = '{latex}'\n"
    (found,) = judge_file(read_claim_text(text, "trial.toml"), [])
    assert found.to_json()["verdict"] == "proved", found.to_json()["reason"]
