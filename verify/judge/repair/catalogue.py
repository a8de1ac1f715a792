"""Every change of weight one to three that one misprint makes."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.repair.asked import asked_sides, open_places
from gainproof.verify.judge.repair.brackets import brackets
from gainproof.verify.judge.repair.construct import replaced
from gainproof.verify.judge.repair.edit import LARGE, OF_SYMBOLS, Edits, Table
from gainproof.verify.judge.repair.numbers import constants, exponents, factor_two
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.signs import operators, signs
from gainproof.verify.judge.repair.symbols import (
    dropped,
    inserted,
    other_functions,
    other_symbols,
)
from gainproof.verify.judge.repair.whole import Change, Step, changes_of_whole

EDITS: tuple[Edits, ...] = (
    signs,
    operators,
    brackets,
    exponents,
    constants,
    factor_two,
    other_symbols,
    other_functions,
    dropped,
    inserted,
)
LARGE_ONLY: tuple[Edits, ...] = (dropped, inserted)
"""Those all of whose edits are large."""


def changes(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = 3
) -> Iterator[Change]:
    """All formulas one edit away whose edit weighs at most `most`, each once."""
    seen = {_key(formula, formula)}
    for change in _all(formula, table, numbers, most):
        key = _key(change.printed, formula)
        if change.weight <= most and key not in seen:
            seen.add(key)
            yield change


def changes_of_bound(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = 3
) -> Iterator[Change]:
    """Those without another symbol: a bound of other symbols is true of many formulas, and the one
    that is meant cannot be told from those that are true by chance. An index is told.
    """
    for change in changes(formula, table, numbers, most):
        if not any(step.what in OF_SYMBOLS for step in change.steps):
            yield change


def _all(formula: Printed, table: Table, numbers: frozenset[str], most: int) -> Iterator[Change]:
    """Those that are cheap to leave out are, if they weigh more than `most`."""
    edits_of = [edits for edits in EDITS if most >= LARGE or edits not in LARGE_ONLY]
    both = formula.connective != "if"
    chosen = range(len(formula.sides)) if both else formula.claimed()
    asked = asked_sides(formula)
    for n in chosen:
        side = formula.sides[n]
        for path, node in open_places(side) if n not in asked else ():
            for edits in edits_of:
                for edit in edits(node, table):
                    if edit.weight > most:
                        continue
                    new = replaced(side, path, edit.new)
                    step = Step(edit.what, node, edit.new, edit.part)
                    yield Change(formula.with_side(n, new), edit.weight, (step,))
    yield from changes_of_whole(formula, table, numbers, most)


def _key(formula: Printed, first: Printed) -> tuple[object, ...]:
    """Equal for formulas written alike, if all are compared with the same first one."""
    sides = [side.key for side in formula.sides]
    if formula.links is first.links and formula.conditions is first.conditions:
        return tuple(sides)
    return (*sides, formula.links, formula.conditions)
