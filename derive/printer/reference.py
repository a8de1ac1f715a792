"""Error bounds of kernels whose inputs have signs, or which call functions of a library.

No boxes: every step has a bound that holds on the whole domain. Of each step is known

- its reference, at least the magnitude of the true value: that of an input is its magnitude, of a
  product the product, of a sum the sum of the terms' references. `tight`: it is the magnitude;
- `count` n and `stray`: the error is at most the reference times (1 - u)^-n - 1, and `stray` more.
  Where tight and without stray, computed/true lies in [(1 - u)^n, (1 - u)^-n]. A rounding is 1; n
  of a product is a sum, of a sum the larger one (each of both then 1 more), of a square root half
  (Stewart's counters, Higham, chapter 3). A result that may be subnormal leaves a stray;
- `low` and `high`: what is computed is 0 or at least `low`, and at most `high`, but for a factor of
  1 + 2^-10; and so is the true value where tight and without stray: then 0 comes as 0.

A sum that is not tight may be any number down to the rounding of its smaller term: two numbers of a
format that are not equal differ by a unit in the last place of the smaller one at least.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.step_ranges import PrintingError

LARGER = 1.0 + 2.0**-40  # than a few roundings of these bounds themselves


@dataclass(frozen=True)
class Reference:
    """What is known of one step; `sign` 1: never negative, -1: never positive, 0: either.

    `zero`: it may be 0.
    """

    count: float
    low: float
    high: float
    sign: int
    zero: bool
    tight: bool = True
    stray: float = 0.0

    @property
    def clean(self) -> bool:
        """Whether its relative error is bounded."""
        return self.tight and not self.stray


SETTLED = 2.0**-10  # of a rounding: what a stray may be beside a radicand's least value
MOST = 500.0  # roundings of what is known by its requirement alone
FEW = 100.0  # roundings: the square of their relative error is below SETTLED of one, at 2^-24 too


def settled(found: Reference, least: float, form: Format) -> Reference:
    """A radicand whose root is required to be at least `least`: a stray that is nothing beside the
    square of `least` counts as a part of a rounding.

    The root is required as it is computed. As neither the few roundings nor the stray change the
    radicand by 2^-10 of itself, it is so for the true one, but for the factor in which `least` is
    below what is required; and the stray is at most SETTLED u of it. Twice that part, since an
    error v ((1 - u)^-n - 1) may leave less than v (1 - u)^n, by less than its own square.
    """
    room = least * least * form.unit_roundoff * SETTLED / LARGER
    few = found.tight and found.sign > 0 and found.count <= FEW
    if not few or found.stray > room:
        return found
    return replace(found, count=found.count + (2.0 * SETTLED if found.stray else 0.0), stray=0.0)


def required(found: Reference, least: float, form: Format) -> Reference:
    """A step that is required to be at least `least` as it is computed.

    If terms may cancel, its error is a part of its reference, and so of `least`, which it must not
    come near: then the true value is positive too, but for a factor of 1 + 2^-10, and where that
    part is a few roundings the relative error is bounded.

    PrintingError where the error is no small part of `least`.
    """
    if found.clean:
        return replace(found, low=max(found.low, least), sign=1, zero=False)
    error = (found.count * found.high * form.unit_roundoff + found.stray) * (1.0 + 2.0**-8)
    if error > least * 2.0**-10:
        raise PrintingError(
            f"a requirement of an uncertain value: next to {least:.3g} its error is no small part "
            f"of it; wanted: at least {error * 2.0**10:.2g} ({form.name})"
        )
    part = error / least / form.unit_roundoff
    if part > MOST:
        return replace(found, low=least, sign=1, zero=False)
    return replace(found, count=part, low=least, sign=1, zero=False, tight=True, stray=0.0)
