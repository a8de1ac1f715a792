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


SPACES = frozenset(("\\,", "\\;", "\\:", "\\!", "\\ ", "\\displaystyle", "\\limits", "\\nolimits"))
WIDE_SPACES = frozenset(("\\quad", "\\qquad"))
SIZES = frozenset(
    "\\" + size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")
) | {"\\left", "\\right"}
COMMANDS = {
    "\\frac": ("FRAC", "\\frac"),
    "\\tfrac": ("FRAC", "\\frac"),
    "\\dfrac": ("FRAC", "\\frac"),
    "\\cfrac": ("FRAC", "\\frac"),
    "\\sqrt": ("SQRT", "\\sqrt"),
    "\\sum": ("SUM", "\\sum"),
    "\\partial": ("PARTIAL", "\\partial"),
    "\\infty": ("INFINITY", "\\infty"),
    "\\cdot": ("DOT", "\\cdot"),
    "\\times": ("DOT", "\\cdot"),
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
    "\\approx": ("RELATION", "approx"),
    "\\simeq": ("RELATION", "approx"),
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
    "\\\\": ("AND", "and"),
    "\\{": ("OPEN", "{"),
    "\\lbrace": ("OPEN", "{"),
    "\\}": ("CLOSE", "}"),
    "\\rbrace": ("CLOSE", "}"),
    "\\lbrack": ("OPEN", "["),
    "\\rbrack": ("CLOSE", "]"),
    "\\lvert": ("BAR_OPEN", "|"),
    "\\rvert": ("BAR_CLOSE", "|"),
}
MARKS = {
    "<=": ("RELATION", "<="),
    ">=": ("RELATION", ">="),
    "!=": ("RELATION", "!="),
    "->": ("RELATION", "->"),
    "<": ("RELATION", "<"),
    ">": ("RELATION", ">"),
    "=": ("EQUAL", "="),
    "+": ("PLUS", "+"),
    "-": ("MINUS", "-"),
    "*": ("DOT", "\\cdot"),
    "/": ("SLASH", "/"),
    "^": ("POWER", "^"),
    ",": ("COMMA", ","),
    "(": ("OPEN", "("),
    ")": ("CLOSE", ")"),
    "[": ("OPEN", "["),
    "]": ("CLOSE", "]"),
    "{": ("LEFT_BRACE", "{"),
    "}": ("RIGHT_BRACE", "}"),
}
"""One or two characters; the longer is tried first."""

TAKES_ARGUMENTS = {
    "FRAC": 2,
    "FRAC_PARTIAL": 2,
    "PARTIAL_OPERATOR": 2,
    "SQRT": 1,
    "POWER": 1,
    "UNDER": 1,
}
"""How many arguments follow a token of this kind."""
