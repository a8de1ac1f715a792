"""What a slash may divide by: `a/bc` is (a/b)c or a/(bc), and a reader who guesses is wrong half of
the time.
"""

from __future__ import annotations

from typing import NamedTuple

from lark import Token, Tree

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_SLASHES


class Part(NamedTuple):
    """A factor with the way it joins what stands before: `first`, `juxtaposed`, `dotted` or
    `divided`; `place` is where the operator or the factor begins.
    """

    operator: str
    place: int
    factor: Tree[Token]


def product_parts(tree: Tree[Token], text: str) -> list[Part]:
    """The factors of a flat product in order. ReaderError where the print is open to another
    reading.
    """
    parts: list[Part] = []
    slashes = 0
    for child in tree.children:
        assert isinstance(child, Tree)
        if not parts:
            parts.append(Part("first", child.meta.start_pos, child))
            continue
        factor = child.children[-1]
        assert isinstance(factor, Tree)
        if child.data == "juxtaposed":
            _refuse_digits(parts[-1].factor, factor, text)
        slashes += child.data == "divided"
        if slashes > MOST_SLASHES:
            problem = f"more than {MOST_SLASHES} slashes in one product"
            raise ReaderError(problem, text, child.meta.start_pos, "/")
        parts.append(Part(str(child.data), child.meta.start_pos, factor))
    return parts


def _refuse_digits(before: Tree[Token], factor: Tree[Token], text: str) -> None:
    """A number right after a factor may be part of an exponent or of a longer number in print, and
    a number right before a fraction of numbers is a mixed number to some.
    """
    base = factor.children[0] if factor.data == "raised" else factor
    if _is_number(base):
        problem = "a number right after a factor: brace an exponent or write a dot"
        raise ReaderError(problem, text, factor.meta.start_pos, text[factor.meta.start_pos])
    parts = base.children[1:] if isinstance(base, Tree) and base.data == "fraction" else []
    if _is_number(before) and parts and all(map(_is_number, parts)):
        problem = "a number before a fraction of numbers: write a dot for a product, + for a sum"
        raise ReaderError(problem, text, factor.meta.start_pos, "\\frac")


def _is_number(tree: object) -> bool:
    """Whether it is a number, in braces or not."""
    while isinstance(tree, Tree) and tree.data in ("braced", "group", "sum", "product"):
        inner = [child for child in tree.children if isinstance(child, Tree)]
        if len(inner) != 1 or _is_bracketed(tree):
            return False
        tree = inner[0]
    return isinstance(tree, Tree) and tree.data == "number"


def _is_bracketed(tree: Tree[Token]) -> bool:
    first = tree.children[0]
    return isinstance(first, Token) and first.type == "OPEN"


def refuse_open_slash(tree: Tree[Token], text: str) -> None:
    """A slash in a product before a sum or a derivative: whether that stands under it too, nobody
    can tell.
    """
    product = tree.children[0]
    assert isinstance(product, Tree)
    for part in product_parts(product, text):
        if part.operator == "divided":
            problem = "a slash before a sum or a derivative: write \\frac or brackets"
            raise ReaderError(problem, text, part.place, "/")


def factors_under(tree: Tree[Token], text: str) -> dict[int, tuple[int, ...]]:
    """For each ambiguous slash of this product, by position, the numbers of factors that may stand
    under it.

    They are the first factor, the factors that follow it without a dot, and all factors up to the
    next slash.
    """
    parts = product_parts(tree, text)
    found: dict[int, tuple[int, ...]] = {}
    for number, part in enumerate(parts):
        if part.operator != "divided":
            continue
        end = number + 1
        while end < len(parts) and parts[end].operator != "divided":
            end += 1
        close = number + 1
        while close < end and parts[close].operator == "juxtaposed":
            close += 1
        extents = tuple(sorted({1, close - number, end - number}))
        if len(extents) > 1:
            found[part.place] = extents
    return found


def extent_text(tree: Tree[Token], text: str, place: int, extent: int) -> str | None:
    """The factors that the slash at `place` of this product divides by, as printed; None if it is
    not there.
    """
    parts = product_parts(tree, text)
    for number, part in enumerate(parts):
        if part.operator == "divided" and part.place == place:
            last = parts[number + extent - 1].factor
            return " ".join(text[part.factor.meta.start_pos : last.meta.end_pos].split())
    return None
