"""A witness in words: where a formula fails, and what its sides are there."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from typing import Any

from gainproof.formulas.formula_text import plain_name
from gainproof.verify.judge.verdict_words import LACKS_VALUE, NOT_COMPARED, Shown

_DIGITS = 6
"""Digits shown of a side; more where fewer would not tell the sides apart."""
_MOST_DIGITS = 40
_APPROACH = "->"
"""How the value of a symbol begins that tends to a point instead of having a value."""
_SLOPES = {">": "above", "<": "below", ">=": "at least", "<=": "at most"}
"""What a trend asks of a derivative, in words, by the operator of its witness."""
_OURS = re.compile("[a-z]+([_ ][a-z]+)+")
"""A quantity by its own name, since no symbol of the source stands for it."""


def at_point(witness: Mapping[str, Any]) -> str:
    """`at r = 1`, `as r -> infinity`, or nothing for a formula that holds no symbols. Before
    quantities that no source writes so, the symbols of the formula: `at a = 0.5
    (tracking_index = 1)`.
    """
    places = [(name, str(value)) for name, value in witness["point"].items()]
    own = witness.get("values", {}).items()
    ours = [f"{name} = {value}" for name, value in places if _OURS.fullmatch(name)]
    if own and ours and not _is_approach(witness):
        told = [f"{name} = {_shown(value, _DIGITS)}" for name, value in own]
        told += [f"{name} = {value}" for name, value in places if not _OURS.fullmatch(name)]
        return f"at {', '.join(told)} ({', '.join(ours)})"
    fixed = [f"{name} = {value}" for name, value in places if not value.startswith(_APPROACH)]
    moving = [f"{name} {value}" for name, value in places if value.startswith(_APPROACH)]
    parts = (("at", fixed), ("as", moving))
    return " ".join(f"{word} {', '.join(inner)}" for word, inner in parts if inner)


def sides(witness: Mapping[str, Any]) -> str:
    """`the left side is 0.5, the right 4.5`, which side has no value, or what a limit is."""
    left, right = witness["left"], witness["right"]
    missing = [name for name in ("left", "right") if witness[name].get("undefined")]
    if _is_approach(witness) and witness.get("note") != LACKS_VALUE:
        first, second = _apart(left, right)
        if witness.get("operator") == _APPROACH:
            return f"the left side tends to {first}, not to {second}"
        if len(missing) == 2:
            return f"the left side is {first}, the right {second}"
        if witness.get("note") and not missing:
            return f"the left side is {first}, the right {second} ({witness['note']})"
    if not _are_compared(witness):
        return str(witness["note"])
    note, shows = str(witness.get("note") or ""), witness.get("shows")
    if shows == Shown.TRUTH:
        first, second = _apart(left, right)
        return note if missing else f"{note} (its sides are {first} and {second})"
    if shows == Shown.STABILITY:
        return note
    if len(missing) == 2:
        reasons = dict.fromkeys(str(witness[name]["undefined"]) for name in missing)
        return f"neither side has a value ({'; '.join(reasons)})"
    for name, other in (("left", "right"), ("right", "left")):
        if name in missing:
            said = f"the {name} side has no value ({witness[name]['undefined']})"
            value = _shown(witness[other], _DIGITS)
            return said if _is_approach(witness) else f"{said}, the {other} is {value}"
    if witness.get("exact"):
        return f"both sides are {_shown(left, _DIGITS)}"
    first, second = _apart(left, right)
    entry = f"in {note} " if shows == Shown.ENTRY else ""
    return f"{entry}the left side is {first}, the right {second}"


def _are_compared(witness: Mapping[str, Any]) -> bool:
    """Whether the sides of a relation are what fails, not what the note alone says."""
    both = [witness[side].get("undefined") for side in ("left", "right")]
    return both != [NOT_COMPARED] * 2 or not witness.get("note")


def in_words(witness: Mapping[str, Any]) -> str:
    """`at r = 1 the left side is 0.5, the right 4.5`; against a trend
    `at S = 3 the derivative is 0.5, not at most 0`.
    """
    asked = _slope_asked(witness)
    if asked and not _is_approach(witness):
        said = f"the derivative is {_shown(witness['left'], _DIGITS)}, not {asked}"
    else:
        said = sides(witness)
    return f"{at_point(witness)} {said}".strip()


def in_full(witness: Mapping[str, Any] | str) -> list[str]:
    """Lines: the point, both sides and the quantities there with all their digits; of a trend, the
    derivative and what is asked of it.
    """
    if isinstance(witness, str):
        return [witness]
    # the values of the formula's symbols follow in full
    lines = [at_point({"point": witness["point"]})] if witness["point"] else []
    asked = _slope_asked(witness)
    if asked:
        lines += [f"derivative: {_ball(witness['left'])}", f"claimed: {asked}"]
    for side in ("left", "right") if not asked and _are_compared(witness) else ():
        lines.append(f"{side} side: {witness[side].get('undefined') or _ball(witness[side])}")
    values = witness.get("values", {})
    lines += [f"with {name} = {_ball(value)}" for name, value in values.items()]
    return [*lines, str(witness["note"])] if witness.get("note") else lines


def of_relation(witness: Mapping[str, Any], symbols: Mapping[str, str]) -> str:
    """Against a relation of a derivation, whose names have the LaTeX `symbols`: `At Lambda = 1 the
    left side is 0.5, the right side is 0.75.`, with the radius of each enclosure where a number is
    not exact.
    """
    names = {name: plain_name(latex) for name, latex in symbols.items()}
    where = at_point({"point": {names.get(n, n): value for n, value in witness["point"].items()}})
    if witness["names"]:
        known = [f"{names.get(name, name)} = {_ball(v)}" for name, v in witness["names"].items()]
        where = f"{where}, where {', '.join(known)}," if where else f"With {', '.join(known)}"
    left, right = _ball(witness["left"]), _ball(witness["right"])
    match witness["shape"]:
        case "equal":
            entry = f", in row and column {witness['entry']}," if witness["entry"] else ""
            told = f"the left side{entry} is {left}, the right side is {right}"
        case "positive":
            told = f"the expression is {left}, which is not above 0"
        case "limit":
            told = f"the limit is {left}, not {right}"
        case "sum":
            told = f"the terms add up to {left}, the closed form is {right}"
        case "monotone increasing":
            told = f"the derivative is {left}: it falls there"
        case _:
            told = f"the derivative is {left}: it rises there"
    sentence = f"{where} {told}.".strip()
    return sentence[0].upper() + sentence[1:]


def _slope_asked(witness: Mapping[str, Any]) -> str:
    """`at most 0`: what a trend asks of the derivative; empty where that has no value, and for
    what is no trend.
    """
    if witness.get("shows") != Shown.SLOPE:
        return ""
    word = _SLOPES.get(str(witness.get("operator")))
    if word is None or any(witness[side].get("undefined") for side in ("left", "right")):
        return ""
    return f"{word} {_shown(witness['right'], _DIGITS)}"


def _ball(value: Mapping[str, Any]) -> str:
    """A number with the radius of its enclosure, `0.5` where that is exact."""
    if value["radius"] in ("0", 0):
        return str(value["midpoint"])
    return f"{value['midpoint']} +/- {value['radius']}"


def _is_approach(witness: Mapping[str, Any]) -> bool:
    return any(str(value).startswith(_APPROACH) for value in witness["point"].values())


def _apart(left: Mapping[str, Any], right: Mapping[str, Any]) -> tuple[str, str]:
    """Both sides with as many digits as tell them apart; words, such as `infinity`, as they are."""
    digits = next(
        (n for n in range(_DIGITS, _MOST_DIGITS) if _shown(left, n) != _shown(right, n)),
        _MOST_DIGITS,
    )
    return _shown(left, digits), _shown(right, digits)


def _shown(side: Mapping[str, Any], digits: int) -> str:
    """The midpoint rounded to so many digits, without trailing zeros, or the word in its place."""
    if side.get("undefined"):
        return str(side["undefined"])
    try:
        context = Context(prec=digits, Emax=MAX_EMAX, Emin=MIN_EMIN)
        rounded = context.create_decimal(str(side["midpoint"]))
    except ArithmeticError:
        return str(side["midpoint"])
    if rounded == 0:
        return "0"
    plain = rounded.normalize(context)
    exponent = plain.adjusted()
    return f"{plain:f}" if -5 < exponent < 16 else str(Decimal(plain))
