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
    """The factors of a flat product in order. A number right after another factor is refused."""
    parts: list[Part] = []
    slashes = 0
    for child in tree.children:
        assert isinstance(child, Tree)
        if not parts:
            parts.append(Part("first", child.meta.start_pos, child))
            continue
        factor = child.children[-1]
        assert isinstance(factor, Tree)
        leading = factor.children[0] if factor.data == "raised" else factor
        if child.data == "juxtaposed" and isinstance(leading, Tree) and leading.data == "number":
            problem = "a number right after a factor: brace an exponent or write a dot"
            raise ReaderError(problem, text, child.meta.start_pos, str(leading.children[0]))
        slashes += child.data == "divided"
        if slashes > MOST_SLASHES:
            raise ReaderError(
                f"more than {MOST_SLASHES} slashes in one product", text, child.meta.start_pos, "/"
            )
        parts.append(Part(str(child.data), child.meta.start_pos, factor))
    return parts


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
