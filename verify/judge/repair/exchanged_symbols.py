"""Which symbols a misprint may have exchanged, and which of them number samples."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry
from gainproof.verify.judge.dimensions.formula import dimension_of
from gainproof.verify.judge.exact.expression import symbol, symbols_of
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.repair.edits import Table
from gainproof.verify.judge.repair.printed_formula import Printed

MOST_SYMBOLS = 24


def table_of(setting: Setting, formula: Printed, others: Iterable[Claim]) -> Table:
    """Symbols of the claim first, then those of the setting's other claims, then all others."""
    own = sorted(set().union(*[symbols_of(side) for side in formula.sides]))
    near = [s for claim in others if claim.formula is not None for s in claim.formula.symbols]
    names = dict.fromkeys([*own, *near, *setting.symbols])
    chosen = [n for n in names if n in setting.symbols and _is_scalar(setting.symbols[n])]
    chosen = chosen[:MOST_SYMBOLS]
    pairs = {(a, b) for a in chosen for b in chosen if a != b and _bare(a) == _bare(b)}
    units = {name: dimension_of(graph_of(symbol(name)), setting) for name in chosen}
    alike = {(a, b) for a in chosen for b in chosen if a != b and units[a] == units[b]}
    return Table(tuple(chosen), frozenset(pairs), frozenset(alike))


def _is_scalar(entry: SymbolEntry) -> bool:
    shaped = getattr(entry, "shape", None) is not None
    return entry.role != "undefined" and not entry.arguments and not shaped


def _bare(name: str) -> str:
    """The name without the shift of its index: `x_{sk-1}` and `x_{sk}` are siblings."""
    for shift in ("-1}", "+1}"):
        if name.endswith(shift):
            return name[: -len(shift)] + "}"
    return name if name.endswith("}") else _braced(name)


def _braced(name: str) -> str:
    """`\\alpha_k` as `\\alpha_{k}`."""
    base, mark, index = name.rpartition("_")
    return f"{base}_{{{index}}}" if mark else name


def sample_numbers(setting: Setting) -> frozenset[str]:
    """Symbols that count samples, and free integers."""
    return frozenset(
        token
        for token, entry in setting.symbols.items()
        if entry.quantity == "sample_number" or (entry.role == "free" and entry.integer)
    )
