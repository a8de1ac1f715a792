"""Formulas within sentences: set where they stand, words left as they are, nothing of LaTeX run."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from gainproof.claims.source_words import Said
from gainproof.errata import errata_sheet
from gainproof.formulas.sentence_formulas import is_formula, pieces, written


def marked(sentence: str, *symbols: str) -> str:
    return written(sentence, symbols, str)


@pytest.mark.parametrize(
    ("sentence", "wanted"),
    [
        (r"at \sigma_o = 1, T = 2 the left is 5", r"at $\sigma_o = 1$, $T = 2$ the left is 5"),
        ("at c = 11/2, n = -1/2 it fails", "at $c = 11/2$, $n = -1/2$ it fails"),
        ("where c^2 n - 2 c - n is not zero", "where $c^2 n - 2 c - n$ is not zero"),
        ("at (R_i)^(1/2) = 1", "at $(R_i)^{1/2} = 1$"),
        (r"\lambda <= 12*sqrt(3) or more", r"$\lambda \leq 12 \, \sqrt{3}$ or more"),
        (r"as \epsilon -> 0, k -> infinity", r"as $\epsilon \to 0$, $k \to \infty$"),
        (r"B = \frac{1}{3} A S^{2} - A, a sum", r"$B = \frac{1}{3} A S^{2} - A$, a sum"),
        (r"\hat{x}_{k+1}: the mean; G: a gain", r"$\hat{x}_{k+1}$: the mean; $G$: a gain"),
        (r"P_{13} becomes \bar{S}_13", r"$P_{13}$ becomes $\bar{S}_{13}$"),
        ("sides of dimensions m s^-2 and s", r"sides of dimensions $\mathrm{m\,s^{-2}}$ and s"),
    ],
)
def test_formulas_are_found_to_their_ends(sentence: str, wanted: str) -> None:
    assert marked(sentence, "A", "G", "S") == wanted


@pytest.mark.parametrize(
    "sentence",
    [
        "An alpha-beta filter and/or a G-H filter w/o Q.",
        "Lines 134 to 137, (17a) to (17e), 3.5 of (14); A gain, I say, of 50% & more #1.",
        "as in kalman_filter.m and T. Koga, page 2",
    ],
)
def test_words_stay_words(sentence: str) -> None:
    assert marked(sentence, "A", "a") == sentence


def test_a_letter_is_a_symbol_where_it_is_known() -> None:
    sentence = "It depends on S; a target has a period T, A alone has none."
    wanted = "It depends on $S$; a target has a period $T$, A alone has none."
    assert marked(sentence, "S", "T", "A", "a") == wanted
    assert marked(sentence) == sentence
    assert marked("powers of dt; dts", "dt") == r"powers of $\mathit{dt}$; dts"


@pytest.mark.parametrize(
    "hostile",
    [
        r"\input{x}",
        r"\alpha_{\input{x}}",
        r"\sqrt{\write18{ls}}",
        r"\hat{$}",
        r"x^{%}",
        r"\frac{1}",
        r"x_{",
        r"\sqrt{\left(}",
        r"x^",
        r"\begin{bmatrix} \def\a{} \end{bmatrix}",
        r"x_{^^5c}",
        "(" * 400 + "x" + ")" * 400,
        r"\hat{" * 400 + "x" + "}" * 400,
    ],
)
def test_what_is_no_mathematics_is_left_as_text(hostile: str) -> None:
    assert not is_formula(hostile)
    for is_set, part in pieces(f"It is {hostile} there, r > 1."):
        if is_set:
            assert not re.search(r"input|write|def|\^\^|[%$]", part)
            assert part.count("{") == part.count("}")


def test_an_excerpt_in_latex_is_set_and_code_is_shown_as_seen() -> None:
    assert is_formula(r"G|_{s=0} = \tilde{P}(n+1)/\sigma_o^2|_{s=0} - \left\{1 + r\right\}")
    assert not is_formula(r"q = pow(dt, 3) & 1;")
    assert not is_formula("r = x")


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no LaTeX here")
def test_a_sheet_compiles(tmp_path: Path) -> None:
    """With all that is special to LaTeX in its sentences."""
    words = r"50% of $x & #1 ~^_ {a} \foo \sigma_o x_1_2^3^4 x' c^2 > 0 <b> “q” \frac{1}{2} a_b"
    claim: dict[str, Any] = {
        "id": "1",
        "place": "page_1 & 2",
        "kind": "identity",
        "latex": r"\beta = \alpha",
        "verdict": "conditional",
        "domain": r"\Lambda^2 - 2 \Lambda > 12*sqrt(3)",
        "evidence": {"method": "", "certificate": None, "witness": None},
        "repair": None,
        "convention": None,
        "reading": None,
        "undefined": [],
        "reason": words,
    }
    source: dict[str, Any] = {
        "key": "k",
        "title": words,
        "authors": ["A_B"],
        "publication": words,
        "year": 1,
    }
    quoted = Said(text=words, note=words, quoted="a_b & \\x;\n\n  {", known=frozenset("ab"))
    text = errata_sheet.sheet([{"source": source, "claims": [claim]}], [{"1": quoted}], ".tex")
    (tmp_path / "sheet.tex").write_text(text, encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "sheet.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=60)
