"""How large the values of a kernel are somewhere, and the powers of its input that they follow.

A value is written x^q g, where q is the exponent of the largest terms: far out g then changes
little over many octaves. Any q would be right; these are those that make enclosures of g narrow.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import log2

from gainproof.certify.operations import Operation


@dataclass(frozen=True)
class Size:
    """About sign * 2^log; follows x^power, times unknown^of_unknown while that is not known."""

    log: float
    sign: int
    power: Fraction
    of_unknown: Fraction = Fraction(0)


def logarithm(value: Fraction) -> float:
    """To base 2, of a positive number of any size."""
    shift = value.numerator.bit_length() - value.denominator.bit_length()
    return shift + log2(float(value / Fraction(2) ** shift))


def sizes(operations: Sequence[Operation], inputs: Mapping[int, Size]) -> dict[int, Size]:
    """Of every operation, from those of the inputs, and of others that are known."""
    found: dict[int, Size] = {}
    for operation in operations:
        parts = [found[part] for part in operation.parts]
        size = inputs.get(operation.number)
        found[operation.number] = _size(operation, parts) if size is None else size
    return found


def _size(operation: Operation, parts: list[Size]) -> Size:
    factor = operation.factor
    match operation.kind:
        case "constant":
            return Size(logarithm(abs(factor)), 1 if factor > 0 else -1, Fraction(0))
        case "scale":
            (a,) = parts
            return Size(a.log + logarithm(factor), a.sign, a.power, a.of_unknown)
        case "neg":
            (a,) = parts
            return Size(a.log, -a.sign, a.power, a.of_unknown)
        case "sqrt":
            (a,) = parts
            return Size(a.log / 2, 1, a.power / 2, a.of_unknown / 2)
    a, b = parts
    if operation.kind in ("add", "sub"):
        return _sum(a, b, b.sign if operation.kind == "add" else -b.sign)
    turn = 1 if operation.kind == "mul" else -1
    return Size(
        a.log + turn * b.log,
        a.sign * b.sign,
        a.power + turn * b.power,
        a.of_unknown + turn * b.of_unknown,
    )


def _sum(a: Size, b: Size, sign: int) -> Size:
    """Of a and a number of b's size and this sign."""
    large, small = (a, b) if a.log >= b.log else (b, a)
    large_sign = a.sign if large is a else sign
    ratio = 2.0 ** max(small.log - large.log, -1000.0)
    whole = 1.0 + (ratio if a.sign == sign else -ratio)
    # of equal sizes nothing is left to see: the enclosures decide
    return Size(large.log + log2(max(whole, 2.0**-60)), large_sign, large.power, large.of_unknown)
