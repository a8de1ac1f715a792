"""The number pi: exact values of angles that are multiples of a twelfth of it, and pi as a variable
between two rationals.

Nothing algebraic holds for pi that does not hold for every number, so that what is proved between
the two rationals is all that the new variable can say.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import flint

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, add, div, mul, neg, number, power, symbol
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.monomials import monomials, terms_expr

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
    arc tangents of 1 and of roots of 3 as multiples of pi. The same value wherever that of the
    expression exists.
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
    """Of 1, sqrt(3), 1/sqrt(3) and sqrt(3)/3, and of these with the other sign."""
    if slope.kind == "neg":
        found = _arc_tangent(slope.parts[0])
        return None if found is None else neg(found)
    root = power(number(3), Fraction(1, 2))
    known = {
        number(1): 4,
        number(-1): -4,
        root: 3,
        div(number(1), root): 6,
        div(root, number(3)): 6,
        power(number(3), Fraction(-1, 2)): 6,
    }
    if slope not in known:
        return None
    return div(PI, number(known[slope])) if known[slope] > 0 else neg(div(PI, number(4)))
