"""Every change of weight one to three that one misprint makes."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.repair.brackets import brackets
from gainproof.verify.judge.repair.construct import places, replaced
from gainproof.verify.judge.repair.edit import Edits, Table
from gainproof.verify.judge.repair.numbers import constants, exponents, factor_two
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.signs import operators, signs
from gainproof.verify.judge.repair.symbols import dropped, inserted, other_symbols
from gainproof.verify.judge.repair.whole import Change, Step, changes_of_whole

EDITS: tuple[Edits, ...] = (
    signs,
    operators,
    brackets,
    exponents,
    constants,
    factor_two,
    other_symbols,
    dropped,
    inserted,
)


def changes(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = 3
) -> Iterator[Change]:
    """All formulas one edit away whose edit weighs at most `most`, each once."""
    seen = {_key(formula)}
    for change in _all(formula, table, numbers):
        if change.weight <= most and _key(change.printed) not in seen:
            seen.add(_key(change.printed))
            yield change


def _all(formula: Printed, table: Table, numbers: frozenset[str]) -> Iterator[Change]:
    both = formula.connective != "if"
    chosen = range(len(formula.sides)) if both else formula.claimed()
    for n in chosen:
        side = formula.sides[n]
        for path, node in places(side):
            for edits in EDITS:
                for edit in edits(node, table):
                    new = replaced(side, path, edit.new)
                    step = Step(edit.what, node, edit.new, edit.part)
                    yield Change(formula.with_side(n, new), edit.weight, (step,))
    yield from changes_of_whole(formula, table, numbers)


def _key(formula: Printed) -> tuple[object, ...]:
    return (*[side.key for side in formula.sides], formula.links, formula.conditions)
