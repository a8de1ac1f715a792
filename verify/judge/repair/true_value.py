"""What a quantity is, where a formula for it is wrong and no misprint explains it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.exact.tidy import tidied
from gainproof.verify.judge.reader.latex import graph_to_latex
from gainproof.verify.judge.repair.construct import places
from gainproof.verify.judge.scope import UndefinedSymbol

if TYPE_CHECKING:
    from gainproof.verify.judge.repair.search import Search

MOST_NODES = 60


def true_value(search: Search) -> str | None:
    """`symbol = formula` in the source's own symbols if one side of an equation is the symbol of a
    quantity and the formula is short; None for others.
    """
    formula, scope = search.formula, search.scope
    if not search.by_values or len(formula.links) != 1 or formula.links[0].operator != "=":
        return None
    link = formula.links[0]
    for side in (formula.sides[link.left], formula.sides[link.right]):
        entry = scope.setting.symbols.get(side.name) if side.kind == "symbol" else None
        if entry is None or entry.role != "quantity":
            continue
        try:
            meaning = scope.symbol(side.name)
        except (Undecided, Malformed, UndefinedSymbol):
            continue
        if not isinstance(meaning, Expr):
            continue
        value = tidied(meaning)
        tokens = scope.labels()
        names = symbols_of(value)
        known = all(tokens.get(n, n) in scope.setting.symbols for n in names)
        if value.kind == "symbol" or not known or sum(1 for _ in places(value)) > MOST_NODES:
            continue
        shown = substituted(value, {n: symbol(tokens[n]) for n in names if n in tokens})
        return f"{side.name} = {graph_to_latex(graph_of(shown))}"
    return None
