"""Units as a claim file writes them: `1`, `m`, `m s^-2`, `m^2/s`, `rad`."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.claim.record import Unit

_MOST_FACTORS = 8
_MOST_POWER = 64


def read_unit(text: str) -> Unit:
    """The unit that `text` names. ValueError says what is wrong.

    Factors are `m`, `s`, `rad` or `1`, each with an optional power such as `^-2` or `^(1/2)`,
    separated by blanks; what follows a slash is divided by, up to the end.
    """
    above, slash, below = text.partition("/") if "(" not in text else (text, "", "")
    if slash and not below.strip():
        raise ValueError(f"{text!r} ends with a slash")
    top, bottom = _powers(above, text), _powers(below, text) if slash else Unit()
    return Unit(top.metre - bottom.metre, top.second - bottom.second)


def _powers(part: str, text: str) -> Unit:
    metre, second = Fraction(0), Fraction(0)
    factors = part.split()
    if not 1 <= len(factors) <= _MOST_FACTORS:
        raise ValueError(f"{text!r} is no unit: write for example 1, m, m s^-2 or m^2/s")
    for factor in factors:
        base, hat, power_text = factor.partition("^")
        power = _power(power_text, text) if hat else Fraction(1)
        if base == "m":
            metre += power
        elif base == "s":
            second += power
        elif base not in ("1", "rad"):
            raise ValueError(f"{base!r} is no unit: m, s, rad and 1 are known")
    return Unit(metre, second)


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
    """The unit as `read_unit` reads it."""
    factors = (("m", unit.metre), ("s", unit.second))
    shown = [
        name if power == 1 else f"{name}^{power}" if power.denominator == 1 else f"{name}^({power})"
        for name, power in factors
        if power
    ]
    return " ".join(shown) or "1"
