"""Forms that show the signs of the page `measured-position-three-states`, by step.

Most are quotients in xi in lowest terms over the parameter, where the family's constants are roots:
elsewhere the tower finds the common factors itself. Where lowest terms show no sign (constants
whose nested root is a plain one, which the tower does not see) there is no hint, and the tower is
left to find a form.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import by, derivative
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.three_state import curvature, pole_tower
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    BEND,
    DELTA,
    ETA,
    GAINS,
    GROWTH,
    HIDDEN,
    INDEX,
    NU,
    PARAMETER,
    PREDICTED,
    REST,
    TAU,
    Z,
    rows,
)
from gainproof.derive.three_state.pole_places import middle, turning
from gainproof.derive.three_state.pole_places import numbers as pole_numbers
from gainproof.derive.three_state.pole_tower import LEVEL, A, G
from gainproof.derive.three_state.towers import scale_of_parameter

Hint = dict[str, Any]


CONVEX = (*PREDICTED[2:], "updated_23", "updated_33")


def hints(c: Context) -> Mapping[str, Hint]:
    """By step; nothing where the tower finds a form, or where nothing shows the sign."""
    found = {
        "stable": schur_cohn(c),
        "definite-predicted": minors(c, "predicted"),
        "definite-updated": minors(c, "updated"),
        **{f"increasing-{name}": slope(c, name) for name in (*GAINS, *PREDICTED, *HIDDEN)},
        **{f"concave-{name}": curve(c, name, up=False) for name in GAINS},
        **{f"convex-{name}": curve(c, name, up=True) for name in CONVEX},
        **_turning(c),
        **_poles(c),
    }
    if c.spectrum.e:
        found["above-e"] = value(c, DELTA**2 - c.numbers[2])
    return {name.replace("_", "-"): hint for name, hint in found.items() if hint}


def _turning(c: Context) -> dict[str, Hint]:
    """Of what bends down first and then up; X22 so unless all is rational in a root."""
    cross = curvature.cross()
    found = {
        "turning-predicted-11": {"form": "sigma^2 psi/Lambda^2"},
        "turning-predicted-12": {"form": "sigma xi/(2 Lambda)"},
        "turns-once-predicted-11": slope_by_parameter(c, GROWTH - BEND),
        "turns-once-predicted-12": slope_by_parameter(c, cross),
    }
    if c.spectrum.rational_in_root:
        return {**found, "concave-updated-22": curve(c, "updated_22", up=False)}
    form = curvature.of_updated_22(curvature.numbers(c.model, c.spectrum)) / ETA
    found["turns-once-updated-22"] = slope_by_parameter(c, form)
    if c.spectrum.m2 and not all(found.values()):
        return {}  # some own noise, of which more cannot be shown
    return found


def _poles(c: Context) -> dict[str, Hint]:
    found = turning(c)
    scale = INDEX**4 * REST**4 / (8 * TAU / NU**2) ** 2
    shown = -found.quotient if found.value is None else found.factor
    hints: dict[str, Hint] = {"discriminant": {"form": shown * scale}}
    if c.spectrum.rational_in_root:
        above = "16 (xi + 2 root_2)/(root_2 Lambda xi (xi + 2) (xi^2 + 2 root_2 xi + 4))"
        hints["sign-of-half-sum"] = {"form": above}
    elif pole_tower.within_reach(c.spectrum):
        place, (m1, _) = middle(c.spectrum), pole_numbers(c.spectrum)
        limit, level = 8 / place.root, LEVEL
        share = level**2 + (2 - m1 + place.level) * level + 2 - m1 + place.level
        factor = (level + place.level + 1 - m1) / ((G + 1) * (1 + A + G)) / share
        hints["sign-of-half-sum"] = {"form": factor * 64 * (limit + INDEX) / (INDEX * limit) ** 2}
    return hints


def _if_shown(c: Context, hint: Callable[[Context], Hint]) -> Hint:
    if not c.spectrum.m2:
        return {}
    try:
        return hint(c)
    except ArithmeticError:
        return {}


def value(c: Context, expression: sp.Expr) -> Hint:
    """An expression over the named quantities."""
    return _if_shown(c, lambda c: {"form": c.shown(c.quotients.of(expression))})


def minors(c: Context, kind: str) -> Hint:
    """The leading minors of a covariance."""
    return _if_shown(c, lambda c: _minors(c, kind))


def _minors(c: Context, kind: str) -> Hint:
    (m11, m12, m13), (_, m22, m23), (_, _, m33) = (
        [c.quotients.of(real(name)) for name in row] for row in rows(kind)
    )
    second, cross, last = m11 * m22 - m12**2, m12 * m23 - m13 * m22, m11 * m23 - m12 * m13
    third = m13 * cross - m23 * last + m33 * second
    return {"minors": [c.shown(minor) for minor in (m11, second, third)]}


def schur_cohn(c: Context) -> Hint:
    """a_n - a_0 and a_n + a_0 of c(z) for each degree from 3 down to 1."""
    return _if_shown(c, _schur_cohn)


def _schur_cohn(c: Context) -> Hint:
    row = [c.quotients.of(c.spectrum.closed_loop.coeff(Z, n)) for n in range(4)]
    values: list[sp.Expr] = []
    while len(row) > 1:
        first, last = row[0], row[-1]
        values += [c.shown(last - first), c.shown(last + first)]
        row = [
            last * after - first * mirrored
            for after, mirrored in zip(row[1:], reversed(row[:-1]), strict=True)
        ]
    return {"values": values}


def slope(c: Context, name: str) -> Hint:
    """The derivative of an element by the index."""
    return _if_shown(
        c, lambda c: {"form": c.shown(c.quotients.along_index(c.quotients.of(real(name)))) / INDEX}
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
    return c.shown(value if up else -value)


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
    return c.shown(-by(value, c.quotients.field.gens[0])) * -fall
