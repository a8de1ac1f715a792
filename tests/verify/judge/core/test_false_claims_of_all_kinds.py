"""False claims of further kinds that once came out as proved, and true neighbours that stay so."""

from __future__ import annotations

import pytest
from one_of_each import further

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
'p' = { unit = "1", domain = 'p > 0', meaning = "a positive number" }
'q' = { unit = "1", domain = 'q > 0', meaning = "another" }
'r' = { unit = "1", domain = '0 \leq r \leq 1', meaning = "a number up to one" }
'n' = { unit = "1", integer = true, meaning = "a whole number" }
'k' = { unit = "1", integer = true, domain = 'k \geq 0', meaning = "number of a sample" }
'i' = { unit = "1", integer = true, meaning = "index" }
'z_i' = { unit = "1", meaning = "term of a sequence" }
'z_k' = { unit = "1", meaning = "term of a sequence" }
'f' = { unit = "1", arguments = ["i"], definition = 'z_i', meaning = "f" }
[[claims]]
id = "1"
place = "here"
setting = "algebra"
"""


def _verdict(kind: str, latex: str, *more: str) -> str:
    lines = [f"kind = '{kind}'", f"latex = '{latex}'" if latex else "", *more]
    (found,) = judge_file(read_claim_text(HEAD + "\n".join(lines), "trial.toml"), [])
    return str(found.to_json()["verdict"])


def _monotone(subject: str, variable: str, *more: str) -> str:
    about = f"about = ['{subject}', '{variable}']"
    return _verdict("monotone", "", about, "trend = 'increasing'", "text = 'it rises'", *more)


@pytest.mark.parametrize(
    ("subject", "variable", "more"),
    [
        (r"\tan x", "x", ""),
        (r"\frac{\sin x}{\cos x}", "x", ""),
        ("x y^2", "x", ""),
        ("x (y - 1)^2", "x", ""),
        ("x^2 y", "x", r"domain = 'x \geq 0, y \geq 0'"),
        (r"-\frac{1}{\log x}", "x", "domain = 'x > 0'"),
        (r"-\frac{1}{\arctan x}", "x", "domain = '-1 < x < 1'"),
        (r"-\frac{1}{n}", "n", ""),
        (r"-\frac{1}{n}", "n", "given = ['n^2 > 0']"),
    ],
)
def test_a_pole_or_a_standstill_is_no_growth(subject: str, variable: str, more: str) -> None:
    assert _monotone(subject, variable, more) != "proved"


@pytest.mark.parametrize(
    ("subject", "variable", "more"),
    [
        (r"x + \sin x", "x", ""),
        ("x^3", "x", ""),
        ("x^2 y", "x", r"domain = 'x \geq 0, y > 0'"),
        (r"-\frac{1}{n}", "n", r"domain = 'n \geq 1'"),
    ],
)
def test_true_growth_is_proved(subject: str, variable: str, more: str) -> None:
    assert _monotone(subject, variable, more) == "proved"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "more"),
    [
        (r"\frac{\cos x}{\cos x} = 1", "domain = '-2 < x < 2'"),
        (r"\frac{1 + \cos x}{1 + \cos x} = 1", "domain = '-4 < x < 4'"),
        (r"(1 + \cos x)^{-1} (1 + \cos x) = 1", "domain = '-4 < x < 4'"),
        (r"\tan(x) \cos(x) = \sin(x)", r"domain = '0 \leq x \leq 3'"),
        (r"\frac{x^n}{x^n} = 1", r"domain = '-1 < x < 1, n \geq 1'"),
        (r"\frac{\log p}{\log p} = 1", ""),
        (r"\left(\frac{x}{x}\right)^n = 1", "domain = '-1 < x < 1'"),
        (r"e^{x/x - 1} = 1", "domain = '-1 < x < 1'"),
        (r"\int_0^\infty 1 dy - \int_1^\infty 1 dy = 1", ""),
        (r"\frac{\partial}{\partial z_k} \sum_{i=0}^{k} z_i^2 = 0", ""),
        ("f(3) = z_i", ""),
    ],
)
def test_what_has_no_value_is_not_equal(latex: str, more: str) -> None:
    assert _verdict("identity", latex, more) != "proved"


@pytest.mark.parametrize("relation", ["< 1", r"\neq 1"])
def test_infinity_is_no_number(relation: str) -> None:
    assert _verdict("inequality", rf"\int_0^\infty e^{{-y}} dy {relation}") != "proved"


@pytest.mark.parametrize(
    ("latex", "more"),
    [
        (r"\tan(x) \cos(x) = \sin(x)", ""),
        (r"\frac{1 - e^{-p}}{1 - e^{-p}} = 1", ""),
        (r"\frac{1 - \cos(p x)}{p} + \frac{\cos(p x)}{p} = \frac{1}{p}", ""),
    ],
)
def test_true_identities_of_functions_are_proved(latex: str, more: str) -> None:
    assert _verdict("identity", latex, more) == "proved"


@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("equivalence", r"\sqrt{x} = -1 \Leftrightarrow x = -5"),
        ("equivalence", r"\frac{1}{x} = 0 \Leftrightarrow x = 0"),
        ("equivalence", r"\frac{1}{x y} = 0 \Leftrightarrow x y = 0"),
        ("equivalence", r"\frac{x}{x} = 1 \Leftrightarrow x^2 \geq 0"),
        ("implication", r"x^2 = 4 \Rightarrow \sqrt{x} = \sqrt{2}"),
        further("implication", r"x^2 = y^2 \Rightarrow \sqrt{x} \sqrt{x} = \sqrt{x^2}"),
    ],
)
def test_a_side_without_value_follows_from_nothing(kind: str, latex: str) -> None:
    assert _verdict(kind, latex) != "proved"


@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("equivalence", r"y = \frac{1}{x} \Leftrightarrow x y = 1"),
        ("implication", r"x y = 1 \Rightarrow y = \frac{1}{x}"),
        ("implication", r"y = \frac{1}{x} \Rightarrow x y = 1"),
    ],
)
def test_true_implications_are_proved(kind: str, latex: str) -> None:
    assert _verdict(kind, latex) == "proved"


@pytest.mark.parametrize(
    ("latex", "more"),
    [
        (r"x \approx 0.5", "given = ['x = 1/2', 'y = 1']\ndomain = 'y < 0'"),
        (r"p \approx 0.5", "given = ['p = 1/2', 'q = -1']"),
        (r"n \approx 0.5", "given = ['n = 1/2']"),
    ],
)
def test_a_number_under_hypotheses_that_nothing_satisfies(latex: str, more: str) -> None:
    assert _verdict("value", latex, more) != "proved"


@pytest.mark.parametrize(
    ("latex", "more"),
    [
        (r"x + y \to y \quad (x \to 0)", "given = ['y = x']"),
        (r"r^2 \to \infty \quad (r \to \infty)", ""),
        (r"k^2 \to \infty \quad (k \to -\infty)", ""),
        (r"r \to p \quad (r \to p)", "given = ['p > 1']"),
        (r"\lim_{n \to 1/2} n = 1/2", ""),
        (r"\left(-\frac{1}{2}\right)^x \to 0 \quad (x \to \infty)", ""),
        (r"x + \frac{1}{y} - \frac{1}{y} \to 0 \quad (x \to 0)", "domain = '-1 < y < 1'"),
        (r"0 \cdot \frac{1}{y} + x \to 0 \quad (x \to 0)", "domain = '-1 < y < 1'"),
    ],
)
def test_no_limit_outside_a_domain_or_without_values(latex: str, more: str) -> None:
    assert _verdict("limit", latex, more) != "proved"


@pytest.mark.parametrize(
    ("latex", "more"),
    [
        (r"r^2 \to 1 \quad (r \to 1)", ""),
        (r"\left(-\frac{1}{2}\right)^n \to 0 \quad (n \to \infty)", ""),
        (r"x + \frac{1}{y} - \frac{1}{y} \to 0 \quad (x \to 0)", "domain = 'y > 0'"),
    ],
)
def test_true_limits_are_proved(latex: str, more: str) -> None:
    assert _verdict("limit", latex, more) == "proved"
