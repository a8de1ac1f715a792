"""A witness in words: where a formula fails, and what its sides are there."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Context, Decimal
from typing import Any

_DIGITS = 6
"""Digits shown of a side; more where fewer would not tell the sides apart."""
_MOST_DIGITS = 40


def at_point(witness: Mapping[str, Any]) -> str:
    """`at r = 1`, or nothing for a formula that holds no symbols."""
    point = ", ".join(f"{name} = {value}" for name, value in witness["point"].items())
    return f"at {point}" if point else ""


def sides(witness: Mapping[str, Any]) -> str:
    """`the left side is 0.5, the right 4.5`, or which side has no value."""
    left, right = witness["left"], witness["right"]
    for name, side in (("left", left), ("right", right)):
        if side.get("undefined"):
            return f"the {name} side has no value ({side['undefined']})"
    if witness.get("exact"):
        return f"both sides are {_shown(left, _DIGITS)}"
    digits = next(
        (n for n in range(_DIGITS, _MOST_DIGITS) if _shown(left, n) != _shown(right, n)),
        _MOST_DIGITS,
    )
    return f"the left side is {_shown(left, digits)}, the right {_shown(right, digits)}"


def in_words(witness: Mapping[str, Any]) -> str:
    """`at r = 1 the left side is 0.5, the right 4.5`."""
    return f"{at_point(witness)} {sides(witness)}".strip()


def ball(value: Mapping[str, Any]) -> str:
    """A number with the radius of its enclosure, `0.5` where that is exact."""
    if value["radius"] in ("0", 0):
        return str(value["midpoint"])
    return f"{value['midpoint']} +/- {value['radius']}"


def _shown(side: Mapping[str, Any], digits: int) -> str:
    """The midpoint rounded to so many digits, without trailing zeros."""
    try:
        rounded = Context(prec=digits).create_decimal(str(side["midpoint"]))
    except ArithmeticError:
        return str(side["midpoint"])
    if rounded == 0:
        return "0"
    plain = rounded.normalize()
    exponent = plain.adjusted()
    return f"{plain:f}" if -5 < exponent < 16 else str(Decimal(plain))
