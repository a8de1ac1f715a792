"""Tokens of a formula and the LaTeX commands that make them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FormulaToken:
    """`kind` is a terminal of the grammar, `value` the canonical text, `start` and `end` the place
    in the formula.
    """

    kind: str
    value: str
    start: int
    end: int


SPACES = frozenset(
    (
        *("\\,", "\\;", "\\:", "\\!", "\\>", "\\/", "\\thinspace", "\\medspace", "\\thickspace"),
        *("\\displaystyle", "\\textstyle", "\\limits", "\\nolimits", "\\nonumber", "\\notag"),
    )
)
WIDE_SPACES = frozenset(("\\quad", "\\qquad", "\\enspace", "\\hfill"))
SIZES = frozenset(
    "\\" + size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")
) | {"\\left", "\\right", "\\middle"}
NORM = "\\|"
"""The value of the bars of a norm."""
COMMANDS = {
    "\\frac": ("FRAC", "\\frac"),
    "\\tfrac": ("FRAC", "\\frac"),
    "\\dfrac": ("FRAC", "\\frac"),
    "\\cfrac": ("FRAC", "\\frac"),
    "\\over": ("OVER", "\\over"),
    "\\sqrt": ("SQRT", "\\sqrt"),
    "\\sum": ("SUM", "sum"),
    "\\prod": ("SUM", "product"),
    "\\int": ("INTEGRAL", "\\int"),
    "\\lim": ("LIM", "\\lim"),
    "\\partial": ("PARTIAL", "\\partial"),
    "\\infty": ("INFINITY", "\\infty"),
    "\\cdot": ("DOT", "\\cdot"),
    "\\times": ("DOT", "\\cdot"),
    "\\otimes": ("KRON", "\\otimes"),
    "\\lt": ("RELATION", "<"),
    "\\gt": ("RELATION", ">"),
    "\\le": ("RELATION", "<="),
    "\\leq": ("RELATION", "<="),
    "\\leqq": ("RELATION", "<="),
    "\\leqslant": ("RELATION", "<="),
    "\\ge": ("RELATION", ">="),
    "\\geq": ("RELATION", ">="),
    "\\geqq": ("RELATION", ">="),
    "\\geqslant": ("RELATION", ">="),
    "\\ne": ("RELATION", "!="),
    "\\neq": ("RELATION", "!="),
    "\\equiv": ("EQUAL", "="),
    "\\triangleq": ("EQUAL", "="),
    "\\coloneqq": ("EQUAL", "="),
    "\\approx": ("RELATION", "approx"),
    "\\simeq": ("RELATION", "approx"),
    "\\fallingdotseq": ("RELATION", "approx"),
    "\\doteq": ("RELATION", "approx"),
    "\\sim": ("RELATION", "sim"),
    "\\propto": ("RELATION", "propto"),
    "\\to": ("RELATION", "->"),
    "\\rightarrow": ("RELATION", "->"),
    "\\longrightarrow": ("RELATION", "->"),
    "\\Leftrightarrow": ("CONNECTIVE", "iff"),
    "\\Longleftrightarrow": ("CONNECTIVE", "iff"),
    "\\iff": ("CONNECTIVE", "iff"),
    "\\Rightarrow": ("CONNECTIVE", "implies"),
    "\\Longrightarrow": ("CONNECTIVE", "implies"),
    "\\implies": ("CONNECTIVE", "implies"),
    "\\land": ("AND", "and"),
    "\\wedge": ("AND", "and"),
    "\\{": ("OPEN", "{"),
    "\\lbrace": ("OPEN", "{"),
    "\\}": ("CLOSE", "}"),
    "\\rbrace": ("CLOSE", "}"),
    "\\lbrack": ("OPEN", "["),
    "\\rbrack": ("CLOSE", "]"),
    "\\cdots": ("DOTS", "\\cdots"),
    "\\ldots": ("DOTS", "\\cdots"),
    "\\dots": ("DOTS", "\\cdots"),
    "\\dotsb": ("DOTS", "\\cdots"),
    "\\dotsc": ("DOTS", "\\cdots"),
    "\\vdots": ("DOTS", "\\cdots"),
    "\\ddots": ("DOTS", "\\cdots"),
    "\\lvert": ("BAR_OPEN", "|"),
    "\\rvert": ("BAR_CLOSE", "|"),
    "\\lVert": ("BAR_OPEN", NORM),
    "\\rVert": ("BAR_CLOSE", NORM),
    "\\lfloor": ("BAR_OPEN", "floor"),
    "\\rfloor": ("BAR_CLOSE", "floor"),
    "\\lceil": ("BAR_OPEN", "ceil"),
    "\\rceil": ("BAR_CLOSE", "ceil"),
    "\\bmod": ("MOD", "mod"),
}
MARKS = {
    "<=": ("RELATION", "<="),
    ">=": ("RELATION", ">="),
    "!=": ("RELATION", "!="),
    "->": ("RELATION", "->"),
    ":=": ("EQUAL", "="),
    "<": ("RELATION", "<"),
    ">": ("RELATION", ">"),
    "=": ("EQUAL", "="),
    "+": ("PLUS", "+"),
    "-": ("MINUS", "-"),
    "*": ("DOT", "\\cdot"),
    "/": ("SLASH", "/"),
    "^": ("POWER", "^"),
    "_": ("UNDER", "_"),
    "&": ("CELL", "&"),
    ",": ("COMMA", ","),
    ";": ("COMMA", ";"),
    "(": ("OPEN", "("),
    ")": ("CLOSE", ")"),
    "[": ("OPEN", "["),
    "]": ("CLOSE", "]"),
    "{": ("LEFT_BRACE", "{"),
    "}": ("RIGHT_BRACE", "}"),
    "≤": ("RELATION", "<="),
    "≥": ("RELATION", ">="),
    "≠": ("RELATION", "!="),
    "≈": ("RELATION", "approx"),
    "→": ("RELATION", "->"),
    "⇔": ("CONNECTIVE", "iff"),
    "⇒": ("CONNECTIVE", "implies"),
}
"""One or two characters; the longer is tried first."""

NO_EXACT_MEANING = {
    "\\ll": "much less than has no exact meaning: state a limit or an inequality",
    "\\gg": "much greater than has no exact meaning: state a limit or an inequality",
    "\\lesssim": "less or about equal has no exact meaning: write \\le or \\approx",
    "\\gtrsim": "greater or about equal has no exact meaning: write \\ge or \\approx",
}
"""Commands that are known and refused, with what to write instead."""

TAKES_ARGUMENTS = {
    "FRAC": 2,
    "FRAC_PARTIAL": 2,
    "PARTIAL_OPERATOR": 2,
    "SQRT": 1,
    "POWER": 1,
    "UNDER": 1,
}
"""How many arguments follow a token of this kind."""
