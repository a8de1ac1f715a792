"""Angles in degrees: a symbol with this unit is their number, a sine of it that of the angle."""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.dimensions.dimension import ONE, Dimension, Dimensions, Mismatch
from gainproof.verify.judge.dimensions.formula import DEGREE, ONE_OVER_DEGREE, dimension, names_of
from gainproof.verify.judge.dimensions.names import has_degrees
from gainproof.verify.judge.exact.expression import Expr, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided

PI = Expr("call", "pi", ())


def in_radians(argument: Expr, value: Expr, setting: Setting) -> Expr:
    """The `value` of the `argument` of a sine or the like, in radians: one in degrees is turned,
    one that a print turns itself, `\\pi \\theta/180`, is left. Raises Undecided where nobody can
    tell.
    """
    if not has_degrees(setting) or not symbols_of(value):
        return value
    as_number = _dimension(argument, setting, ONE)
    if as_number == ONE:
        return value
    if not any(node == PI for node in walk(value)):
        if as_number == DEGREE:
            return PI * value / 180
    elif _dimension(argument, setting, ONE_OVER_DEGREE) == ONE:
        return value
    raise Undecided(
        "whether an angle is in degrees or in radians: write a sine of degrees without the number "
        "pi, or turn all of its angle, \\pi \\theta/180, and say the unit of every symbol"
    )


def _dimension(argument: Expr, setting: Setting, circle: Dimension) -> Dimensions | None:
    """The dimension where pi has that of the `circle`; None where dimensions are mixed."""
    try:
        return dimension(argument, names_of(setting).with_circle(circle))
    except Mismatch:
        return None
