"""Positive forms of what is a quotient in xi, in lowest terms over the parameter, as hints.

Only where the family's constants are roots: elsewhere the tower finds the common factors itself.
Where lowest terms show no sign (constants whose nested root is a plain one, which the tower does
not see) there is no hint, and the tower is left to find a form.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import by, derivative
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.lowest_terms import Quotient, over_parameter
from gainproof.derive.three_state.names import INDEX, PARAMETER, Z, rows
from gainproof.derive.three_state.towers import scale_of_parameter

Hint = dict[str, Any]


def shown(c: Context, quotient: Quotient) -> sp.Expr:
    """A positive quotient in xi over the parameter.

    Raises ArithmeticError where lowest terms show no sign.
    """
    return over_parameter(c.tower, (c.constants.least, scale_of_parameter(c.spectrum)), quotient)


def _if_shown(c: Context, hint: Callable[[Context], Hint]) -> Hint:
    if not c.spectrum.m2:
        return {}
    try:
        return hint(c)
    except ArithmeticError:
        return {}


def value(c: Context, expression: sp.Expr) -> Hint:
    """An expression over the named quantities."""
    return _if_shown(c, lambda c: {"form": shown(c, c.quotients.of(expression))})


def minors(c: Context, kind: str) -> Hint:
    """The leading minors of a covariance."""
    return _if_shown(c, lambda c: _minors(c, kind))


def _minors(c: Context, kind: str) -> Hint:
    (m11, m12, m13), (_, m22, m23), (_, _, m33) = (
        [c.quotients.of(real(name)) for name in row] for row in rows(kind)
    )
    second, cross, last = m11 * m22 - m12**2, m12 * m23 - m13 * m22, m11 * m23 - m12 * m13
    third = m13 * cross - m23 * last + m33 * second
    return {"minors": [shown(c, minor) for minor in (m11, second, third)]}


def schur_cohn(c: Context) -> Hint:
    """a_n - a_0 and a_n + a_0 of c(z) for each degree from 3 down to 1."""
    return _if_shown(c, _schur_cohn)


def _schur_cohn(c: Context) -> Hint:
    row = [c.quotients.of(c.spectrum.closed_loop.coeff(Z, n)) for n in range(4)]
    values: list[sp.Expr] = []
    while len(row) > 1:
        first, last = row[0], row[-1]
        values += [shown(c, last - first), shown(c, last + first)]
        row = [
            last * after - first * mirrored
            for after, mirrored in zip(row[1:], reversed(row[:-1]), strict=True)
        ]
    return {"values": values}


def slope(c: Context, name: str) -> Hint:
    """The derivative of an element by the index."""
    return _if_shown(
        c, lambda c: {"form": shown(c, c.quotients.along_index(c.quotients.of(real(name)))) / INDEX}
    )


def curve(c: Context, name: str, up: bool) -> Hint:
    """The second derivative of an element by the index, or where it bends down its negative.

    Empty where the constants are roots and lowest terms show no sign.
    """
    known = _if_shown(c, lambda c: {"form": _curve(c, name, up)})
    return known if known or c.spectrum.m2 else {"form": _second(c.tower, name, up)}


def _curve(c: Context, name: str, up: bool) -> sp.Expr:
    first = c.quotients.along_index(c.quotients.of(real(name)))
    value = (c.quotients.along_index(first) - first) * c.quotients.of(1 / INDEX**2)
    return shown(c, value if up else -value)


def _second(tower: Tower, name: str, up: bool) -> sp.Expr:
    first = tower.expression(derivative(tower, real(name), INDEX.name))
    value = derivative(tower, first, INDEX.name)
    return tower.expression(value if up else Fraction(-value.num, value.den))


def slope_by_parameter(c: Context, expression: sp.Expr) -> Hint:
    """The derivative of an expression by the variable of limits."""
    return _if_shown(c, lambda c: {"form": _by_parameter(c, expression)})


def _by_parameter(c: Context, expression: sp.Expr) -> sp.Expr:
    """d/dp, as d/dxi with xi = 1 + b + 4/wide."""
    value = c.quotients.of(expression)
    fall = by(4 / scale_of_parameter(c.spectrum), PARAMETER)
    return shown(c, -by(value, c.quotients.field.gens[0])) * -fall
