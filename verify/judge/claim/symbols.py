"""The symbol tables of a claim file: definitions in terms of one another, no circle, no shadow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from gainproof.verify.judge.claim.circles import MOST_DEEP, find_circle, find_deepest
from gainproof.verify.judge.claim.declarations import Declaration
from gainproof.verify.judge.claim.errors import FileText
from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.reader import read_conditions, read_expression, read_formula


def complete_symbols(
    text: FileText,
    declarations: Mapping[str, Declaration],
    shared: Mapping[str, SymbolEntry] = MappingProxyType({}),
) -> dict[str, SymbolEntry]:
    """The `shared` entries and those declared; definitions and domains may use all of them."""
    for name, declaration in declarations.items():
        if name in shared:
            problem = (
                f"{name} shadows the symbol of the same name in [symbols]: "
                "declare it in each setting that uses it, and not there"
            )
            raise text.error(declaration.where, problem, declaration.line)
    bare = {**shared, **{name: item.entry for name, item in declarations.items()}}
    complete = dict(shared)
    for name, declaration in declarations.items():
        entry = declaration.entry
        for argument in entry.arguments:
            if argument not in bare:
                problem = f"the argument {argument} is not declared"
                raise text.error(declaration.where, problem, declaration.line)
        if len(set(entry.arguments)) != len(entry.arguments):
            raise text.error(declaration.where, "an argument appears twice", declaration.line)
        complete[name] = replace(
            entry,
            definition=_definition(text, declaration, bare),
            domain=_domain(text, declaration, bare),
            variance=_variance(text, declaration, bare),
        )
    circle = find_circle(complete)
    if circle:
        where = declarations[circle[0]]
        problem = f"definitions go in a circle: {' -> '.join(circle)}"
        raise text.error(where.where, problem, where.line)
    name, deep = find_deepest(complete)
    if deep > MOST_DEEP:
        where = declarations[name]
        problem = f"{deep} definitions are inside one another, but at most {MOST_DEEP} are read"
        raise text.error(where.where, problem, where.line)
    return complete


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
