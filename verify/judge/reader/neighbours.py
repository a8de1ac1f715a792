"""Factors that may not stand side by side, since some would read them as one thing."""

from __future__ import annotations

from lark import Token, Tree

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tree import Branch, first_token, start


def refuse_neighbours(before: Branch, factor: Branch, text: str) -> None:
    """ReaderError for a number right after a factor, which may be part of an exponent or of a
    longer number in print, but for a power of ten right after a symbol, as in `P 10^{x/10}`; for a
    number right before a fraction of numbers, a mixed number to some; for a number alone in
    parentheses, an argument or the number of an equation to some; for parentheses after a
    derivative, which may say where; for anything right after an integral.
    """
    base = factor.children[0] if factor.data == "raised" else factor
    place = start(factor)
    if before.data in ("integral", "integral_from_above"):
        problem = "a factor right after an integral: write it before, or write brackets"
        raise ReaderError(problem, text, place, text[place])
    raised = factor.data == "raised" and before.data == "symbol"
    if _is_number(base) and not (raised and text.startswith("10^", place)):
        problem = "a number right after a factor: brace an exponent or write a dot"
        raise ReaderError(problem, text, place, text[place])
    if _is_bracketed(factor) and _is_whole_number(factor):
        problem = "a number alone in parentheses: write a dot for a product, \\tag for its number"
        raise ReaderError(problem, text, place, text[place])
    if before.data == "derivative" and isinstance(base, Tree) and _is_bracketed(base):
        problem = "parentheses after a derivative: write a dot, or |_{x=...} for a place"
        raise ReaderError(problem, text, place, text[place])
    parts = base.children[1:] if isinstance(base, Tree) and base.data == "fraction" else []
    if _is_number(before) and parts and all(map(_is_number, parts)):
        problem = "a number before a fraction of numbers: write a dot for a product, + for a sum"
        raise ReaderError(problem, text, place, "\\frac")


def _is_number(tree: object) -> bool:
    """Whether it is a number, in braces or not."""
    while isinstance(tree, Tree) and tree.data in ("braced", "group", "sum", "product"):
        inner = [child for child in tree.children if isinstance(child, Tree)]
        if len(inner) != 1 or _is_bracketed(tree):
            return False
        tree = inner[0]
    return isinstance(tree, Tree) and tree.data == "number"


def _is_bracketed(tree: Branch) -> bool:
    first = tree.children[0]
    return isinstance(first, Token) and first.type in ("OPEN", "ROW_OPEN")


def _is_whole_number(tree: Branch) -> bool:
    return _is_number(tree.children[1]) and "." not in str(first_token(tree, "NUMBER"))
