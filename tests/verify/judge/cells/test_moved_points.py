"""Points of a cell away from its samples lie in the same cell."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from one_of_each import cases

from gainproof.verify.judge.cells.lifting import cells
from gainproof.verify.judge.cells.parameter_polynomials import value_at
from gainproof.verify.judge.cells.projection import projected
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import from_terms, ring
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS

BOXES = (
    Box(stated=False),
    Box(lower=Fraction(0)),
    Box(lower=Fraction(-1), upper=Fraction(1)),
)


@pytest.mark.parametrize("seed", cases(range(12), lambda seed: 2 < seed < 9))
def test_every_cut_has_the_same_sign_there(seed: int) -> None:
    source = random.Random(seed)
    count = source.choice((2, 3))
    context = ring([f"x{k}" for k in range(count)])
    cuts = []
    for _ in range(source.choice((1, 2))):
        monomials = [tuple(source.randint(0, 2) for _ in range(count)) for _ in range(3)]
        entries = {m: source.choice((-3, -2, -1, 1, 2, 5)) for m in monomials}
        p = from_terms(context, {**entries, (0,) * count: source.choice((-1, 1))})
        cuts += [factor for factor, _ in p.factor()[1]]
    boxes = [source.choice(BOXES) for _ in range(count)]
    found = cells(projected(cuts, boxes, DEFAULT_LIMITS).levels, boxes, DEFAULT_LIMITS)
    moved = 0
    for cell in found[:60]:
        signs = [value_at(cut, cell.samples[0]) > 0 for cut in cuts]
        for point in cell.moved:
            moved += 1
            assert all(box.holds(x) for box, x in zip(boxes, point, strict=True))
            assert [value_at(cut, point) > 0 for cut in cuts] == signs
            assert all(a != b for a, b in zip(point[:1], cell.samples[0][:1], strict=True))
    assert moved
