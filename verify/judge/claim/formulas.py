"""Formulas in the fields of a claim file: read, or refused with their place in the file."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.fields import Fields, nearest_hint
from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import (
    read_conditions,
    read_expression,
    read_formula,
    read_plain,
)

Symbols = Mapping[str, SymbolEntry]


def formula_of(
    fields: Fields, field: str, latex: str, symbols: Symbols, branch: str | None = None
) -> Formula:
    """The formula that `field` holds; `branch` says which signs of `\\pm` are meant."""
    try:
        return read_formula(latex, symbols, branch, fields.text.logarithm)
    except ReaderError as error:
        raise _moved(fields, field, latex, error) from error


def plain_formula_of(fields: Fields, field: str, text: str, symbols: Symbols) -> Formula:
    """The formula that `field` holds in plain text."""
    try:
        return read_plain(text, symbols, fields.text.logarithm)
    except ReaderError as error:
        raise _moved(fields, field, text, error) from error


def conditions_of(
    fields: Fields, field: str, text: str | None, symbols: Symbols
) -> tuple[Relation, ...]:
    """The relations that `field` holds, none where it is missing."""
    if text is None:
        return ()
    try:
        return read_conditions(text, symbols, fields.text.logarithm)
    except ReaderError as error:
        raise _moved(fields, field, text, error) from error


def graph_in(fields: Fields, field: str, text: str, symbols: Symbols) -> Graph:
    """The one expression, with one reading, that `field` holds."""
    try:
        graph, *others = read_expression(text, symbols, logarithm=fields.text.logarithm)
    except ReaderError as error:
        raise _moved(fields, field, text, error) from error
    if others:
        raise fields.fail(field, f"{text[:80]!r} has two readings: write \\frac")
    return graph


def token_in(fields: Fields, field: str, token: str, symbols: Symbols) -> str:
    """The canonical name of the declared symbol that `field` names."""
    try:
        name = canonical_token(token)
    except ReaderError as error:
        raise fields.fail(field, f"not a symbol: {error.problem}") from error
    if name not in symbols:
        hint = nearest_hint(name, list(symbols))
        missing = fields.fail(field, f"the symbol {name} is not declared{hint}")
        raise fields.text.doubted(missing, name)
    return name


def _moved(fields: Fields, field: str, text: str, error: ReaderError) -> ClaimFileError:
    return fields.text.formula_error(f"{fields.where}.{field}", text, error, fields.line)
