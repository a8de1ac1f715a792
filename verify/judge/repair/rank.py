"""Of formulas changed by the same weight, which comes first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.expression import Expr, symbols_of, walk
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Malformed
from gainproof.verify.judge.repair.construct import places
from gainproof.verify.judge.repair.edit import LARGE
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.trivial import sorted_key
from gainproof.verify.judge.repair.whole import OF_SIDES, Change


def parts_of_source(claims: Iterable[Claim], setting: Setting) -> frozenset[bytes]:
    """Keys of everything that other claims and definitions of the source print, single symbols
    apart.
    """
    found: set[bytes] = set()
    formulas = [claim.formula for claim in claims]
    formulas += [entry.definition for entry in setting.symbols.values()]
    for formula in formulas:
        for reading in () if formula is None else formula.readings:
            for relation in (*reading.relations, *reading.conditions):
                for side in (relation.left, relation.right):
                    try:
                        found |= _parts(read_graph(side))
                    except Malformed:
                        continue
    return frozenset(found)


def _parts(*sides: Expr) -> set[bytes]:
    return {sorted_key(node) for side in sides for node in walk(side) if node.parts}


def rank(change: Change, formula: Printed, said: frozenset[bytes]) -> tuple[object, ...]:
    """Fewest places changed, then on one side, then not in what a function is taken of, then what
    the source says elsewhere too, or the formula itself twice, then the same symbols, then the
    smallest part touched and the same left sides.
    """
    before, after = formula.sides, change.printed.sides
    sides = sum(a != b for a, b in zip(before, after, strict=True))
    gained = len((_parts(*after) - _parts(*before)) & said)
    gained += _repeated(after) - _repeated(before)
    other_names = len(symbols_of(*after) ^ symbols_of(*before))
    size = abs(_size(after) - _size(before))
    touched = sum(_size((node,)) for s in change.steps if (node := s.part or s.before))
    named = sum(before[n] != after[n] for n in {link.left for link in formula.links})
    inside = _arguments(after) - _arguments(before)
    led = sum(_begins_with_minus(argument) for argument in inside)
    # a sign or a missing factor is put where the left side stays what the formula is for
    sided = change.weight == LARGE or any(step.what in OF_SIDES for step in change.steps)
    last = (named, touched) if sided else (touched, named)
    stacked = _stacked(after) - _stacked(before)
    times = sum(step.times for step in change.steps)
    return (times, sides, len(inside), led, -gained, other_names, stacked, *last, size)


def _arguments(sides: tuple[Expr, ...]) -> set[Expr]:
    """What functions are taken of."""
    return {part for node in walk(*sides) if node.kind == "call" for part in node.parts}


def _begins_with_minus(expr: Expr) -> bool:
    return expr.kind == "neg" or (expr.kind == "add" and expr.parts[0].kind == "neg")


def _repeated(sides: tuple[Expr, ...]) -> int:
    """How many composed parts stand in more than one place."""
    times = Counter(sorted_key(node) for side in sides for _, node in places(side) if node.parts)
    return sum(count > 1 for count in times.values())


def _stacked(sides: tuple[Expr, ...]) -> int:
    """How many fractions stand under a fraction bar."""
    return sum(
        node.kind == "div" and any(part.kind == "div" for part in walk(node.parts[1]))
        for side in sides
        for node in walk(side)
    )


def _size(sides: tuple[Expr, ...]) -> int:
    return sum(1 for side in sides for _ in walk(side))
