"""The number pi: exact values of angles that are multiples of a twelfth of it, and pi as a variable
between two rationals.

Nothing algebraic holds for pi that does not hold for every number, so that what is proved between
the two rationals is all that the new variable can say.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import flint

from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.transcendental.monomials import monomials, terms_expr

PI = Expr("call", "pi", ())
VARIABLE = symbol("freed pi")
LABEL = "pi"
DIGITS = 30
PRECISION = 256
PARTS = 12
TURN = frozenset([(PI, 1)])


@cache
def pi_box() -> Box:
    """Two rationals between which pi lies, as far apart as its last digit."""
    scale = 10**DIGITS
    with flint.ctx.workprec(PRECISION):
        floor = (flint.arb.pi() * scale).floor().unique_fmpz()
    if floor is None:
        raise ArithmeticError("pi is not resolved")
    below = Fraction(int(floor), scale)
    return Box(lower=below, upper=below + Fraction(1, scale), lower_open=True, upper_open=True)


def as_variable(expr: Expr) -> Expr:
    """With the variable in the place of pi, angles first."""
    return rebuilt(exact_angles(expr), lambda node, _: VARIABLE if node == PI else None)


def exact_angles(expr: Expr) -> Expr:
    """Sines, cosines and tangents of angles with multiples of pi/12 in them as those of the rest,
    arc tangents that are such multiples as these. The same value wherever that of the expression
    exists.
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "call" or len(parts) != 1:
            return None
        if node.name == "atan":
            return _arc_tangent(parts[0])
        return _turned(node.name, parts[0]) if node.name in ("sin", "cos", "tan") else None

    return rebuilt(expr, change)


def _turned(name: str, angle: Expr) -> Expr | None:
    try:
        terms = dict(monomials(angle))
    except Undecided:
        return None
    twelfths = terms.pop(TURN, Fraction(0)) * PARTS
    if not twelfths or twelfths.denominator != 1:
        return None
    c, s = cosine_of(int(twelfths)), cosine_of(int(twelfths) - PARTS // 2)
    if terms:
        rest = terms_expr(terms)
        cosine, sine = (Expr("call", each, (rest,)) for each in ("cos", "sin"))
        c, s = add(mul(c, cosine), neg(mul(s, sine))), add(mul(s, cosine), mul(c, sine))
    return {"sin": s, "cos": c}.get(name) or div(s, c)


def cosine_of(twelfths: int) -> Expr:
    """The cosine of so many twelfths of pi."""
    turned = twelfths % (2 * PARTS)
    turned = min(turned, 2 * PARTS - turned)
    if 2 * turned > PARTS:
        return neg(cosine_of(PARTS - turned))
    two, three, six = (power(number(n), Fraction(1, 2)) for n in (2, 3, 6))
    first_quarter = (
        number(1),
        div(add(six, two), number(4)),
        div(three, number(2)),
        div(two, number(2)),
        number(Fraction(1, 2)),
        div(add(six, neg(two)), number(4)),
        number(0),
    )
    return first_quarter[turned]


def _arc_tangent(slope: Expr) -> Expr | None:
    """The angle if it is a multiple of pi/12: balls say of which, and that its tangent is the slope
    is decided exactly.
    """
    if symbols_of(slope) or any(node.kind == "call" for node in walk(slope)):
        return None
    with flint.ctx.workprec(PRECISION):
        try:
            turns = Balls({}, PRECISION).round(slope).atan() * PARTS / flint.arb.pi()
        except (NoValue, Unresolved):
            return None
        twelfths = (turns + flint.arb("0.5")).floor().unique_fmpz()
        if twelfths is None or not (turns - twelfths).contains(0):
            return None
    count = int(twelfths)
    tangent = div(cosine_of(count - PARTS // 2), cosine_of(count))
    try:
        same = settle(Statement((Rel("=", slope, tangent),)), {}, None, {}, only_proof=True)
    except Undecided:
        return None
    return mul(number(Fraction(count, PARTS)), PI) if same.verdict == "proved" else None
