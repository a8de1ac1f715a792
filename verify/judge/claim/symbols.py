"""The symbol tables of a claim file: definitions in terms of one another, no circle, no shadow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from gainproof.verify.judge.claim.declarations import Declaration
from gainproof.verify.judge.claim.errors import FileText
from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.reader import read_conditions, read_expression, read_formula

MOST_DEEP = 50
"""Definitions inside one another; each is resolved inside the one that uses it."""


@dataclass(frozen=True)
class SymbolTable:
    """All symbols; the `unsound` are those with errors, and those that rest on such."""

    symbols: Mapping[str, SymbolEntry] = field(default_factory=dict)
    unsound: frozenset[str] = frozenset()

    @property
    def sound(self) -> dict[str, SymbolEntry]:
        """Those that can be judged with."""
        return {name: one for name, one in self.symbols.items() if name not in self.unsound}


NO_SYMBOLS = SymbolTable()


def complete_symbols(
    text: FileText,
    declarations: Mapping[str, Declaration],
    shared: SymbolTable = NO_SYMBOLS,
    usual: Mapping[str, SymbolEntry] = MappingProxyType({}),
) -> SymbolTable:
    """The `shared` entries, those declared and the `usual` ones beside them; definitions and
    domains may use all of them. Errors are noted.
    """
    known = {**usual, **shared.symbols}
    bare = {**known, **{name: item.entry for name, item in declarations.items()}}
    complete = dict(known)
    unsound = set(shared.unsound)
    for name, declaration in declarations.items():
        noted = text.noted
        complete[name] = _completed(text, declaration, bare, name in shared.symbols)
        if declaration.broken or text.noted > noted:
            unsound.add(name)
    while circle := find_circle(complete):
        where = declarations[circle[0]]
        problem = f"definitions go in a circle: {' -> '.join(circle)}"
        text.note(text.error(where.where, problem, where.line))
        complete |= {one: replace(complete[one], definition=None) for one in circle}
        unsound.update(circle)
    name, deep = find_deepest(complete)
    if deep > MOST_DEEP:
        where = declarations[name]
        problem = f"{deep} definitions are inside one another, but at most {MOST_DEEP} are read"
        raise text.error(where.where, problem, where.line)
    return SymbolTable(complete, _resting_on(complete, unsound) if unsound else frozenset())


def _completed(
    text: FileText, declaration: Declaration, bare: Mapping[str, SymbolEntry], is_shared: bool
) -> SymbolEntry:
    """The entry with the formulas in it. Errors are noted."""
    entry, name = declaration.entry, declaration.entry.latex
    problems = []
    for one in entry.arguments:
        if one not in bare:
            problem = f"the argument {one} is not declared"
            text.note(text.doubted(text.error(declaration.where, problem, declaration.line), one))
            return entry
    if len(set(entry.arguments)) != len(entry.arguments):
        problems.append("an argument appears twice")
    if is_shared:
        problems.append(
            f"{name} shadows the symbol of the same name in [symbols]: "
            "declare it in each setting that uses it, and not there"
        )
    for problem in problems:
        text.note(text.error(declaration.where, problem, declaration.line))
    if problems:
        return entry
    return replace(
        entry,
        definition=text.attempt(lambda: _definition(text, declaration, bare), None),
        domain=text.attempt(lambda: _domain(text, declaration, bare), ()),
        variance=text.attempt(lambda: _variance(text, declaration, bare), None),
    )


def _resting_on(symbols: Mapping[str, SymbolEntry], names: set[str]) -> frozenset[str]:
    """The names, and all symbols whose declaration mentions one of them, over any number of
    others.
    """
    mentioned = {name: _mentioned(entry) for name, entry in symbols.items()}
    found, before = set(names), 0
    while len(found) > before:
        before = len(found)
        found |= {name for name, others in mentioned.items() if others & found}
    return frozenset(found)


def _mentioned(entry: SymbolEntry) -> set[str]:
    """Names in the formulas of a declaration."""
    relations = list(entry.domain)
    for reading in entry.definition.readings if entry.definition else ():
        relations += [*reading.relations, *reading.conditions]
    graphs = [side for relation in relations for side in (relation.left, relation.right)]
    graphs += [entry.variance] if entry.variance else []
    nodes = [node for graph in graphs for node in graph["nodes"]]
    words = {part for node in nodes for part in node if isinstance(part, str)}
    return (words | set(entry.arguments)) - {entry.latex}


def _definition(
    text: FileText, declaration: Declaration, symbols: Mapping[str, SymbolEntry]
) -> Formula | None:
    if declaration.definition is None:
        return None
    entry = declaration.entry
    arguments = f"({', '.join(entry.arguments)})" if entry.arguments else ""
    head = f"{entry.latex}{arguments} = "
    where = f"{declaration.where}.definition"
    try:
        formula = read_formula(head + declaration.definition, symbols, logarithm=text.logarithm)
    except ReaderError as error:
        shifted = ReaderError(
            error.problem,
            declaration.definition,
            max(0, error.position - len(head)),
            error.token,
            error.nearest,
        )
        raise text.formula_error(
            where, declaration.definition, shifted, declaration.line
        ) from error
    relations = formula.readings[0].relations
    if len(relations) != 1 or relations[0].operator != "=" or formula.readings[0].conditions:
        raise text.error(where, "one expression without a relation is wanted", declaration.line)
    return formula


def _domain(
    text: FileText, declaration: Declaration, symbols: Mapping[str, SymbolEntry]
) -> tuple[Relation, ...]:
    if declaration.domain is None:
        return ()
    try:
        return read_conditions(declaration.domain, symbols, text.logarithm)
    except ReaderError as error:
        where = f"{declaration.where}.domain"
        raise text.formula_error(where, declaration.domain, error, declaration.line) from error


def _variance(
    text: FileText, declaration: Declaration, symbols: Mapping[str, SymbolEntry]
) -> Graph | None:
    if declaration.variance is None:
        return None
    where = f"{declaration.where}.variance"
    try:
        graph, *others = read_expression(declaration.variance, symbols, logarithm=text.logarithm)
    except ReaderError as error:
        raise text.formula_error(where, declaration.variance, error, declaration.line) from error
    if others:
        raise text.error(where, "two readings: write \\frac", declaration.line)
    return graph


def find_circle(entries: Mapping[str, SymbolEntry]) -> tuple[str, ...]:
    """Names of definitions each of which uses the next, the first again at the end; empty if there
    is no circle.
    """
    *_, last = _layers(entries)
    return _one_circle(last) if last else ()


def find_deepest(entries: Mapping[str, SymbolEntry]) -> tuple[str, int]:
    """A definition with the most others inside one another, and their number, itself counted; there
    must be no circle.
    """
    layers = list(_layers(entries))
    deepest = min(layers[-2]) if len(layers) > 1 else ""
    return deepest, len(layers) - 1


def _layers(entries: Mapping[str, SymbolEntry]) -> Iterator[dict[str, frozenset[str]]]:
    """What waits to be settled with what it uses, before and after each round of settling.

    Without recursion: a long chain of definitions is no danger here.
    """
    waiting = {name: definition_uses(entry) for name, entry in entries.items() if entry.definition}
    yield waiting
    while waiting:
        rest = {name: used for name, used in waiting.items() if used & waiting.keys()}
        yield rest
        if len(rest) == len(waiting):
            return
        waiting = rest


def definition_uses(entry: SymbolEntry) -> frozenset[str]:
    """The symbols and functions on the right of a definition, its own arguments left out."""
    used: set[str] = set()
    for reading in entry.definition.readings if entry.definition else ():
        for node in reading.relations[0].right["nodes"]:
            if node[0] in ("symbol", "call"):
                used.add(node[1])
    return frozenset(used.difference(entry.arguments))


def _one_circle(waiting: Mapping[str, frozenset[str]]) -> tuple[str, ...]:
    path = [min(waiting)]
    while path[-1] not in path[:-1]:
        path.append(min(waiting[path[-1]] & waiting.keys()))
    return tuple(path[path.index(path[-1]) :])
