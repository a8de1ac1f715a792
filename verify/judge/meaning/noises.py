"""The symbols of a table that are noises: which of them an expectation is about."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.sequences import indexed
from gainproof.verify.judge.meaning.value import Value, entries

Noises = dict[str, SymbolEntry]


def noises_in(value: Value, symbols: Mapping[str, SymbolEntry]) -> Noises:
    """The noises that a value holds, by token. Raises Undecided where two of them, such as v_k and
    v_j, may be one.
    """
    names = symbols_of(*entries(value))
    found = {
        token: entry
        for token, entry in symbols.items()
        if entry.variance is not None and free_name(token) in names
    }
    bases: dict[str, str | None] = {}
    for token in found:
        term = indexed(token)
        if term is not None and bases.setdefault(term.stem, term.base) != term.base:
            raise Undecided(f"{token} and another noise with another index, which may be the same")
    return found


def holds_noise(outside: Iterable[Expr], symbols: Mapping[str, SymbolEntry]) -> bool:
    """Whether an expression holds a noise."""
    names = symbols_of(*outside)
    return any(e.variance is not None and free_name(t) in names for t, e in symbols.items())


def refuse_bound(noises: Iterable[str], bindings: Bindings) -> None:
    """Raises Undecided for a noise that is an argument or an index here."""
    for token in noises:
        if token in bindings.names:
            raise Undecided(f"{token} is a noise, and bound where its expectation is taken")
