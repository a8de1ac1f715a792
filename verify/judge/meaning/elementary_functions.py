"""Named functions by others: logarithms by natural ones, hyperbolic functions by exponentials,
secants by cosines, arc sines by arc tangents, the greater of two numbers by their distance, signs
by cases, remainders by whole parts. Exact, on the same domain.

asin x = 2 atan(x/(1 + (1 - x^2)^(1/2))), the half of an angle by its sine and cosine;
mod(x, m) = x - m floor(x/m) has the sign of m, and no value for m = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from types import MappingProxyType

from gainproof.verify.judge.exact.expression import (
    Expr,
    absolute,
    div,
    neg,
    number,
    power,
)
from gainproof.verify.judge.reader.words import BASED, OF_CASES


def _call(name: str, *parts: Expr) -> Expr:
    return Expr("call", name, parts)


def _sinh(x: Expr) -> Expr:
    return (_call("exp", x) - _call("exp", neg(x))) / 2


def _cosh(x: Expr) -> Expr:
    return (_call("exp", x) + _call("exp", neg(x))) / 2


def _asin(x: Expr) -> Expr:
    cosine = power(1 - power(x, 2), Fraction(1, 2))
    return 2 * _call("atan", div(x, 1 + cosine))


def _sign(x: Expr) -> Expr:
    parts = (number(1), x, number(0), number(0), x, number(0), number(-1))
    return _call(f"{OF_CASES}> = -", *parts)


def _greater(a: Expr, b: Expr) -> Expr:
    return (a + b + absolute(a - b)) / 2


def _remainder(x: Expr, m: Expr) -> Expr:
    return x - m * _call("floor", x / m)


def _smaller(a: Expr, b: Expr) -> Expr:
    return (a + b - absolute(a - b)) / 2


_OF_ONE: Mapping[str, Callable[[Expr], Expr]] = MappingProxyType(
    {
        "sinh": _sinh,
        "cosh": _cosh,
        "tanh": lambda x: _sinh(x) / _cosh(x),
        "sec": lambda x: number(1) / _call("cos", x),
        "csc": lambda x: number(1) / _call("sin", x),
        "cot": lambda x: _call("cos", x) / _call("sin", x),
        "asin": _asin,
        "acos": lambda x: _call("pi") / 2 - _asin(x),
        "ceil": lambda x: neg(_call("floor", neg(x))),
        "sign": _sign,
    }
)
_OF_SEVERAL: Mapping[str, Callable[[Expr, Expr], Expr]] = MappingProxyType(
    {"max": _greater, "min": _smaller}
)


def elementary(name: str, numbers: list[Expr]) -> Expr | None:
    """The function of these numbers; None for other names and counts."""
    if name.startswith(BASED) and len(numbers) == 1:
        base = number(int(name.removeprefix(BASED)))
        return div(_call("log", numbers[0]), _call("log", base))
    if name in _OF_ONE and len(numbers) == 1:
        return _OF_ONE[name](numbers[0])
    if name == "mod" and len(numbers) == 2:
        return _remainder(*numbers)
    if name in _OF_SEVERAL and numbers:
        return reduce(_OF_SEVERAL[name], numbers)
    return None
