"""What a slash may divide by: `a/bc` is (a/b)c or a/(bc), and a reader who guesses is wrong half of
the time. Likewise what a bar `|_{x=0}` behind several factors applies to.

Factors that may not stand side by side, since some would read them as one thing, are refused.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from lark import Token, Tree

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_SLASHES
from gainproof.verify.judge.reader.syntax_tree import Branch, first_token, start


@dataclass(frozen=True)
class Part:
    """A factor with the way it joins what stands before: `first`, `juxtaposed`, `dotted`, `starred`
    (the dot of plain text, which ends what a slash divides by), `divided` or `crossed`; `place` is
    where the operator or the factor begins; `bars` are the evaluations printed behind it;
    `entrywise` says that it is joined by `.*` or `./`.
    """

    operator: str
    place: int
    factor: Branch
    bars: tuple[Branch, ...] = ()
    entrywise: bool = False


def product_parts(tree: Branch, text: str) -> list[Part]:
    """The factors of a flat product in order. ReaderError where the print is open to another
    reading.
    """
    parts: list[Part] = []
    slashes = 0
    for child in tree.children:
        assert isinstance(child, Tree)
        if not parts:
            parts.append(Part("first", start(child), child))
            continue
        if child.data == "evaluated":
            parts[-1] = replace(parts[-1], bars=(*parts[-1].bars, child))
            continue
        factor = child.children[-1]
        assert isinstance(factor, Tree)
        if child.data == "juxtaposed":
            refuse_neighbours(parts[-1].factor, factor, text)
        slashes += child.data == "divided"
        if slashes > MOST_SLASHES:
            problem = f"more than {MOST_SLASHES} slashes in one product"
            raise ReaderError(problem, text, start(child), "/")
        starred = child.data == "dotted" and child.children[0] in ("*", ".*")
        operator = "starred" if starred else str(child.data)
        entrywise = child.children[0] in (".*", "./")
        parts.append(Part(operator, start(child), factor, entrywise=entrywise))
    operators = {part.operator for part in parts[1:]}
    if "crossed" in operators and len(operators) > 1:
        crossed = next(part for part in parts if part.operator == "crossed")
        problem = "a Kronecker product beside other factors: write brackets"
        raise ReaderError(problem, text, crossed.place, "\\otimes")
    for part in parts[1:-1]:
        if part.bars:
            problem = "a bar amid a product: write brackets round what it applies to"
            raise ReaderError(problem, text, start(part.bars[0]), "|")
    return parts


def refuse_open_slash(tree: Branch, text: str) -> None:
    """A slash in a product before a sum or a derivative: whether that stands under it too, nobody
    can tell.
    """
    product = tree.children[0]
    assert isinstance(product, Tree)
    for part in product_parts(product, text):
        if part.operator == "divided":
            problem = "a slash before a sum or a derivative: write \\frac or brackets"
            raise ReaderError(problem, text, part.place, "/")


def factors_under(tree: Branch, text: str) -> dict[int, tuple[int, ...]]:
    """For each ambiguous slash of this product, by position, the numbers of factors that may stand
    under it; for each ambiguous bar those of the factors it may apply to.

    Under a slash they are the first factor, the factors that follow it without a dot, and all
    factors up to the next slash; before a bar the last factor, and all.
    """
    parts = product_parts(tree, text)
    found: dict[int, tuple[int, ...]] = {}
    for number, part in enumerate(parts):
        if number and part.bars:
            found.update({start(bar): (1, len(parts)) for bar in part.bars})
        if part.operator != "divided":
            continue
        end = number + 1
        while end < len(parts) and parts[end].operator not in ("divided", "starred"):
            end += 1
        close = number + 1
        while close < end and parts[close].operator == "juxtaposed":
            close += 1
        extents = tuple(sorted({1, close - number, end - number}))
        if len(extents) > 1:
            found[part.place] = extents
    return found


def extent_text(tree: Branch, text: str, place: int, extent: int) -> str | None:
    """Words for what the slash at `place` of this product divides by, or the bar there applies to;
    None if neither is there.
    """
    parts = product_parts(tree, text)
    for number, part in enumerate(parts):
        if part.operator == "divided" and part.place == place:
            last = parts[number + extent - 1].factor
            shown = " ".join(text[start(part.factor) : last.meta.end_pos].split())
            return f"the slash of column {_column(text, place)} divides by {shown}"
        if any(start(bar) == place for bar in part.bars):
            first = parts[number + 1 - extent].factor
            shown = " ".join(text[start(first) : part.factor.meta.end_pos].split())
            return f"the bar of column {_column(text, place)} applies to {shown}"
    return None


def _column(text: str, place: int) -> int:
    return place - text.rfind("\n", 0, place)


def extents_of(tree: Branch, text: str) -> dict[int, tuple[int, ...]]:
    """Every ambiguous slash and bar below `tree` by position, with what it may extend over."""
    found: dict[int, tuple[int, ...]] = {}
    for branch in tree.iter_subtrees():
        if branch.data == "product":
            found.update(factors_under(branch, text))
        elif branch.data == "times_big":
            refuse_open_slash(branch, text)
    return found


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
