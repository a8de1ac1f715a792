"""What is known of a function of a library whose arguments have references."""

from __future__ import annotations

import math
from fractions import Fraction

from gainproof.derive.printer.angles import least_cosine, least_sine
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.library_functions import ULP
from gainproof.derive.printer.reference import LARGER, Reference
from gainproof.derive.printer.step_ranges import PrintingError

# 4 ulp are at most 8 u; (1 - u)^n <= 1 - 8 u needs n a little above 8
CALLED = 2.0 * ULP * (1.0 + 2.0**-18)

SECOND = 1.0 + 2.0**-8  # what errors of errors add
GREATEST_EXPONENT = 700.0  # exp of it is a number of float64; of float32 what may overflow is seen


def turned(over: Reference, under: Reference, apart: float) -> Reference:
    """The angle of two legs whose terms may cancel, where the root of the sum of their squares is
    at least `apart`: errors e and f of theirs turn it by (e |x| + f |y|)/(x^2 + y^2) at most, to
    first order. They are below 2^-9 of that root, since the error of the sum of the squares is
    below 2^-10 of it (see `reference.required`), so that second order is a 2^-8 more. So its
    reference is its magnitude, and what that makes of the references of both (see
    `known_values.scales`). Where x < 0 the sign of y, which an error may change, decides between
    angles that differ by 2 pi: that is one direction.

    PrintingError where nothing keeps the legs from 0.
    """
    if not apart:
        raise PrintingError("atan2 of an uncertain value")
    count = max(over.count, under.count)
    high = (over.high + under.high) / apart * LARGER
    stray = (over.stray + under.stray) / apart * SECOND
    found = (count + CALLED) * SECOND, _least_angle(over, under), 3.1416 + high
    return Reference(*found, over.sign, True, False, stray)


def _least_angle(over: Reference, under: Reference) -> float:
    """atan t >= t pi/4 for t <= 1; against 0 the angle is a right one."""
    return 0.78 * (min(over.low / under.high / LARGER, 1.0) if under.high else 1.0)


def called(name: str, parts: list[Reference], form: Format) -> Reference:
    """A function of a library, with `CALLED` for its own error."""
    first = parts[0]
    match name:
        case "sin" | "cos" if first.count > 0:
            raise PrintingError(f"{name} of a computed number")
        case "sin":
            sign = first.sign if Fraction(first.high) <= 3 else 0
            return Reference(CALLED, least_sine(first.low, first.high, form), 1.0, sign, first.zero)
        case "cos":
            sign = 1 if first.high <= math.pi / 2 else 0  # the number, which is below
            return Reference(CALLED, least_cosine(first.high, form), 1.0, sign, False)
        case "hypot":
            low, high = min(part.low for part in parts), sum(part.high for part in parts)
            count = max(part.count for part in parts) + CALLED
            return Reference(count, low, high * LARGER, 1, all(part.zero for part in parts))
        case "atan2":
            # |d log angle/d log of either argument| is at most 1: sin 2t <= 2t
            count = sum(part.count for part in parts) + CALLED
            over, under = parts
            return Reference(count, _least_angle(over, under), 3.1416, over.sign, True)
        case "exp" | "expm1" if first.sign == 0:
            raise PrintingError(f"{name} of what may have either sign")
        case "exp" | "expm1" if first.high > GREATEST_EXPONENT:
            raise PrintingError(f"{name} of what may be above {GREATEST_EXPONENT}")
        case "exp":
            # exp(t d), |d| <= n u/(1 - n u): as many roundings as |t| is large
            count = first.count * first.high * (1.0 + 2.0**-10) + CALLED
            if first.sign > 0:
                return Reference(count, 1.0, math.exp(first.high) * LARGER, 1, False)
            return Reference(count, math.exp(-first.high) * 0.99, 1.0, 1, False)
        case "expm1" if first.sign > 0:
            # the logarithmic slope t/(1 - e^-t) is at most 1 + t, and e^t - 1 at least t
            count = first.count * (1.0 + first.high) * (1.0 + 2.0**-10) + CALLED
            high = math.expm1(first.high) * LARGER
            return Reference(count, first.low / LARGER, high, 1, first.zero)
        case "expm1":
            # below 0 the logarithmic slope t e^t/(e^t - 1) lies between 0 and 1; (e^t - 1)/t > 0.6
            count, low = first.count + CALLED, 0.6 * min(first.low, 1.0)
            return Reference(count, low, 1.0, -1, first.zero)
        case "log1p" if first.sign <= 0:
            raise PrintingError("log1p of what may be negative")
        case "log1p":
            # the logarithmic slope t/((1 + t) log(1 + t)) is at most 1; concave, and log 2 > 0.69
            count, low = first.count + CALLED, 0.69 * min(first.low, 1.0)
            return Reference(count, low, math.log1p(first.high) * LARGER, 1, first.zero)
    raise PrintingError(f"{name} is no function of a kernel")
