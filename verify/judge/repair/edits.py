"""What a misprint may do to one node of a printed formula."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr

SLIGHT, PLAIN, LARGE = 1, 2, 3
"""Weights: a sign, an operator, a bracket, an index; a symbol, an exponent, a factor, a number;
something put in or left out.
"""
SYMBOL, SYMBOL_EVERYWHERE = "a symbol", "a symbol everywhere"
SQUARE, ROOT = "a deviation that is a variance", "a variance that is a deviation"
OF_SYMBOLS = frozenset((SYMBOL, SYMBOL_EVERYWHERE, SQUARE, ROOT))
"""Changes that put something else for a symbol."""


@dataclass(frozen=True, slots=True)
class Edit:
    """`new` stands where a node stood; `what` says in words what was changed, `part` in which part
    of the node, if not in all of it.
    """

    new: Expr
    weight: int
    what: str
    part: Expr | None = None


@dataclass(frozen=True)
class Table:
    """What may be put for a symbol: the symbols of the source, those that differ from a symbol in
    an index only, and pairs of the same unit.
    """

    symbols: tuple[str, ...] = ()
    siblings: frozenset[tuple[str, str]] = frozenset()
    alike: frozenset[tuple[str, str]] = frozenset()


Edits = Callable[[Expr, Table], Iterator[Edit]]
