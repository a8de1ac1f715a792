"""The filters of one lag: coordinates in which a minimum over them is found.

With steps x, w, e of the stable filters, N = 1 + x + w + e alone fixes the lag of the order in
which it is constant. The filters of one N > 1 are a triangle (for two states an interval): x, w, e
positive with a given sum. A function whose reciprocal goes to zero on its border has a least value
inside, where its slopes along the triangle are zero.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    coefficients_in,
    degree,
    fraction,
    terms,
)
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.rational_system import (
    numerator_and_denominator,
    quotient,
)
from gainproof.verify.judge.setting.environment import DEVIATION, INTERVAL

POSITIVE = Box(lower=number(0).fraction)


@dataclass(frozen=True)
class Curve:
    """Where the slopes vanish: each step as a function of the first, all of them positive for
    positive values of it, their sum strictly increasing. `zeros` are the polynomials of the steps
    that vanish just there, among positive steps.
    """

    steps: Mapping[str, Expr]
    zeros: tuple[Expr, ...]


def has_roots(expr: Expr) -> bool:
    """Whether roots are among its parts."""
    return any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(expr))


def without_roots(expr: Expr) -> Expr:
    """What has its least value where this has: under a root, or the square of a root. What stands
    under it must be positive, which `refuse_unless_coercive` shows.
    """
    if expr.kind != "pow":
        return expr
    (base,) = expr.parts
    if base.kind == "pow" and (base.fraction * expr.fraction).denominator == 1:
        whole = base.fraction * expr.fraction
        if whole > 0:
            return without_roots(base.parts[0])
    return without_roots(base) if expr.fraction > 0 and expr.fraction.denominator != 1 else expr


def refuse_unless_coercive(expr: Expr, steps: Sequence[str]) -> None:
    """Raises Undecided unless the expression is positive and its reciprocal continuous on each
    closed triangle and zero on the border: numerator and denominator have no negative term, the
    numerator has one without a step, and every step divides the denominator.
    """
    names = _names(expr, steps)
    top, bottom = numerator_and_denominator(expr, names)
    size = len(steps)
    if not (_without_minus(top) and _without_minus(bottom)):
        raise Undecided("what is minimised is not seen to be positive")
    if not any(not any(e[:size]) for e, _ in terms(top)):
        raise Undecided("what is minimised is not seen to stay away from zero on the border")
    if not all(all(e[i] for e, _ in terms(bottom)) for i in range(size)):
        raise Undecided("what is minimised is not seen to grow beyond bounds towards the border")


def _names(expr: Expr, steps: Sequence[str], *others: str) -> tuple[str, ...]:
    """The steps and what else an expression holds, which is positive. Raises Undecided."""
    if has_roots(expr):
        raise Undecided("a minimum of an expression with roots is not covered")
    rest = sorted(symbols_of(expr) - set(steps))
    if not set(rest) <= {INTERVAL, DEVIATION, *others}:
        raise Undecided("a minimum of an expression with other symbols is not covered")
    return (*steps, *rest)


def _without_minus(p: Poly) -> bool:
    return not p.is_zero() and all(fraction(c) > 0 for _, c in terms(p))


def stationary(expr: Expr, steps: Sequence[str]) -> Curve:
    """Where the slopes of a function along all triangles vanish: one curve through all of them.
    Raises Undecided where that is not so or not seen.

    Each polynomial is irreducible and of first degree in the next step: where its leading
    coefficient vanishes it has no zero, since both parts have no common factor.
    """
    names = _names(expr, steps)
    zeros: list[Poly] = []
    for one, other in pairwise(steps):
        slope = differentiated(expr, one) - differentiated(expr, other)
        zeros.append(_essential(numerator_and_denominator(slope, names)[0]))
    found: dict[str, Expr] = {}
    for zero, name in zip(zeros, steps[1:], strict=True):
        here = substituted(expression_of(zero, names), found)
        p = _essential(numerator_and_denominator(here, names)[0])
        index = names.index(name)
        if degree(p, index) != 1:
            raise Undecided("the slopes vanish on more than one curve, or on one that is not plain")
        rest, leading = coefficients_in(p, index)
        found[name] = quotient(-rest, leading, names)
        if not symbols_of(found[name]) <= {steps[0]}:
            raise Undecided("the slopes vanish on a surface")
    curve = {steps[0]: symbol(steps[0]), **found}
    _refuse_unless_single(curve, steps[0])
    return Curve(curve, tuple(expression_of(zero, names) for zero in zeros))


def _essential(p: Poly) -> Poly:
    """The one factor that may vanish where all variables are positive. Raises Undecided."""
    if p.is_zero():
        raise Undecided("what is minimised does not change")
    _, factors = p.factor()
    kept = [f for f, _ in factors if not (_without_minus(f) or _without_minus(-f))]
    if len(kept) != 1:
        raise Undecided("the slopes vanish nowhere, or on more than one curve")
    return kept[0]


def _refuse_unless_single(curve: Mapping[str, Expr], first: str) -> None:
    """All steps positive, their sum strictly increasing: at most one point for each sum."""
    boxes = {first: POSITIVE}
    total: Expr = number(1)
    relations = []
    for value in curve.values():
        total = total + value
        relations.append(Rel(">", value, number(0)))
    relations.append(Rel(">", differentiated(total, first), number(0)))
    for rel in relations:
        if decide(Statement((rel,)), boxes, first).verdict != "proved":
            raise Undecided("the slopes may vanish at several filters of one lag")


def fixes_sum(expr: Expr, steps: Sequence[str]) -> bool:
    """Whether an expression is one and the same for all filters of one N, and another for each N:
    it has a value throughout, its slopes along the triangles are zero identically, and that across
    is zero nowhere. Derivatives of the target are not zero. Raises Undecided.
    """
    motions = [n for n in symbols_of(expr) if n.startswith("target_motion.")]
    names = _names(expr, steps, *motions)
    for one, other in pairwise(steps):
        slope = differentiated(expr, one) - differentiated(expr, other)
        if not numerator_and_denominator(slope, names)[0].is_zero():
            return False
    across, _ = numerator_and_denominator(differentiated(expr, steps[-1]), names)
    _, below = numerator_and_denominator(expr, names)
    if across.is_zero():
        return False
    moving = [names.index(n) for n in motions]
    return all(_has_no_zero(f, moving) for p in (across, below) for f, _ in p.factor()[1])


def _has_no_zero(factor: Poly, moving: Sequence[int]) -> bool:
    """For positive variables, and others that are not zero."""
    if any(degree(factor, i) > 0 for i in moving):
        return len(list(terms(factor))) == 1
    return _without_minus(factor) or _without_minus(-factor)
