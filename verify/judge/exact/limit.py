"""Limits of algebraic expressions of one parameter.

The norm M(Z, x) of Z den - num has the expression as a root in Z. As x tends to the point, every
finite limit is a root of the leading coefficient of M in x. Rationals a between these roots
separate them; beyond the last zero of all M(a, x) the expression stays in one of the gaps, and one
ball says in which. A gap holds one root, the limit; outside all gaps the limit is infinite.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic
from gainproof.verify.judge.exact.ball_text import enclosure, separated
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, neg, number, power, symbol
from gainproof.verify.judge.exact.limit_value import Limit, limit_to_infinity
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.statement import Enclosure, Outcome, Rel, Statement, Witness
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.witness import value_ball
from gainproof.verify.judge.exact.work_limits import Undecided


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
    for side in sides_of(box, point, label):
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


def sides_of(box: Box, point: Fraction | str, label: str) -> tuple[int, ...]:
    """From where a variable can come: 1 for from above (and to an infinity), -1 for from below.

    Raises Undecided for a point that it does not come near in its domain.
    """
    if isinstance(point, str):
        end = box.lower if point[0] == "-" else box.upper
        if end is not None:
            raise Undecided(f"{label} does not tend to {point} in its domain, which ends at {end}")
        return (1,)
    if box.integer:
        raise Undecided(f"{label}, a whole number, does not come close to {point}")
    below = box.lower is None or box.lower < point
    above = box.upper is None or box.upper > point
    sides = (*((1,) if above else ()), *((-1,) if below else ()))
    if not sides or (not (above and below) and point not in (box.lower, box.upper)):
        raise Undecided(f"{point} is not in the domain of {label}")
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
