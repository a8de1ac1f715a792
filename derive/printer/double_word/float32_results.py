"""Accurate results in float32: those of the float64 kernel, rounded once more.

A float64 result keeps 29 bits more than float32 shows, so that nothing is gained by double-words.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.double_word.refinement import ends
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.step_ranges import PrintingError

MOST = Fraction(1, 100)


def single_units(kernel: Kernel, plain: KernelBound) -> float:
    """Units in the last place of float32 that any output is farther off than half a unit.

    A unit is more than 2^-24 of a true value, and B * 2^-52 of this is what float64 errs by.
    PrintingError if it would be more than `MOST`, or float64 is not bounded on all of the domain.
    """
    assert kernel.accurate is not None
    low, high = ends(kernel.accurate)
    least = FLOAT32.at_least(max(low, Fraction(FLOAT32.least)))
    most = FLOAT32.at_most(min(high, Fraction(FLOAT32.largest)))
    found = max(each.bound for each in plain.outputs) / 2**28
    within = all(each.lowest <= least and most <= each.highest for each in plain.outputs)
    if plain.format is not FLOAT64 or found > MOST or not within:
        raise PrintingError(f"{kernel.name}: float64 errs by too much to be accurate in float32")
    return math.nextafter(float(found), math.inf)


def single_lines(kernel: Kernel) -> Iterator[str]:
    """Statements that give in double-words what is asked in float32."""
    yield "if form.single:"
    yield "    # float64 keeps 29 bits more than come out"
    yield f"    return evaluate(_{kernel.name.upper()}, exact(given)[:1], None, 1)"
