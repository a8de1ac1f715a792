"""Functions that are not algebraic: their slopes, and balls round their values.

`power` is base^exponent with symbols in the exponent: any base for a whole exponent, else a
positive one. `log` is the natural logarithm, `pi` the number, of no argument. `erf` is the error
function, `erfinv` its inverse between -1 and 1: |x| < s 2^(1/2) erfinv(p) has probability p for a
normal x of deviation s.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from types import MappingProxyType

import flint

from gainproof.verify.judge.exact.expression import Expr, add, div, mul, neg, number, power
from gainproof.verify.judge.exact.poly import Ball

MOST_POWER = 4096


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
    return (name in SLOPES and count == 1) or (name, count) in (("power", 2), ("pi", 0))


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
    return None


def ball_of(name: str, parts: list[Ball]) -> Ball | None:
    """A ball round the value, at the precision of the context; None where it is not resolved."""
    if name == "power" and len(parts) == 2:
        return _power(*parts)
    if name == "pi" and not parts:
        return flint.arb.pi()
    if name not in SLOPES or len(parts) != 1:
        return None
    (x,) = parts
    if (name == "log" and not x > 0) or (name == "erfinv" and not abs(x) < 1):
        return None
    found = getattr(x, name)()
    return found if found.is_finite() else None


def _power(base: Ball, exponent: Ball) -> Ball | None:
    whole = exponent.unique_fmpz() if exponent.is_exact() else None
    if whole is not None and abs(int(whole)) <= MOST_POWER:
        if int(whole) < 0 and base.contains(0):
            return None
        return base ** int(whole)
    return (base.log() * exponent).exp() if base > 0 else None
