"""Two edits at once: one on each side, matched by value, or any two, the slightest first."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.repair.catalogue import changes
from gainproof.verify.judge.repair.closings import Context
from gainproof.verify.judge.repair.edit import PLAIN, SLIGHT
from gainproof.verify.judge.repair.whole import Change


def two_changes(context: Context) -> Iterator[Change]:
    """Formulas two edits away, none of which puts something in or leaves it out."""
    yield from _on_both_sides(context)
    yield from _within(context)


def _on_both_sides(context: Context) -> Iterator[Change]:
    formula = context.formula
    if len(formula.links) != 1 or formula.links[0].operator != "=":
        return
    link = formula.links[0]
    left: dict[str, list[Change]] = {}
    right: dict[str, list[Change]] = {}
    for change in changes(formula, context.table, context.numbers, PLAIN):
        same_left = change.printed.sides[link.left] == formula.sides[link.left]
        same_right = change.printed.sides[link.right] == formula.sides[link.right]
        if context.is_late:
            return
        if same_right and not same_left:
            left.setdefault(_value(context, change, link.left), []).append(change)
        elif same_left and not same_right:
            right.setdefault(_value(context, change, link.right), []).append(change)
    for value in left.keys() & right.keys() - {""}:
        for a in left[value]:
            for b in right[value]:
                both = a.printed.with_side(link.right, b.printed.sides[link.right])
                yield Change(both, a.weight + b.weight, (*a.steps, *b.steps))


def _value(context: Context, change: Change, side: int) -> str:
    """A side's value at the first point to eleven digits; empty if there is none."""
    ball = context.points[0].ball(change.printed.sides[side])
    return "" if ball is None or not ball.is_finite() else str(ball.str(11, radius=False))


def _within(context: Context) -> Iterator[Change]:
    for heaviest in (SLIGHT, PLAIN):
        for first in changes(context.formula, context.table, context.numbers, heaviest):
            if first.weight != heaviest:
                continue
            for second in changes(first.printed, context.table, context.numbers, PLAIN):
                if context.is_late:
                    return
                if second.weight >= first.weight:
                    weight = first.weight + second.weight
                    yield Change(second.printed, weight, (*first.steps, *second.steps))
