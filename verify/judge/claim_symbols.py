"""Which symbols a claim speaks of, through definitions too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry
from gainproof.verify.judge.formula import Formula, Graph, Relation


def names_in(graph: Graph) -> set[str]:
    """Names of symbols and functions in a graph."""
    named = [n for n in graph["nodes"] if n[0] in ("symbol", "call", "derivative", "at")]
    return {str(n[2] if n[0] in ("derivative", "at") else n[1]) for n in named}


def graphs_of_claim(claim: Claim) -> Iterator[Graph]:
    """Every graph of a claim: its formula in all readings, domain, hypotheses, other fields."""
    own = claim.own.values()
    for formula in (claim.formula, *(f for each in own for f in each.formulas), *claim.given):
        if formula is not None:
            yield from _graphs(formula)
    for relation in claim.domain:
        yield from (relation.left, relation.right)
    for each in own:
        yield from each.expressions


def _graphs(formula: Formula) -> Iterator[Graph]:
    for reading in formula.readings:
        yield from _sides((*reading.relations, *reading.conditions))


def _sides(relations: tuple[Relation, ...]) -> Iterator[Graph]:
    for relation in relations:
        yield from (relation.left, relation.right)


def reached(claim: Claim, setting: Setting) -> frozenset[str]:
    """Declared symbols that the claim uses, or a definition or domain of one that it uses."""
    return closure(used(claim, setting), setting.symbols)


def used(claim: Claim, setting: Setting) -> set[str]:
    """Names that stand in the claim itself, or in the equations of a filter that it names."""
    own = claim.own.values()
    texts = {*claim.held, *(token for each in own for token in each.symbols)}
    texts |= {name for graph in graphs_of_claim(claim) for name in names_in(graph)}
    for name in (name for each in own for name in each.filters):
        for formula in setting.filters.get(name, ()):
            texts |= {token for graph in _graphs(formula) for token in names_in(graph)}
    return texts


def named_by(setting: Setting) -> set[str]:
    """Names in the matrices of a setting and in the equations of its filters."""
    own = setting.own_model
    matrices = [*setting.gain_matrices.values()]
    if own is not None:
        matrices += [own.transition, own.process_noise, own.measurement, own.measurement_noise]
    graphs = [entry for rows in matrices for row in rows for entry in row]
    for formulas in setting.filters.values():
        graphs += [graph for formula in formulas for graph in _graphs(formula)]
    return {name for graph in graphs for name in names_in(graph)}


def closure(names: set[str], symbols: Mapping[str, SymbolEntry]) -> frozenset[str]:
    """The names that are declared, with all that their definitions and domains use."""
    found: set[str] = set()
    waiting = [name for name in names if name in symbols]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        found.add(name)
        entry = symbols[name]
        graphs = list(_sides(entry.domain))
        if entry.definition is not None:
            graphs += _graphs(entry.definition)
        for graph in graphs:
            waiting += [n for n in names_in(graph) if n in symbols and n not in found]
    return frozenset(found)
