"""Random inputs for the reader and what must hold for each: only its own error comes out, and what
is read can be printed and read again. Used by the tests and by longer campaigns.
"""

from __future__ import annotations

import random

from declared import Declared

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.plain_printer import reading_to_plain
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula, read_plain

NUMBERS = (r"\alpha", r"\alpha_k", r"\beta", "k", "T", "x_{sk-1}", r"\dot{x}_{ok}", "By", "x^{-}")
MATRICES = ("A", r"\underline{x}", r"\hat{x}_k(+)")
SYMBOLS = (
    {canonical_token(token): Declared() for token in NUMBERS}
    | {canonical_token(token): Declared(shape=(2, 2)) for token in MATRICES}
    | {"S": Declared(("k", "T")), "P": Declared(("k",), (2, 2)), "i": Declared(integer=True)}
    | {name: Declared() for name in ("b_i", "b_1", "b_2", "b_k")}
)
# soups are made of these, and formulas are broken with them
PIECES = (
    *SYMBOLS,
    *("\\frac", "\\tfrac", "\\sqrt", "\\sqrt[3]", "\\left(", "\\right)", "\\left|", "\\right|"),
    *("\\{", "\\}", "\\cdot", "\\times", "\\leq", "\\to", "\\infty", "\\quad", "\\partial"),
    *("\\text{and}", "\\sum_{k=0}^", "\\frac{\\partial}", "\\dot", "\\ddot", "\\hat", "\\big("),
    *("\\begin{aligned}", "\\end{aligned}", "\\\\", "&", "\\Leftrightarrow", "\\Rightarrow"),
    *("\\lvert", "\\rvert", "_", "_{", "^", "^{", "^{-1}", "0", "1", "2", "12", "0.5", "9999"),
    *("a", "y", "and", " ", "\n", "\\", "\u03b1", "\u200b", "\x00", "\U0001f600", "\uff11"),
    *("\u0430", "\U0001d6fc", "\u2264", "\u2212", "\ud800", "\u0301"),
    *("\\begin{pmatrix}", "\\end{pmatrix}", "\\begin{array}{cc}", "\\end{array}", "\\otimes"),
    *("^T", "^{-\\top}", "^{\\mathsf{T}}", "(+)", "(-)", "(k)", "|_{k=0}", "\\Big|_{", "\\left."),
    *("\\int_0^T", "\\mathrm{d}k", "dk", "d", "\\frac{d k}{d T}", "\\lim_{k \\to 0}", "\\prod"),
    *("\\sin", "\\cos^2", "\\exp(", "\\operatorname{tr}", "e^", "E[", "O(", "\\over", "\\pm"),
    *("\\tag{1}", "\\quad(16a)", "\\text{ as }", "0+", "{+}", "\\cdots", "\\ ", "\\propto"),
    *("sqrt(", "transpose(", "sum(k, k, 0, 1)", "[k; T]", "at(", "inf", "<=>", "**", "alpha_k"),
    *"()[]{}+-*/=<>,.'|~!#$%\";:?@`",
)
# exchanging one for another of the same class mostly leaves a formula
CLASSES = (
    ("\\alpha", "k", "T", "By", "2", "0.5", "x_{sk-1}", "S(k,T)", "\\frac12", "(k+1)", "\\sin k"),
    ("A", "\\underline{x}", "A^T", "A^{-1}", "P(k)", "\\begin{pmatrix}k & T\\end{pmatrix}"),
    ("+", "-", "\\cdot", "/", " "),
    ("=", "<", "\\leq", "\\to", "= T =", "\\approx", "\\sim"),
)
FORMULAS = (
    r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)} \quad (1 \leq k)",
    r"\left( \alpha + \frac{\beta}{2} \right)^2 = 2\beta",
    r"\dot{x}_{ok} = x_{sk-1} + \beta / T \cdot (\alpha - k) = -\sqrt[3]{\alpha}",
    r"S(k,T) = \sum_{k=0}^k \{\alpha - (\beta kT + 1)\}^2, \frac{\partial}{\partial k} S(k,T) = 0",
    r"\begin{aligned}k &= T^2/2 \cdot \alpha \\ \beta &< 0.5 \end{aligned}",
    r"\hat{x}_k(+) = A P(k) A^T + E[\underline{x}\underline{x}^{\mathsf T}] \otimes A^{-1}",
    r"A = \begin{pmatrix} 1 & T \\ 0 & 1 \end{pmatrix} \left[ k \quad T^2/2 \right]^T",
    r"\lim_{k \to 0+} \frac{\sin 2k}{k} = \left. \frac{d \alpha}{d k} \right|_{k=0, T=1} + O(k^2)",
    r"\int_0^T k^2 \, dk = \prod_{k=1}^\infty e^{-k/2} \quad \text{as } T \to \infty, \tag{3}",
    r"\alpha = b_1 + b_2 + \cdots + b_k \quad (i = 0, 1, 2, \dots)",
    r"\underline{x} = (b_1, \ldots, b_k)^T, \beta = (b_i)_{i=1}^2 \quad (i = 1, \dots, k)",
)
PLAIN_FORMULAS = (
    "alpha^2/(2 - alpha) = beta and sqrt(k) < T",
    "A = [1, T; 0, 1] transpose(hat{x}_k(+)) + inverse(P(k))",
    "at(alpha/k, k, 0) = sum(k^2, k, 0, inf) if k -> 0 and k > 0",
)


def random_text(source: random.Random) -> str:
    """A soup of pieces, a formula broken in a few places, or one with parts exchanged for their
    like.
    """
    kind = source.randrange(3)
    if kind == 0:
        return "".join(source.choice(PIECES) for _ in range(source.randrange(40)))
    text = source.choice((*FORMULAS, *PLAIN_FORMULAS))
    for _ in range(source.randrange(1, 4)):
        if kind == 1:
            start = source.randrange(len(text) + 1)
            end = min(len(text), start + source.choice((0, 0, 1, 1, 2, 8)))
            text = text[:start] + source.choice((*PIECES, "", "")) + text[end:]
        else:
            like = source.choice(CLASSES)
            text = text.replace(source.choice(like), source.choice(like), source.randrange(3))
    return text


def read_or_refuse(text: str, plain: bool = False) -> Formula | ReaderError:
    """What the reader makes of it; anything else it may raise comes out."""
    try:
        return read_plain(text, SYMBOLS) if plain else read_formula(text, SYMBOLS)
    except ReaderError as error:
        return error


def check_input(text: str, plain: bool = False) -> bool:
    """Whether the text is read. AssertionError if an error names no place, or if what was read is
    not read again from its print; any other exception is the reader's fault.
    """
    result = read_or_refuse(text, plain)
    if isinstance(result, ReaderError):
        assert 1 <= result.line <= text.count("\n") + 1, text
        assert result.column >= 1, text
        assert str(result).isprintable() or "\n" in str(result), text
        return False
    for reading in result.readings[:2]:
        for again in (
            read_formula(reading_to_latex(reading), SYMBOLS),
            read_plain(reading_to_plain(reading), SYMBOLS),
        ):
            (found,) = again.readings
            assert found.relations == reading.relations, text
            assert found.conditions == reading.conditions, text
            assert found.connective == reading.connective, text
    return True
