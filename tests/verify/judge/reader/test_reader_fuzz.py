"""Ten thousand random inputs: only the reader's own error comes out, each in bounded time."""

from __future__ import annotations

import random
import time
from dataclasses import dataclass

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex import reading_to_latex
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula

INPUTS = 10_000
SECONDS_EACH = 5.0


@dataclass(frozen=True)
class Declared:
    arguments: tuple[str, ...] = ()
    shape: object | None = None


SYMBOLS = {
    canonical_token(token): Declared()
    for token in (r"\alpha", r"\alpha_k", r"\beta", "k", "T", "x_{sk-1}", r"\dot{x}_{ok}", "By")
}
SYMBOLS["S"] = Declared(("k", "T"))
# soups are made of these, and formulas are broken with them
PIECES = (
    *SYMBOLS,
    *("\\frac", "\\tfrac", "\\sqrt", "\\sqrt[3]", "\\left(", "\\right)", "\\left|", "\\right|"),
    *("\\{", "\\}", "\\cdot", "\\times", "\\leq", "\\to", "\\infty", "\\quad", "\\partial"),
    *("\\text{and}", "\\sum_{k=0}^", "\\frac{\\partial}", "\\dot", "\\ddot", "\\hat", "\\big("),
    *("\\begin{aligned}", "\\end{aligned}", "\\\\", "&", "\\Leftrightarrow", "\\Rightarrow"),
    *("\\lvert", "\\rvert", "_", "_{", "^", "^{", "^{-1}", "0", "1", "2", "12", "0.5", "9999"),
    *("a", "y", "and", " ", "\n", "\\", "\u03b1", "\u200b", "\x00", "\U0001f600"),
    *"()[]{}+-*/=<>,.'|~!#$%\";:?@`",
)
# exchanging one for another of the same class mostly leaves a formula
CLASSES = (
    ("\\alpha", "k", "T", "By", "2", "0.5", "x_{sk-1}", "S(k,T)", "\\frac12", "(k+1)"),
    ("+", "-", "\\cdot", "/", " "),
    ("=", "<", "\\leq", "\\to", "= T ="),
)
FORMULAS = (
    r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)} \quad (1 \leq k)",
    r"\left( \alpha + \frac{\beta}{2} \right)^2 = 2\beta",
    r"\dot{x}_{ok} = x_{sk-1} + \beta / T \cdot (\alpha - k) = -\sqrt[3]{\alpha}",
    r"S(k,T) = \sum_{k=0}^k \{\alpha - (\beta kT + 1)\}^2, \frac{\partial}{\partial k} S(k,T) = 0",
    r"\begin{aligned}k &= T^2/2 \cdot \alpha \\ \beta &< 0.5 \end{aligned}",
)


def random_text(source: random.Random) -> str:
    """A soup of pieces, a formula broken in a few places, or one with parts exchanged for their
    like.
    """
    kind = source.randrange(3)
    if kind == 0:
        return "".join(source.choice(PIECES) for _ in range(source.randrange(40)))
    text = source.choice(FORMULAS)
    for _ in range(source.randrange(1, 4)):
        if kind == 1:
            start = source.randrange(len(text) + 1)
            end = min(len(text), start + source.choice((0, 0, 1, 1, 2, 8)))
            text = text[:start] + source.choice((*PIECES, "", "")) + text[end:]
        else:
            like = source.choice(CLASSES)
            text = text.replace(source.choice(like), source.choice(like), source.randrange(3))
    return text


def read_or_refuse(text: str) -> Formula | ReaderError:
    """What the reader makes of it, within the time."""
    start = time.perf_counter()
    result: Formula | ReaderError
    try:
        result = read_formula(text, SYMBOLS)
    except ReaderError as error:
        result = error
    assert time.perf_counter() - start < SECONDS_EACH, text[:40]
    return result


def test_only_the_own_error() -> None:
    source = random.Random(20)
    read = 0
    for _ in range(INPUTS):
        text = random_text(source)
        result = read_or_refuse(text)
        if isinstance(result, ReaderError):
            assert 1 <= result.line <= text.count("\n") + 1
            assert result.column >= 1
            continue
        read += 1
        for reading in result.readings[:2]:
            again = read_formula(reading_to_latex(reading), SYMBOLS).readings[0]
            assert again.relations == reading.relations
            assert again.conditions == reading.conditions
    # a fuzz that reads little tests the lexer only
    assert read > INPUTS // 10


def test_longest_inputs_in_bounded_time() -> None:
    hostile = (
        "k" * 3998 + "=1",
        "y" * 4000,
        "(" * 4000,
        "{" * 4000,
        r"\dot" * 1000,
        r"\dot{" * 800,
        "x_{" * 1333,
        "x_" * 2000,
        "k" + "'" * 3999,
        "k" + "+k" * 1990 + "=1",
        "k" + "=k" * 1990,
        "k" + "/k" * 1990 + "=1",
        "1" * 4000,
        "k/k k+" * 600 + "k=1",
        r"\frac" * 800,
        "k=1," * 900 + "k=1",
        "k=1" + "(k=1)" * 700,
        "-" * 4000,
        r"\sum_{k=0}^k " * 300 + "k=1",
        r"\left" * 800,
        r"\text{" * 600,
        "_" * 4000,
        "\\" * 4000,
        "\n" * 4000,
    )
    for text in hostile:
        read_or_refuse(text)
