"""Definitions with a slash that has two readings: which is meant is chosen once for a setting, so
that no two claims use one definition in two ways.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.dimensions.formula import reading_fault
from gainproof.verify.judge.exact.work_limits import Undecided

MOST_CHOICES = 8


def with_one_reading(setting: Setting) -> Iterator[tuple[Setting, str | None]]:
    """The setting with one reading of each definition, in every way that dimensions allow, and
    words for the choices made. Raises Undecided if there are too many.
    """
    several = {
        token: _fitting(entry, setting)
        for token, entry in setting.symbols.items()
        if entry.definition is not None and len(entry.definition.readings) > 1
    }
    count = 1
    for entries in several.values():
        count *= len(entries)
    if count > MOST_CHOICES:
        raise Undecided(f"the definitions have {count} readings together: write \\frac in some")
    for chosen in product(*several.values()):
        symbols = {**setting.symbols, **dict(zip(several, (e for e, _ in chosen), strict=True))}
        words = "; ".join(f"{t}: {text}" for t, (_, text) in zip(several, chosen, strict=True))
        yield (replace(setting, symbols=symbols) if several else setting), words or None


def _fitting(entry: SymbolEntry, setting: Setting) -> list[tuple[SymbolEntry, str]]:
    """The entry with each reading whose dimensions agree; with all if none does."""
    assert entry.definition is not None
    readings = entry.definition.readings
    fitting = [r for r in readings if reading_fault(r, setting) is None] or list(readings)
    return [
        (
            replace(entry, definition=replace(entry.definition, readings=(reading,))),
            reading.text or f"reading {number}",
        )
        for number, reading in enumerate(fitting, start=1)
    ]
