"""Limits of algebraic expressions of one parameter, as exact numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint

from gainproof.verify.judge.exact.algebraic_numbers import (
    Algebraic,
    apart,
    real_roots,
    simplest_between,
)
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import roots_made_prime
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.norm_factors import norm, vanishing_factors
from gainproof.verify.judge.exact.places import Place, places
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    coefficients_in,
    degree,
    rational,
    univariate,
)
from gainproof.verify.judge.exact.radicands import Element
from gainproof.verify.judge.exact.tower import Tower
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.witness import value_ball
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Undecided

UNKNOWN = "limit value"


class NoValueNear(Undecided):
    """There is no limit because the expression has no value close to the point."""


@dataclass(frozen=True)
class Limit:
    """A limit: a real algebraic number, or `sign` times infinity."""

    value: Algebraic | None
    sign: int
    certificate: Mapping[str, Any]

    def text(self) -> str:
        """Readable."""
        if self.value is not None:
            return self.value.text()
        return "infinity" if self.sign > 0 else "minus infinity"


def limit_to_infinity(
    expr: Expr, parameter: str, box: Box, limits: Limits = DEFAULT_LIMITS
) -> Limit:
    """The limit of an expression of one parameter as it grows without bound. Raises Undecided."""
    expr = roots_made_prime(expr)
    positive = frozenset([parameter]) if box.is_positive else frozenset()
    tower = build_tower([expr], parameter, (UNKNOWN,), positive, limits)
    last = _last_place(tower, expr, box)
    element = tower.element(expr)
    unknown = tower.context.gen(tower.free_indices[0])
    m = norm(tower, unknown * element.den - element.num)
    if m.is_zero():
        raise Undecided("the norm of the expression vanishes")
    index = tower.parameter_index
    assert index is not None
    edge = univariate(coefficients_in(m, index)[degree(m, index)], tower.free_indices[0])
    roots = (
        apart([r for factor, _ in edge.factor()[1] for r in real_roots(factor)])
        if edge.degree() > 0
        else []
    )
    fences = _fences(roots)
    local, sample = _beyond(tower, last, m, fences)
    place = _gap(local, element, sample, fences)
    certificate = {
        "checked": "replayed",
        "tower": tower.relations_text(),
        "leading coefficient": str(edge),
        "separating rationals": [str(f) for f in fences],
        "evaluated at": str(sample),
    }
    if 0 < place < len(fences):
        return Limit(roots[place - 1], 0, certificate)
    return Limit(None, 1 if place == len(fences) else -1, certificate)


def _last_place(tower: Tower, expr: Expr, box: Box) -> Place:
    factors = [f for check in tower.checks for f in vanishing_factors(tower, check.poly)]
    last = places(factors, box)[-1]
    if not last.is_cell or last.right is not None:
        raise Undecided("the domain is bounded")
    why = Local(tower, last).undefined(expr)
    if why is not None:
        raise NoValueNear(f"the expression has no value near the limit: {why}")
    return last


def _fences(roots: list[Algebraic]) -> list[Fraction]:
    """Rationals below, between and above the roots; zero alone if there is none."""
    if not roots:
        return [Fraction(0)]
    inner = [simplest_between(a.high, b.low) for a, b in pairwise(roots)]
    return [simplest_between(None, roots[0].low), *inner, simplest_between(roots[-1].high, None)]


def _beyond(tower: Tower, last: Place, m: Poly, fences: list[Fraction]) -> tuple[Local, Fraction]:
    """A sample beyond every point where the expression might equal one of the fences."""
    index = tower.parameter_index
    assert index is not None
    start = Fraction(0) if last.left is None else last.left.high
    for fence in fences:
        at = m.subs({tower.names[tower.free_indices[0]]: rational(fence)})
        for factor, _ in univariate(at, index).factor()[1]:
            start = max([start, *[root.high for root in real_roots(factor)]])
    return Local(tower, last), Fraction(start.__floor__() + 1)


def _gap(local: Local, element: Element, sample: Fraction, fences: list[Fraction]) -> int:
    """How many of the fences lie below the value at the sample; it equals none of them."""
    precision = 64
    while precision <= local.tower.limits.precision:
        ball = value_ball(local, element, sample, precision, ())
        with flint.ctx.workprec(precision):
            edges = [flint.arb(rational(fence)) for fence in fences]
            if ball is not None and not any(ball.overlaps(edge) for edge in edges):
                return sum(1 for edge in edges if ball > edge)
        precision *= 2
    raise Undecided("balls cannot tell the limit")
