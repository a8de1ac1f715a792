"""Units as a claim file writes them: `1`, `m`, `m s^-2`, `m^2/s`, `rad`, `W`."""

from __future__ import annotations

import re
from fractions import Fraction

from gainproof.verify.judge.claim.record import Unit

_ONE = Fraction(1)
_BASES = {
    "m": Unit(metre=_ONE),
    "s": Unit(second=_ONE),
    "kg": Unit(kilogram=_ONE),
    "K": Unit(kelvin=_ONE),
    "A": Unit(ampere=_ONE),
    "deg": Unit(degree=_ONE),
}
_NEWTON = _BASES["kg"] * _BASES["m"] / _BASES["s"] ** 2
_WATT = _NEWTON * _BASES["m"] / _BASES["s"]
KNOWN = {
    **_BASES,
    "1": Unit(),
    "rad": Unit(),
    "degree": _BASES["deg"],
    "degrees": _BASES["deg"],
    "Hz": _BASES["s"] ** -1,
    "N": _NEWTON,
    "J": _NEWTON * _BASES["m"],
    "W": _WATT,
    "V": _WATT / _BASES["A"],
}
"""All that may be written; none is a multiple of another, so that numbers mean what they say. A
degree is a unit of its own beside the radian: angles in it are turned where they are used.
"""
INSTEAD = {
    "°": "deg",
    **dict.fromkeys(("min", "minute"), "s; 1 min is 60 s"),
    **dict.fromkeys(("h", "hour"), "s; 1 h is 3600 s"),
    "ms": "s; 1 ms is 1/1000 s",
    "us": "s; 1 us is 1/1000000 s",
    "km": "m; 1 km is 1000 m",
    "cm": "m; 1 cm is 1/100 m",
    "mm": "m; 1 mm is 1/1000 m",
    "ft": "m; 1 ft is 0.3048 m",
    "g": "kg for a mass, 1 g being 1/1000 kg; m s^-2 for an acceleration, 1 g being 9.80665 m s^-2",
    "kHz": "Hz; 1 kHz is 1000 Hz",
    "MHz": "Hz; 1 MHz is 1000000 Hz",
    "GHz": "Hz; 1 GHz is 1000000000 Hz",
    "dB": "1 and the formula with its logarithm; a decibel is 10 times one to the base 10",
    "sec": "s",
    "%": "1",
}
"""What to write for a unit that is a multiple of another: formulas hold in base units."""
_BARE_FRACTION = re.compile(r"\^(-?\d{1,3}/(?!1(?:$|[ /]))\d{1,3})(?=$|[ /])")
"""A fractional power without brackets: after a slash no unit begins with a digit but 1."""
_SLASH = re.compile(r"/(?![^(]*\))")
"""A slash outside of brackets."""
_MOST_FACTORS = 8
_MOST_POWER = 64
_MOST_TEXT = 200


def read_unit(text: str) -> Unit:
    """The unit that `text` names. ValueError says what is wrong.

    Factors are those of `KNOWN`, each with an optional power such as `^-2`, `^(1/2)` or `^-1/2`,
    separated by blanks; what follows a slash is divided by, up to the end.
    """
    if len(text) > _MOST_TEXT:
        raise ValueError(f"a unit of {len(text)} characters, but at most {_MOST_TEXT} are read")
    above, *below = _SLASH.split(_BARE_FRACTION.sub(r"^(\1)", text), maxsplit=1)
    if below and not below[0].strip():
        raise ValueError(f"{text!r} ends with a slash")
    return _powers(above, text) / (_powers(below[0], text) if below else Unit())


def _powers(part: str, text: str) -> Unit:
    found = Unit()
    factors = part.split()
    if not 1 <= len(factors) <= _MOST_FACTORS:
        raise ValueError(f"{text!r} is no unit: write for example 1, m, m s^-2 or m^2/s")
    for factor in factors:
        base, hat, power_text = factor.partition("^")
        power = _power(power_text, text) if hat else Fraction(1)
        if base not in KNOWN:
            instead = f"write {INSTEAD[base]}" if base in INSTEAD else ""
            raise ValueError(f"{base!r} is no unit: {instead or 'known are ' + ', '.join(KNOWN)}")
        found *= KNOWN[base] ** power
    return found


def _power(power_text: str, text: str) -> Fraction:
    inner = power_text.removeprefix("(").removesuffix(")") if "(" in power_text else power_text
    pieces = inner.removeprefix("-").split("/")
    if len(pieces) > 2 or not all(p.isascii() and p.isdigit() and len(p) <= 3 for p in pieces):
        raise ValueError(f"{power_text[:20]!r} in {text[:40]!r} is no power")
    below = int(pieces[1]) if len(pieces) == 2 else 1
    if below == 0 or int(pieces[0]) > _MOST_POWER or below > _MOST_POWER:
        raise ValueError(f"the power {power_text!r} is outside -{_MOST_POWER} to {_MOST_POWER}")
    power = Fraction(int(pieces[0]), below)
    return -power if inner.startswith("-") else power


def unit_text_of(unit: Unit) -> str:
    """The unit in base units, as `read_unit` reads it: `m s^-1`, or `1` without dimension."""
    factors = zip(_BASES, unit.powers, strict=True)
    shown = [
        name if power == 1 else f"{name}^{power}" if power.denominator == 1 else f"{name}^({power})"
        for name, power in factors
        if power
    ]
    return " ".join(shown) or "1"
