"""Limits of algebraic expressions of one parameter.

The norm M(Z, x) of Z den - num has the expression as a root in Z. As x tends to the point, every
finite limit is a root of the leading coefficient of M in x. Rationals a between these roots
separate them; beyond the last zero of all M(a, x) the expression stays in one of the gaps, and one
ball says in which. A gap holds one root, the limit; outside all gaps the limit is infinite.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint

from gainproof.verify.judge.exact.algebraic import Algebraic, apart, real_roots, simplest_between
from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, neg, number, power, symbol
from gainproof.verify.judge.exact.limits import DEFAULT_LIMITS, Limits, Undecided
from gainproof.verify.judge.exact.local import Local
from gainproof.verify.judge.exact.norm import norm, vanishing_factors
from gainproof.verify.judge.exact.place import Box, Place, places
from gainproof.verify.judge.exact.poly import Poly, coefficients_in, degree, rational, univariate
from gainproof.verify.judge.exact.radicand import Element
from gainproof.verify.judge.exact.statement import Enclosure, Outcome, Rel, Statement, Witness
from gainproof.verify.judge.exact.tower import Tower, build_tower
from gainproof.verify.judge.exact.witness import enclosure, separated, value_ball

UNKNOWN = "limit value"


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
        raise Undecided(f"the expression has no value near the limit: {why}")
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


def toward_infinity(
    expr: Expr, parameter: str, box: Box, point: Fraction | str, side: int
) -> tuple[Expr, Box]:
    """The expression with the parameter replaced so that the point is approached as a new parameter
    grows.
    """
    u = symbol(parameter)
    if point == "infinity":
        return expr, Box(lower=max(Fraction(0), box.lower or Fraction(0)))
    if point == "-infinity":
        return substituted(expr, {parameter: neg(u)}), Box(lower=Fraction(0))
    centre = Fraction(point)
    step = power(u, -1) if side > 0 else neg(power(u, -1))
    return substituted(expr, {parameter: number(centre) + step}), Box(lower=Fraction(0))


def decide_limit(
    expr: Expr, parameter: str, box: Box, point: Fraction | str, claimed: Expr | str, label: str
) -> Outcome:
    """Whether an expression tends to the claimed value (or "infinity", "-infinity"). Raises
    Undecided.
    """
    found = None
    for side in _sides(box, point):
        moved, where = toward_infinity(expr, parameter, box, point, side)
        found = limit_to_infinity(moved, parameter, where)
        wrong = _wrong(found, claimed)
        if wrong is not None:
            place = {
                label: f"-> {point}"
                + ("" if isinstance(point, str) else (" from above" if side > 0 else " from below"))
            }
            witness = Witness(
                place, "->", *wrong, exact=found.value is None, note=f"the limit is {found.text()}"
            )
            return Outcome(
                "refuted",
                "nowhere",
                f"the limit is {found.text()}",
                "limit from the norm",
                witness,
                found.certificate,
                1,
            )
    assert found is not None
    return Outcome(
        "proved",
        f"as {label} -> {point}",
        "the limit is the claimed one",
        "limit from the norm",
        None,
        found.certificate,
    )


def _sides(box: Box, point: Fraction | str) -> tuple[int, ...]:
    if isinstance(point, str):
        return (1,)
    below = box.lower is None or box.lower < point
    above = box.upper is None or box.upper > point
    sides = (*((1,) if above else ()), *((-1,) if below else ()))
    if not sides or (not (above and below) and point not in (box.lower, box.upper)):
        raise Undecided(f"{point} is not in the domain")
    return sides


def _wrong(found: Limit, claimed: Expr | str) -> tuple[Enclosure, Enclosure] | None:
    """Both values if the limit is not the claimed one."""
    if isinstance(claimed, str):
        sign = -1 if claimed.startswith("-") else 1
        if found.value is None and found.sign == sign:
            return None
        left = (
            Enclosure("", "", found.text())
            if found.value is None
            else enclosure(found.value.ball(64), 12)
        )
        return left, Enclosure("", "", claimed)
    local, element = _constant(claimed)
    ball = value_ball(local, element, None, 64, ())
    if ball is None:
        raise Undecided("the claimed limit has no value")
    if found.value is None:
        return Enclosure("", "", found.text()), enclosure(ball, 12)
    if _is_root(found.value, claimed):
        return None
    for precision in (64, 256, 1024, 4096):
        ball = value_ball(local, element, None, precision, ())
        shown = None if ball is None else separated(found.value.ball(precision), ball)
        if shown is not None:
            return shown
    raise Undecided("balls cannot tell the limit from the claimed value")


def _constant(expr: Expr) -> tuple[Local, Any]:
    expr = roots_made_prime(expr)
    tower = build_tower([expr], None, (), frozenset())
    local = Local(tower, Place())
    why = local.undefined(expr)
    if why is not None:
        raise Undecided(f"the claimed limit has no value: {why}")
    return local, tower.element(expr)


def _is_root(value: Algebraic, claimed: Expr) -> bool:
    """Whether the claimed number is this root: inside the isolating interval and a zero of the
    polynomial.
    """
    total: Expr = number(value.coefficients[-1])
    for c in reversed(value.coefficients[:-1]):
        total = total * claimed + number(c)
    if value.is_rational:
        inside: tuple[Rel, ...] = ()
    else:
        inside = (Rel("<", number(value.low), claimed), Rel("<", claimed, number(value.high)))
    relations = (Rel("=", total, number(0)), *inside)
    return decide(Statement(relations), {}, None).verdict == "proved"
