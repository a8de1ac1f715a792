"""Functions that are not algebraic: their slopes, and balls round their values.

`power` is base^exponent with symbols in the exponent: any base for a whole exponent, else a
positive one. `log` is the natural logarithm, `pi` the number, of no argument. `erf` is the error
function, `erfinv` its inverse between -1 and 1: |x| < s 2^(1/2) erfinv(p) has probability p for a
normal x of deviation s.

Functions with jumps: `floor`; `atan2` of y and x, the angle of the point (x, y) above -pi and at
most pi, of the origin none; and cases, whose name says how their parts are compared (`first_case`).
`no jump` of y, x and a slope of y is 0 where that angle has a slope, and has no value elsewhere.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType

import flint

from gainproof.verify.judge.exact.expression import Expr, add, div, mul, neg, number, power, walk
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.reader.words import OF_CASES

MOST_POWER = 4096
JUMPS = ("atan2", "floor", "no jump")


Comparison = tuple[str, Expr, Expr]


def first_case(node: Expr) -> tuple[tuple[Comparison, ...], Expr, Expr | None]:
    """Of cases what the first compares and its value, and all other cases, if there are any.

    `cases >,<= -` is the name of a call with a value under two conditions and one for all else: its
    parts are a value, four sides, a value. The first case counts whose conditions hold; where none
    does there is no value.
    """
    first, *others = node.name.removeprefix(OF_CASES).split(" ")
    operators = [] if first == "-" else first.split(",")
    value, *rest = node.parts
    sides, rest = rest[: 2 * len(operators)], rest[2 * len(operators) :]
    other = Expr("call", OF_CASES + " ".join(others), tuple(rest)) if others else None
    return tuple(zip(operators, sides[::2], sides[1::2], strict=True)), value, other


def is_cases(name: str, count: int) -> bool:
    """Whether this is the name of cases with so many parts."""
    if not name.startswith(OF_CASES):
        return False
    each = [[] if e == "-" else e.split(",") for e in name.split(" ")[1:]]
    known = all(o in ("=", "!=", "<", "<=", ">", ">=") for operators in each for o in operators)
    return known and count == sum(1 + 2 * len(operators) for operators in each)


def has_jumps(node: Expr) -> bool:
    """Whether a node is a call of a function with jumps."""
    return node.kind == "call" and (node.name in JUMPS or node.name.startswith(OF_CASES))


def refuse_jumps(*exprs: Expr) -> None:
    """Raises Undecided where a slope does not say how a function changes."""
    if any(map(has_jumps, walk(*exprs))):
        raise Undecided("a trend of what may jump")


def _one(name: str, x: Expr) -> Expr:
    return Expr("call", name, (x,))


def _half_root_of_pi() -> Expr:
    """pi^(1/2)/2, since pi/4 is atan 1."""
    return power(_one("atan", number(1)), Fraction(1, 2))


SLOPES: Mapping[str, Callable[[Expr], Expr]] = MappingProxyType(
    {
        "exp": lambda x: _one("exp", x),
        "log": lambda x: power(x, -1),
        "sin": lambda x: _one("cos", x),
        "cos": lambda x: neg(_one("sin", x)),
        "tan": lambda x: add(number(1), power(_one("tan", x), 2)),
        "atan": lambda x: div(number(1), add(number(1), power(x, 2))),
        "erf": lambda x: div(_one("exp", neg(power(x, 2))), _half_root_of_pi()),
        "erfinv": lambda x: mul(_one("exp", power(_one("erfinv", x), 2)), _half_root_of_pi()),
    }
)
"""Functions of one argument, with their derivatives."""


def is_known(name: str, count: int) -> bool:
    """Whether this is a function with so many arguments."""
    others = (("power", 2), ("pi", 0), ("atan2", 2), ("floor", 1), ("no jump", 3))
    return (name in SLOPES and count == 1) or (name, count) in others or is_cases(name, count)


def slope_of(node: Expr, inner: list[Expr | None]) -> Expr | None:
    """The derivative of a call, from those of its arguments (None is zero); None if not known."""
    if node.name in SLOPES and len(inner) == 1 and inner[0] is not None:
        return mul(SLOPES[node.name](node.parts[0]), inner[0])
    if node.name == "power" and len(inner) == 2:
        base, exponent = node.parts
        terms = []
        if inner[0] is not None:
            # m x^(m - 1) has a value at x = 0 for m >= 1, which m x^m/x has not
            lowered = Expr("call", "power", (base, add(exponent, number(-1))))
            terms.append(mul(exponent, lowered, inner[0]))
        if inner[1] is not None:
            terms.append(mul(node, _one("log", base), inner[1]))
        return add(*terms)
    if node.name == "atan2" and len(inner) == 2:
        return _turning(*node.parts, *inner)
    return node if node.name == "no jump" else None


def _turning(y: Expr, x: Expr, rise: Expr | None, run: Expr | None) -> Expr:
    """The slope of the angle of (x, y), which is none where y passes through 0 left of x = 0."""
    terms = [] if rise is None else [mul(x, rise)]
    terms += [] if run is None else [neg(mul(y, run))]
    slope = div(add(*terms), add(power(x, 2), power(y, 2)))
    return slope if rise is None else add(slope, Expr("call", "no jump", (y, x, rise)))


def ball_of(name: str, parts: list[Ball]) -> Ball | None:
    """A ball round the value, at the precision of the context; None where it is not resolved."""
    if name == "power" and len(parts) == 2:
        return _power(*parts)
    if name == "pi" and not parts:
        return flint.arb.pi()
    if name in JUMPS:
        return _jumping(name, parts)
    if name not in SLOPES or len(parts) != 1:
        return None
    (x,) = parts
    if (name == "log" and not x > 0) or (name == "erfinv" and not abs(x) < 1):
        return None
    found = getattr(x, name)()
    return found if found.is_finite() else None


def _jumping(name: str, parts: Sequence[Ball]) -> Ball | None:
    """A ball where the function is seen to be continuous, or at one point."""
    if name == "floor" and len(parts) == 1:
        whole = parts[0].floor().unique_fmpz()
        return None if whole is None else flint.arb(whole)
    if len(parts) < 2:
        return None
    y, x = parts[:2]
    on_one_side = not y.contains(0) or x > 0
    if name == "no jump":
        return flint.arb(0) if on_one_side else None
    if on_one_side or (y.is_exact() and x < 0):
        return flint.arb.atan2(y, x)
    return None


def _power(base: Ball, exponent: Ball) -> Ball | None:
    whole = exponent.unique_fmpz() if exponent.is_exact() else None
    if whole is not None and abs(int(whole)) <= MOST_POWER:
        if int(whole) < 0 and base.contains(0):
            return None
        return base ** int(whole)
    return (base.log() * exponent).exp() if base > 0 else None
