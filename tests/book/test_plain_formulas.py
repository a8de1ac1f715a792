"""Formulas of docstrings as mathematics: sign by sign, nothing regrouped."""

from __future__ import annotations

import ast
import importlib
import pkgutil
import re
from collections.abc import Iterator

import pytest

from gainproof import generated
from gainproof.book.plain_formulas import latex, set_line

FORMULAS = {
    "beta = 2/(1/2 + kappa + rho)": r"\beta = 2/(1/2 + \kappa + \rho)",
    "m = sqrt(1 - 2 alpha)": r"m = \sqrt{1 - 2\,\alpha}",
    "sqrt(1 + sqrt(x y)) (2 + z)": r"\sqrt{1 + \sqrt{x\,y}}\,(2 + z)",
    "2^-1/x^2 y": r"2^{-1}/x^{2}\,y",
    "(a + b)^(1/3)": r"(a + b)^{1/3}",
    "predicted_11 = sigma_v^2": r"\mathrm{predicted}_{11} = \sigma_{v}^{2}",
    "half_sum <= 2 U12": r"\mathrm{half\_sum} \leq  2\,U_{12}",
}


@pytest.mark.parametrize("text", FORMULAS)
def test_formulas(text: str) -> None:
    assert latex(text) == FORMULAS[text]


def test_words_stay_words() -> None:
    line = set_line("all x > 0 are stable; a jerk of `gains` with 1 < 2")
    assert line.startswith("all <math")
    assert "are stable; a jerk of <code>gains</code> with <math" in line


def test_half_a_pair_of_parentheses_stays_as_it_is() -> None:
    """A root whose end stands on the next line would get its bar over too little."""
    assert set_line("x = sqrt(1 + y") == "x = sqrt(1 + y"


def test_what_is_written_cannot_be_an_element() -> None:
    assert "<script" not in set_line("x < <script>alert(1)</script> & `<b>`")


def lines() -> Iterator[str]:
    """Of all kernels, the lines of formulas."""
    for found in pkgutil.iter_modules(generated.__path__):
        module = importlib.import_module(f"gainproof.generated.{found.name}")
        with open(str(module.__file__), encoding="utf-8") as stream:
            tree = ast.parse(stream.read())
        for node in tree.body:
            told = ast.get_docstring(node) if isinstance(node, ast.FunctionDef) else None
            for paragraph in (told or "").split("\n\n")[1:]:
                if paragraph.startswith("    "):
                    yield from (line.strip() for line in paragraph.splitlines())


def test_every_sign_of_every_kernel_is_kept_in_its_place() -> None:
    """What the browser shows, read back without space, is the line: but for the signs that are
    replaced, which are put back here one by one.
    """
    seen = 0
    for line in lines():
        html = set_line(line)
        assert 'class="latex"' not in html, line
        notes = re.compile(r"<math.*?<annotation[^>]*>(.*?)</annotation>.*?</math>")
        shown = notes.sub(lambda match: plain(match[1]), html)
        shown = re.sub(r"</?(?:span|code)[^>]*>", "", shown)
        assert bare(shown) == bare(line)
        seen += len(notes.findall(html))
    assert seen > 400


def plain(text: str) -> str:
    """LaTeX back as plain letters; braces as the parentheses that they may have been."""
    text = text.replace(r"\_", "_").replace(r"\,", " ").replace(r"\sqrt{", "sqrt{")
    text = text.replace(r"\mathrm", "").replace(r"\cdot", "*").replace(r"\pm", "+-")
    return re.sub(r"\\([a-zA-Z]+)", r"\1", text.replace(r"\to", "->").replace(r"\mp", "-+"))


def bare(text: str) -> str:
    """Without space, pairs around roots, exponents and names, and code's backticks."""
    text = text.replace("&#39;", "'").replace("&gt;", ">").replace("&lt;", "<")
    return re.sub(
        r"[\s(){}`_]|&amp;", "", text.replace("leq", "<=").replace("geq", ">=").replace("**", "^")
    )
