"""Balls round the variables of a tower at a point."""

from __future__ import annotations

from collections.abc import Set
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.algebraic import Algebraic
from gainproof.verify.judge.exact.connected import Sample
from gainproof.verify.judge.exact.evaluate import evaluate
from gainproof.verify.judge.exact.poly import Ball, rational
from gainproof.verify.judge.exact.tower import Tower


def variable_balls(
    tower: Tower,
    zero_roots: Set[int],
    at: Sample | Algebraic | None,
    precision: int,
    free: tuple[Fraction, ...],
) -> list[Ball | None]:
    """A ball round every variable, at the current working precision; None where the point does not
    say, or where a root is not resolved or has no value. Roots in `zero_roots` are zero.
    """
    values: list[Ball | None] = [None] * max(1, len(tower.names))
    for place, number in zip(tower.free_indices, free, strict=False):
        values[place] = flint.arb(rational(number))
    coordinates = at if isinstance(at, tuple) else () if at is None else (at,)
    for place, value in zip(tower.parameter_indices, coordinates, strict=False):
        values[place] = (
            value.ball(precision) if isinstance(value, Algebraic) else flint.arb(rational(value))
        )
    for root in tower.roots:
        if root.index in zero_roots:
            values[root.index] = flint.arb(0)
            continue
        top, bottom = evaluate(root.radicand.num, values), evaluate(root.radicand.den, values)
        ratio = top / bottom
        if root.order == 2 and ratio > 0:
            values[root.index] = bottom * ratio.sqrt()
        elif root.order == 3 and ratio > 0:
            values[root.index] = bottom * ratio.root(3)
        elif root.order == 3 and ratio < 0:
            values[root.index] = -bottom * (-ratio).root(3)
    return values
