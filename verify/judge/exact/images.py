"""Images of algebraic numbers and sets of places under an expression of one variable, exactly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic, rational_point, real_roots
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.norm_factors import norm
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.polynomial import constant, univariate
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided

VALUE = "the value"
MOST_DEGREE = 8
PRECISIONS = (128, 512, 2048)


def image(expr: Expr, name: str, at: Algebraic) -> Algebraic:
    """The value of an expression of one variable at an algebraic number. Raises Undecided."""
    if at.is_rational:
        known = constant_value(substituted(expr, {name: number(at.low)}))
        if known is not None:
            return rational_point(known)
    if len(at.coefficients) > MOST_DEGREE + 1:
        raise Undecided(f"a number of a degree above {MOST_DEGREE}")
    difference = expr - symbol(VALUE)
    tower = build_tower([difference], (name, VALUE), (), frozenset(), DEFAULT_LIMITS)
    whole = norm(tower, tower.element(difference).num)
    index, wanted = tower.parameter_indices
    minimal = constant(tower.context, 0)
    for k, c in enumerate(at.coefficients):
        minimal = minimal + tower.context.gen(index) ** k * c
    # the value is a root of what is left where the number is put in
    roots = [
        root
        for factor, _ in univariate(minimal.resultant(whole, index), wanted).factor()[1]
        for root in real_roots(factor)
    ]
    for precision in PRECISIONS:
        try:
            ball = Balls({name: at.ball(precision)}, precision).round(expr)
        except (NoValue, Unresolved):
            continue
        width = Fraction(1, 1 << (precision // 2))
        roots = [
            r for r in (root.refined(width) for root in roots) if r.ball(precision).overlaps(ball)
        ]
        if len(roots) == 1:
            return roots[0]
    raise Undecided("the value at an algebraic number was not separated from others")


def images(expr: Expr, name: str, box: Box, kept: Sequence[Place]) -> list[Place] | None:
    """A union of places of a variable as one of its expression, which runs through the numbers
    between its limits at the ends of the box once; None where it does not. Raises Undecided.
    """
    falling = _is_falling(expr, name, box)
    if falling is None:
        return None
    inner = replace(box, lower_open=True, upper_open=True)

    def end(value: Algebraic | None, bound: Fraction | None, far: str) -> Algebraic | None:
        if value is not None and not (value.is_rational and value.low == bound):
            return image(expr, name, value)
        return _limit(expr, name, inner, far if bound is None else bound)

    found = []
    for place in kept:
        if place.at is not None:
            found.append(Place(at=image(expr, name, place.at)))
            continue
        left = end(place.left, box.lower, "-infinity")
        right = end(place.right, box.upper, "infinity")
        ends = (right, left) if falling else (left, right)
        found.append(replace(place, left=ends[0], right=ends[1]))
    return found[::-1] if falling else found


def _is_falling(expr: Expr, name: str, box: Box) -> bool | None:
    """Whether it falls with its variable throughout, False where it rises, None for neither."""
    slope = differentiated(expr, name)
    stated = {name: replace(box, stated=True)}
    for falling, operator in ((False, ">"), (True, "<")):
        try:
            rel = Rel(operator, slope, number(0))
            if decide(Statement((rel,), needed=(expr,)), stated, name).verdict == "proved":
                return falling
        except Undecided:
            continue
    return None


def _limit(expr: Expr, name: str, box: Box, point: Fraction | str) -> Algebraic | None:
    """The limit at an end of the box, None for one that is infinite. Raises Undecided unless it is
    that or 0.
    """
    for claimed in ("infinity", "-infinity"):
        if decide_limit(expr, name, box, point, claimed, name).verdict == "proved":
            return None
    if decide_limit(expr, name, box, point, number(0), name).verdict == "proved":
        return rational_point(Fraction(0))
    raise Undecided("a limit that is neither 0 nor infinite")
