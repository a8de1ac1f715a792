"""Products, quotients, roots and scalings of values over boxes."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.interval import Array
from gainproof.derive.printer.step_ranges import Value, like, none_as_zero, sum_of, true_size

ABSORBED = 2.0**-7  # of a rounding: an absolute error of a sum below it joins its relative error


def product(a: Value, b: Value, unit: float) -> Value:
    """a b."""
    slope = interval.signed_add(a.slope, b.slope)
    value = Value(interval.multiply(a.size, b.size), slope, a.sign * b.sign)
    value.drift, value.rounding = sum_of(a.drift, b.drift, unit), unit
    value.loose = a.loose or b.loose
    if value.loose:
        value.true_size = interval.multiply(true_size(a), true_size(b))
    if a.stray is not None or b.stray is not None:
        lost_a, lost_b = none_as_zero(a.stray), none_as_zero(b.stray)
        crossed = lost_a * b.size[1][0] + lost_b * a.size[1][0] + lost_a * lost_b
        value.stray = np.fmin(4.0 * crossed, np.inf)
    return value


def quotient(a: Value, b: Value, unit: float) -> Value:
    """a/b; proves nothing where b has an absolute error, being possibly subnormal."""
    slope = interval.signed_add(a.slope, (-b.slope[1], -b.slope[0]))
    value = Value(interval.divide(a.size, b.size), slope, a.sign * b.sign)
    value.drift, value.rounding = sum_of(a.drift, b.drift, unit), unit
    value.loose = a.loose
    if value.loose:
        value.true_size = interval.divide(true_size(a), b.size)
    if a.stray is not None:
        value.stray = np.fmin(4.0 * a.stray / b.size[0][0], np.inf)
    if b.stray is not None:
        value.invalid = b.stray > 0
    return value


def root(part: Value, unit: float) -> Value:
    """The square root; proves nothing of negative numbers, nor of those with an absolute error."""
    slope = part.slope[0] / 2, part.slope[1] / 2
    value = Value(interval.square_root(part.size), slope, part.sign)
    value.drift, value.rounding = sum_of(part.drift, unit), unit
    wrong = part.sign < 0
    if part.stray is not None:
        wrong = wrong | (part.stray > 0)
    value.invalid = wrong if interval.somewhere(wrong) else None
    return value


def scaled(part: Value, power: float) -> Value:
    """A value times a power of two, without rounding."""
    value = like(part, part.sign)
    value.size = interval.scale(part.size, power)
    if part.true_size is not None:
        value.true_size = interval.scale(part.true_size, power)
    if part.stray is not None:
        value.stray = part.stray * power
    return value


def with_stray(value: Value, strays: list[Array | None], unit: float) -> Value:
    """A sum with absolute errors of its operands: part of its drift where it is much larger."""
    present = [stray for stray in strays if stray is not None]
    if present:
        total = sum(present[1:], present[0])
        absorbed = total <= ABSORBED * unit * value.size[0][0]
        value.drift = sum_of(value.drift, 2.0 * ABSORBED * unit)
        value.stray = None if interval.everywhere(absorbed) else np.where(absorbed, 0.0, total)
    return value
