"""Lines of kernels' docstrings, formulas and words mixed, with their formulas as mathematics.

Each sign is set by itself and nothing is regrouped: a slash stays a slash, parentheses stay but for
those of a root and of an exponent, which its bar and its height replace. So what is shown can mean
nothing else than what is written.
"""

from __future__ import annotations

import re
from itertools import groupby

from markupsafe import Markup, escape

from gainproof.book.mathematics import inline
from gainproof.formulas.formula_latex import symbol_latex

_GREEK = frozenset(
    {
        *("alpha", "beta", "gamma", "delta", "epsilon", "eta", "theta", "kappa", "lambda", "mu"),
        *("nu", "xi", "pi", "rho", "sigma", "tau", "phi", "psi", "omega", "chi"),
        *("Gamma", "Delta", "Lambda", "Sigma", "Phi", "Psi", "Omega"),
    }
)
_FUNCTIONS = frozenset({"sin", "cos", "tan", "exp", "log", "atan2", "hypot", "expm1", "cbrt"})
_JUXTAPOSED = re.compile(r"(?<=[\w)\]}']) +(?=[\w(\[|])")
_FACTOR = "\N{INVISIBLE TIMES}"
"""Between factors: LaTeX sets no space where one is written, so that two words would be one."""
_SIGNS = {
    "<=": r"\leq ",
    ">=": r"\geq ",
    "->": r"\to ",
    "+-": r"\pm ",
    "-+": r"\mp ",
    "**": "^",
    "*": r"\cdot ",
    "{": r"\{",
    "}": r"\}",
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "$": r"\$",
    "~": r"\sim ",
    _FACTOR: r"\,",
}
_WORD = re.compile(r"[(\"]*(?:[A-Za-z][A-Za-z]+(?:[-'][A-Za-z]+)*)[')\",.:;?]*")
_PIECE = re.compile(
    r"(?P<name>[A-Za-z]\w*)|(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
    r"|(?P<sign><=|>=|->|\+-|-\+|\*\*|.)"
)
_POWER = re.compile(r"\^(-?\w+|\\mathrm\{\w+\})")
_INDEXED = re.compile(r"([a-zA-Z]+)_([A-Za-z]|\d+)|([A-Zabce-z])(\d+)")
"""`sigma_v`, `predicted_11`, `U11`; d1 stays, which may be an operator as well as an entry."""
_OPERATORS = frozenset({"=", "+", "-", "*", "<", ">", "<=", ">="})
_ENDING = ",.:;"


def set_line(text: str) -> Markup:
    """A line of words and formulas, the formulas set within it."""
    tokens = text.split(" ")
    parts = groupby(zip(tokens, _are_words(tokens), strict=True), key=lambda pair: pair[1])
    found = []
    for are_words, group in parts:
        part = " ".join(token for token, _ in group)
        found.append(coded(part) if are_words else _formula(part))
    return Markup(" ").join(found)


def _are_words(tokens: list[str]) -> list[bool]:
    """Whether each is a word of the sentence. A word beside a sign of a formula, or within
    parentheses that a formula opened, is a name in it; `a` before a word is an article.
    """
    found: list[bool] = []
    depth = 0
    for place, token in enumerate(tokens):
        before = tokens[place - 1] if place else ""
        after = tokens[place + 1] if place + 1 < len(tokens) else ""
        if token in ("a", "A") and _is_word(after) and before not in _OPERATORS:
            is_word = depth == 0
        else:
            beside = before in _OPERATORS or after in _OPERATORS
            is_word = _is_word(token) and ("`" in token or not (depth or beside))
        if not is_word:
            depth = max(0, depth + token.count("(") - token.count(")"))
        found.append(is_word)
    return found


def _is_word(token: str) -> bool:
    if "`" in token:
        return True
    if not _WORD.fullmatch(token):
        return False
    bare = token.strip("('\"),.:;?")
    return bare not in _GREEK and bare not in _FUNCTIONS and bare != "sqrt"


def coded(text: str) -> Markup:
    """Words as they are; what stands between backticks as code."""
    return Markup().join(
        Markup("<code>{}</code>").format(part) if place % 2 else escape(part)
        for place, part in enumerate(text.split("`"))
    )


def _formula(text: str) -> Markup:
    bare = text.rstrip(_ENDING)
    if not bare or not _balanced(bare):
        return coded(text)
    return inline(latex(bare)) + escape(text[len(bare) :])


def _balanced(text: str) -> bool:
    """Whether each parenthesis has its other: a root over half a pair would say something else."""
    depth = 0
    for sign in text:
        depth += (sign == "(") - (sign == ")")
        if depth < 0:
            return False
    return depth == 0


def latex(text: str) -> str:
    """A formula in plain letters, its parentheses in pairs, as LaTeX, sign by sign."""
    pieces = _PIECE.finditer(_JUXTAPOSED.sub(_FACTOR, text))
    return _POWER.sub(r"^{\1}", _rooted("".join(map(_written, pieces))))


def _written(piece: re.Match[str]) -> str:
    name, number, sign = piece["name"], piece["number"], piece["sign"]
    if number is not None:
        return number
    if sign is not None:
        return _SIGNS.get(sign, sign)
    if name == "sqrt":
        return r"\sqrt"
    if name in _FUNCTIONS:
        return rf"\mathrm{{{name}}}"
    indexed = _INDEXED.fullmatch(name)
    if indexed is None:
        return _letters(name)
    return f"{_letters(indexed[1] or indexed[3])}_{{{indexed[2] or indexed[4]}}}"


def _letters(name: str) -> str:
    return rf"\{name}" if name in _GREEK else symbol_latex(name, {})


def _rooted(text: str) -> str:
    r"""`\sqrt(...)` as a root with its bar over what its parentheses hold; `^(...)` raised."""
    for opening in (r"\sqrt(", "^("):
        while (start := text.find(opening)) >= 0:
            first = start + len(opening)
            end, depth = first, 1
            while depth:
                depth += (text[end] == "(") - (text[end] == ")")
                end += 1
            text = f"{text[: first - 1]}{{{text[first : end - 1]}}}{text[end:]}"
    return text
