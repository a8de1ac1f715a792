"""The relative error of a kernel's outputs in double-words, proved over a domain of its input.

Each step adds what its algorithm errs by (see `shipped/_double_word.py`; the factor 1 + its bound
times that of its operands, sums of positive terms the larger one's). These hold where the remainder
of a product is a float64, so every step's magnitude is enclosed by powers of 2 and has to keep far
from both ends of float64.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.double_word.refinement import ends, refined
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import Step

U = Fraction(1, 2**53)
ROOT_EXPONENT = 160
SUM = 3 * U**2 + 13 * U**3
PRODUCT = 7 * U**2
QUOTIENT = 15 * U**2 + 56 * U**3
ROOT = Fraction(25, 8) * U**2
CONSTANT = U**2
MOST = Fraction(1, 2**30)
ROOTS = Fraction(1, 2**ROOT_EXPONENT), Fraction(2**ROOT_EXPONENT)
"""Roots that are refined lie between; who makes such a kernel says why."""
FARTHEST = 900
"""Exponents of 2 between which products and their remainders are exact."""


class DoubleWordError(ValueError):
    """A kernel whose graph has no bound in double-words, with its name and the reason."""


@dataclass(frozen=True)
class Size:
    """Of a positive step: 2^low <= true value <= 2^high, and its relative error."""

    low: int
    high: int
    error: Fraction


def units(kernel: Kernel) -> float:
    """Units in the last place of float64 that any output is farther off than half a unit.

    A result is the double-word's larger part, the float64 nearest to it, and a unit is at least
    2^-53 of it. Rounded once more, to float32, it is off by half a unit of float32 and at most
    2^-28 more. DoubleWordError if it would be more than `MOST`.
    """
    assert kernel.accurate is not None
    found = max(errors(kernel, *ends(kernel.accurate))) / U
    if found > MOST:
        raise DoubleWordError(f"{kernel.name}: errs by half a unit and {float(found):.3g} more")
    return math.nextafter(float(found), math.inf)


def errors(kernel: Kernel, low: Fraction, high: Fraction) -> tuple[Fraction, ...]:
    """Of each output, before the last rounding, for every input from `low` to `high`.

    DoubleWordError for a step that is none of + * / and square root of positive numbers, and for
    one whose magnitude is not seen to keep between 2^-900 and 2^900.
    """
    program = kernel.accurate_program
    sizes: list[Size] = []
    for step in program.steps:
        found = _size(kernel, step, sizes, _ends_of(kernel, step, (low, high)))
        if kernel.refinement and step.label == kernel.refinement.root:
            image = sizes[program.outputs[kernel.refinement.image]]
            found = Size(found.low, found.high, refined(image.error, U))
        if not -FARTHEST <= found.low <= found.high <= FARTHEST:
            raise DoubleWordError(
                f"{kernel.name}: {step.label} has a size from 2^{found.low} to 2^{found.high}, "
                f"double-words take 2^-{FARTHEST} to 2^{FARTHEST}"
            )
        sizes.append(found)
    return tuple(sizes[program.outputs[output.name]].error for output in kernel.outputs)


def _ends_of(
    kernel: Kernel, step: Step, ends: tuple[Fraction, Fraction]
) -> tuple[Fraction, Fraction]:
    """Least and greatest value of an input."""
    wanted = kernel.refinement
    return ROOTS if wanted and step.label in (wanted.near, wanted.root) else ends


def _size(kernel: Kernel, step: Step, sizes: list[Size], ends: tuple[Fraction, Fraction]) -> Size:
    parts = [sizes[number] for number in step.operands]
    if step.scale is not None:
        (part,) = parts
        power = _exponents(Fraction(step.scale), Fraction(step.scale))[0]
        return Size(part.low + power, part.high + power, part.error)
    match step.operation, parts:
        case "input", []:
            return Size(*_exponents(*ends), Fraction(0))
        case "constant", [] if step.constant is not None and step.constant.rational is not None:
            value = step.constant.rational
            if value > 0:
                return Size(*_exponents(value, value), CONSTANT)
        case "add", [a, b]:
            high = max(a.high, b.high) + 1
            return Size(max(a.low, b.low), high, (1 + max(a.error, b.error)) * (1 + SUM) - 1)
        case "mul", [a, b]:
            error = (1 + a.error) * (1 + b.error) * (1 + PRODUCT) - 1
            return Size(a.low + b.low, a.high + b.high, error)
        case "div", [a, b]:
            error = (1 + a.error) / (1 - b.error) * (1 + QUOTIENT) - 1
            return Size(a.low - b.high, a.high - b.low, error)
        case "sqrt", [a]:
            # the root of 1 + e is no farther from 1 than 1 + e
            return Size(a.low // 2, -(-a.high // 2), (1 + a.error) * (1 + ROOT) - 1)
    raise DoubleWordError(
        f"{kernel.name}: {step.label} is a step of operation {step.operation}, double-words are "
        "bounded for + * / and square roots of positive numbers"
    )


def _exponents(low: Fraction, high: Fraction) -> tuple[int, int]:
    """Powers of 2 around positive numbers."""
    below = low.numerator.bit_length() - low.denominator.bit_length()
    below -= Fraction(2) ** below > low
    above = high.numerator.bit_length() - high.denominator.bit_length()
    above += Fraction(2) ** above < high
    return below, above
