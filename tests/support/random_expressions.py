"""Expressions of a user's own, drawn at random: such as cancel, and such as nobody should write."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from functools import partial
from typing import Any

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.quantity import ONE, Quantity

NAMES = ("x", "y", "z", "w")
QUANTITIES = {name: Quantity(name, name, f"a number {name}", ONE) for name in NAMES}
VALUE = Quantity("value", "v", "the value", ONE)
X, Y, Z, W = (QUANTITIES[name].symbol for name in NAMES)

Make = Callable[[random.Random, Any], Any]


def _remainder(draw: random.Random, x: Any) -> Any:
    """What is left of a function without the first terms of its series."""
    function = draw.choice([lambda s: sp.exp(-s), sp.sin, sp.cos, lambda s: 1 / (1 + s)])
    s = sp.Symbol("s", real=True)
    order = draw.randint(1, 4)
    series = sp.series(function(s), s, 0, order).removeO()
    return draw.choice([1, -1]) * (function(s) - series).subs(s, x)


def _roots(draw: random.Random, x: Any) -> Any:
    shift = draw.choice([1, 2, Y, 3 * Y])
    return draw.choice(
        [
            sp.sqrt(x**2 + shift**2) - x,
            sp.sqrt((x - shift) ** 2 + Z**2) - sp.sqrt((x + shift) ** 2 + Z**2),
            sp.sqrt(x + shift) - sp.sqrt(x),
        ]
    )


def _polynomial(draw: random.Random, x: Any) -> Any:
    point, power = draw.choice([1, 2, sp.Rational(1, 3), Y]), draw.randint(1, 4)
    return sp.expand((x - point) ** power)


def _sums(draw: random.Random, x: Any) -> Any:
    return draw.choice([x * Z - Y * W, x / (x + Y) - Y / (x + 2 * Y), x**2 - 3 * x * Y + Y**2])


KINDS: tuple[Make, ...] = (_remainder, _roots, _polynomial, _sums)


def cancelling(seed: int) -> ExpressionSet:
    """One kernel with one output in which terms of both signs stand."""
    draw = random.Random(seed)
    argument = draw.choice([X, X, X * Y, X / Y])
    kind = draw.choice(KINDS)
    expression = kind(draw, argument)
    if draw.random() < 0.4:
        expression = expression * draw.choice([Y, 1 / X, 1 / Y**2, sp.exp(-X), X / (1 + Y)])
    if draw.random() < 0.2:
        expression = expression + draw.choice([1, Y, X / 7])
    return _set(draw, expression)


def _set(draw: random.Random, expression: Any) -> ExpressionSet:
    used = [name for name in NAMES if QUANTITIES[name].symbol in expression.free_symbols]
    inputs = tuple(
        Argument(
            QUANTITIES[name],
            f"1e-{draw.choice([0, 1, 2, 3, 6])}",
            draw.choice(["2", "3", "10", "100"]),
            signed=name in "xzw" and draw.random() < 0.5,
        )
        for name in used
    )
    kernel = ExpressionKernel("made", "Drawn at random", inputs, (Result(VALUE, expression),))
    return ExpressionSet("drawn", "Drawn at random", (kernel,))


def odd(seed: int) -> ExpressionSet:
    """What a user may come to write: any function, any constant, any end of a domain."""
    draw = random.Random(seed)
    atoms = [X, Y, X, Y, 0, 1, -1, 2, sp.pi, sp.E, sp.Rational(1, 3), sp.sqrt(2), sp.GoldenRatio]
    known: list[Any] = [sp.sympify(draw.choice(atoms)) for _ in range(3)] + [X, X]
    for _ in range(draw.randint(1, 7)):
        one, other = draw.choice(known), draw.choice(known)
        known.append(_odd(draw, one, other))
    expression = known[-1]
    found = [name for name in NAMES if QUANTITIES[name].symbol in expression.free_symbols]
    if draw.random() < 0.1:
        found.append(draw.choice(NAMES))
    ends = [
        "0",
        "1e-300",
        "1e-3",
        "1/7",
        "1",
        "2",
        "1e3",
        "1e30",
        "1e300",
        "1e400",
        "-1",
        "nan",
        "",
    ]
    inputs = tuple(
        Argument(
            QUANTITIES[name],
            draw.choice(ends[:5]) if draw.random() < 0.93 else draw.choice(ends),
            draw.choice(ends[5:8]) if draw.random() < 0.93 else draw.choice([*ends, None]),
            draw.choice([None] * 12 + [("1e-3", "10"), ("1", "1"), ("a", "b")]),
            zero=draw.random() < 0.1,
            signed=draw.random() < 0.3,
        )
        for name in found
    )
    kernel = ExpressionKernel("made", "Drawn at random", inputs, (Result(VALUE, expression),))
    return ExpressionSet("drawn", "Drawn at random", (kernel,))


def _odd(draw: random.Random, one: Any, other: Any) -> Any:
    kind = draw.randrange(18)
    functions = [
        *(sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.sqrt, sp.Abs, sp.atan, sp.asin, sp.cosh),
        *(sp.floor, sp.sign, sp.gamma, sp.erf, sp.re, sp.conjugate, sp.LambertW, sp.cbrt),
    ]
    with sp.evaluate(draw.random() < 0.95):
        match kind:
            case 0 | 1 | 2:
                return one + other
            case 3 | 4:
                return one - other
            case 5 | 6:
                return one * other
            case 7 | 8:
                return one / other
            case 9:
                return one ** draw.choice([2, 3, -1, -2, sp.Rational(1, 2), sp.Rational(1, 3), 70])
            case 10:
                return one**other
            case 11 | 12:
                return sp.atan2(one, other)
            case 13:
                return draw.choice([sp.Max, sp.Min])(one, other)
            case 14:
                return sp.Piecewise((one, X > 1), (other, True))
            case _:
                return draw.choice(functions)(one)


JUNK: tuple[Any, ...] = (
    *(None, 0, -1, 1.5, "", "a b", "class", "é", "x" * 300, "\n", b"x", (), [], {}, object, sp.nan),
    *(
        sp.zoo,
        sp.oo,
        sp.I,
        X > 1,
        sp.Matrix([X]),
        float("nan"),
        (None,),
        ("1",),
        [1, 2],
        QUANTITIES,
    ),
)


def _with_entry(put: Callable[[Any], ExpressionSet], value: Any, n: int, new: Any) -> ExpressionSet:
    return put((*value[:n], new, *value[n + 1 :]))


def _with_field(
    put: Callable[[Any], ExpressionSet], value: Any, name: str, new: Any
) -> ExpressionSet:
    return put(replace(value, **{name: new}))


def broken(seed: int) -> ExpressionSet:
    """What is right but for one field, which holds something else."""
    draw = random.Random(seed)
    argument = Argument(QUANTITIES["x"], "1", "2", ("1", "2"))
    kernel = ExpressionKernel("made", "A title", (argument,), (Result(VALUE, X + 1),))
    given = ExpressionSet("drawn", "A title", (kernel,))
    places: list[Callable[[Any], ExpressionSet]] = []

    def within(value: Any, put: Callable[[Any], ExpressionSet]) -> None:
        places.append(put)
        if isinstance(value, tuple):
            for n, each in enumerate(value):
                within(each, partial(_with_entry, put, value, n))
        elif is_dataclass(value) and not isinstance(value, type):
            for each in fields(value):
                old = getattr(value, each.name)
                within(old, partial(_with_field, put, value, each.name))

    within(given, lambda new: new)
    return draw.choice(places)(draw.choice(JUNK))
