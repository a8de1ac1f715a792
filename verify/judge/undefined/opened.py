"""Equations with the definitions put in that hold an undefined symbol."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.formula import Graph, Relation
from gainproof.verify.judge.reach import closure

Change = Callable[[Expr, tuple[Expr, ...]], Expr | None]


def opened(relation: Relation, setting: Setting, token: str) -> Relation:
    """The relation in which the symbol stands wherever a definition would hide it. Definitions with
    arguments or several readings stay. Raises Malformed.
    """
    left, right = (_opened(side, setting, token) for side in (relation.left, relation.right))
    return replace(relation, left=left, right=right)


def _opened(graph: Graph, setting: Setting, token: str) -> Graph:
    known: dict[str, Expr | None] = {}

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "symbol" or node.name == token or node.name not in setting.symbols:
            return None
        if node.name not in known:
            known[node.name] = None
            known[node.name] = _meaning(node.name, setting, token, change)
        return known[node.name]

    tree = read_graph(graph)
    made = rebuilt(tree, change)
    return graph if made == tree else graph_of(made)


def _meaning(name: str, setting: Setting, token: str, change: Change) -> Expr | None:
    entry = setting.symbols[name]
    if entry.definition is None or entry.arguments or len(entry.definition.readings) != 1:
        return None
    if token not in closure({name}, setting.symbols):
        return None
    reading = entry.definition.readings[0]
    if reading.conditions:
        return None
    return rebuilt(read_graph(reading.relations[0].right), change)
