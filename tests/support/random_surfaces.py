"""Random statements in several parameters: true by construction, false by a little or in a small
part of the domain, and arbitrary. With each come points that deserve a look.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from random import Random

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    absolute,
    add,
    div,
    mul,
    number,
    power,
    sqrt,
    symbol,
)
from gainproof.verify.judge.exact.statement import Rel, Statement

NAMES = ("x", "y", "z")
BOXES = (
    Box(stated=False),
    Box(),
    Box(lower=Fraction(0)),
    Box(lower=Fraction(0)),
    Box(lower=Fraction(0), lower_open=False),
    Box(lower=Fraction(0), upper=Fraction(1)),
    Box(lower=Fraction(-1), upper=Fraction(2), lower_open=False, upper_open=False),
)
Point = dict[str, Fraction]


@dataclass(frozen=True)
class Trial:
    """A statement, the boxes of its symbols, and points at which it may well fail."""

    statement: Statement
    boxes: dict[str, Box]
    special: tuple[Point, ...] = ()


def trial(random: Random) -> Trial:
    """A random statement in two or three parameters."""
    names = NAMES[: random.choice((2, 2, 3))]
    if random.random() < 0.12:
        return _on_curve(random)
    make = random.choice((_identity, _identity, _inequality, _inequality, _small_part, _anything))
    rel, special = make(random, names)
    given: tuple[Rel, ...] = ()
    if random.random() < 0.35:
        given = (_condition(random, names),)
    if random.random() < 0.1:
        given = (*given, _condition(random, names))
    statement = Statement((rel,), given)
    if random.random() < 0.15:
        sides = _equivalent(random, names)
        statement, special = Statement((sides[0],), (sides[1],), "iff"), ()
    return Trial(statement, {n: random.choice(BOXES) for n in names}, special)


def polynomial(random: Random, names: tuple[str, ...]) -> Expr:
    """A small polynomial."""
    terms = []
    for _ in range(random.choice((1, 2, 2, 3))):
        factors: list[Expr] = [number(random.choice((1, 1, 1, -1, 2, -2, 3)))]
        factors += [symbol(random.choice(names)) for _ in range(random.choice((0, 1, 1, 2)))]
        terms.append(mul(*factors))
    return add(*terms)


def _expression(random: Random, names: tuple[str, ...]) -> Expr:
    p, q = polynomial(random, names), polynomial(random, names)
    kind = random.randrange(7)
    match kind:
        case 0:
            return div(p, q)
        case 1:
            return sqrt(p)
        case 2:
            return absolute(p)
        case 3:
            return p + sqrt(power(p, 2) + power(q, 2))
        case 4:
            return power(p, Fraction(1, 3))
        case _:
            return p


def _condition(random: Random, names: tuple[str, ...]) -> Rel:
    operator = random.choice(("<", "<=", ">", ">=", ">", "=", "!="))
    return Rel(operator, polynomial(random, names), polynomial(random, names))


def _equivalent(random: Random, names: tuple[str, ...]) -> tuple[Rel, Rel]:
    """Two relations that are equivalent, or are where both sides have values or one sign."""
    a, b = polynomial(random, names), polynomial(random, names)
    zero = number(0)
    pairs = (
        (Rel("<", a, b), Rel(">", b - a, zero)),
        (Rel("=", power(a, 2), power(b, 2)), Rel("=", a, b)),
        (Rel("<", power(a, 2), power(b, 2)), Rel("<", absolute(a), absolute(b))),
        (Rel("=", a * b, zero), Rel("=", a, zero)),
        (Rel("<=", sqrt(a), b), Rel("<=", a, power(b, 2))),
        (Rel(">", div(a, b), zero), Rel(">", a * b, zero)),
        (Rel("=", a, b), Rel("=", power(a, 3), power(b, 3))),
        (Rel("<=", a, b), Rel("<=", power(a, 3), power(b, 3))),
    )
    return random.choice(pairs)


def _pair(random: Random, names: tuple[str, ...]) -> tuple[Expr, Expr]:
    """Two sides that are equal wherever both have a value, or but for a sign that is checked."""
    a, b = _expression(random, names), polynomial(random, names)
    pairs = (
        (power(a + b, 2), power(a, 2) + 2 * a * b + power(b, 2)),
        (div(number(1), sqrt(a) + sqrt(b)), div(sqrt(a) - sqrt(b), a - b)),
        (sqrt(power(a - b, 2)), absolute(a - b)),
        (sqrt(a) * sqrt(b), sqrt(a * b)),
        (sqrt(power(b, 2)), b),
        (sqrt(a + b + 2 * sqrt(a * b)), sqrt(a) + sqrt(b)),
        (div(a, b) + div(b, a), div(power(a, 2) + power(b, 2), a * b)),
        (sqrt(div(a, b)), div(sqrt(a * b), absolute(b))),
        (absolute(a) * absolute(b), absolute(a * b)),
        (sqrt(power(b, 4)), power(b, 2)),
        (power(power(b, 3), Fraction(1, 3)), b),
        (sqrt(sqrt(power(b, 4)) + 2 * b + 1), absolute(b + 1)),
    )
    return random.choice(pairs)


def _identity(random: Random, names: tuple[str, ...]) -> tuple[Rel, tuple[Point, ...]]:
    left, right = _pair(random, names)
    tiny = number(Fraction(1, 10 ** random.randint(2, 12)))
    p = polynomial(random, names)
    if random.random() < 0.5:
        right = random.choice(
            (right + tiny, right + tiny * (absolute(p) - p), right * (1 + tiny * p), right + p)
        )
    return Rel(random.choice(("=", "=", "<=", "!=")), left, right), ()


def _inequality(random: Random, names: tuple[str, ...]) -> tuple[Rel, tuple[Point, ...]]:
    """Sums of squares and means; strict ones fail where the squares vanish."""
    a, b = polynomial(random, names), polynomial(random, names)
    pairs = (
        (2 * a * b, power(a, 2) + power(b, 2)),
        (a + b, sqrt(2 * (power(a, 2) + power(b, 2)))),
        (sqrt(power(a, 2) + power(b, 2)), absolute(a) + absolute(b)),
        (absolute(a + b), absolute(a) + absolute(b)),
        (2 * sqrt(a * b), a + b),
        (number(0), power(a, 2) * power(b, 2)),
        (div(number(4), a + b), div(number(1), a) + div(number(1), b)),
        (sqrt(a), (a + 1) / 2),
    )
    left, right = random.choice(pairs)
    if random.random() < 0.3:
        right = right - number(Fraction(1, 10 ** random.randint(1, 9))) * polynomial(random, names)
    return Rel(random.choice(("<=", "<=", "<")), left, right), ()


def _small_part(random: Random, names: tuple[str, ...]) -> tuple[Rel, tuple[Point, ...]]:
    """False in a ball of tiny or no radius round a rational point, or on a thin strip."""
    centre = {n: Fraction(random.randint(-2, 6), random.choice((1, 2, 3, 7))) for n in names}
    size = random.choice((Fraction(0), Fraction(1, 10 ** random.randint(1, 6))))
    squares = [power(symbol(n) - number(centre[n]), 2) for n in names]
    distance = add(*squares) if random.random() < 0.7 else squares[0]
    operator = random.choice((">", ">="))
    if random.random() < 0.3:
        return Rel(operator, sqrt(distance), number(size)), (centre,)
    return Rel(operator, distance, number(size * size)), (centre,)


def _on_curve(random: Random) -> Trial:
    """A curve of degree three or four through a rational point, and what may just fail there."""
    names = NAMES[:2]
    x, y = symbol("x"), symbol("y")
    centre = {n: Fraction(random.randint(-2, 3), random.choice((1, 1, 2))) for n in names}
    first = random.choice((power(x, 3), power(x, 3), power(x, 4), power(x, 3) * y))
    second = random.choice((power(y, 3), power(y, 3), -power(y, 4), power(y, 3) * x))
    curve = _through(first + second + polynomial(random, names), centre)
    line = _through(polynomial(random, names), centre)
    zero = number(0)
    operator = random.choice(("<", "<=", "=", "!="))
    kind = random.randrange(4)
    given: tuple[Rel, ...] = ()
    if kind == 0:
        rel = Rel(operator, line, zero)
        given = (Rel(random.choice(("=", "=", ">=", "<=")), curve, zero),)
    elif kind == 1:
        rel = Rel(
            random.choice(("<", "<=")),
            zero,
            power(curve, 2) * random.choice((line, power(line, 2))),
        )
    elif kind == 2:
        rel = Rel(
            operator, sqrt(power(curve, 2)), random.choice((curve, zero, absolute(curve) * line))
        )
    else:
        rel = Rel(random.choice(("<=", "=")), sqrt(curve) * sqrt(line), sqrt(curve * line))
    if random.random() < 0.3:
        given = (*given, Rel(random.choice(("<", ">=")), line, zero))
    boxes = {n: random.choice(BOXES) for n in names}
    return Trial(Statement((rel,), given), boxes, (centre,))


def _through(expr: Expr, point: Point) -> Expr:
    """The expression less its value at a point."""
    value = constant_value(substituted(expr, {n: number(v) for n, v in point.items()}))
    return expr - number(value or 0)


def _anything(random: Random, names: tuple[str, ...]) -> tuple[Rel, tuple[Point, ...]]:
    operator = random.choice(("=", "<", "<=", ">", ">=", "!="))
    return Rel(operator, _expression(random, names), _expression(random, names)), ()
