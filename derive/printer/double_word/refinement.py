"""What a root x = f(x) errs by that is refined in double-words from a float64 near it.

f maps positive numbers to such with a logarithmic slope l between 0 and 1/4, which changes by at
most 3/32 of the logarithm's way. With t = log x, t0 = log x0 and t1 = log f(x0) the root has
t - t1 = l'/(1 - l') (t1 - t0) with the slope l' somewhere on the way; x1 = f(x0) + m (f(x0) - x0),
m = l/(1 - l), takes l at x0. With |t - t0| <= d <= 2^-40 these differ by no more than

- d^2/8 as the slope changes,
- d^2 as differences of logarithms are taken for relative ones,
- d^2 as l is taken from delta/(xi eta), which is exact at the root alone: off by 2 d of itself, and
  m <= 1/3,

in all 2.2 d^2; f(x0), known within e, counts 1 + m <= 4/3 times; m, of numbers known within 8 u and
their few roundings, is known within 64 u, f(x0) - x0 is exact before its last addition, so the
correction is off by at most 67 u of itself, which is below d/3; the two last additions by 3 u^2.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Input, Kernel
from gainproof.derive.printer.step_ranges import PrintingError

NEAR_UNITS = 80
"""x0 has at most so many times 2^-53 as its relative error."""


def refined(image: Fraction, unit: Fraction) -> Fraction:
    """The root's relative error from that of f(x0)."""
    near = NEAR_UNITS * unit
    further = Fraction(11, 5) * near**2 + 67 * unit * near / 3 + 4 * unit**2
    return (1 + Fraction(4, 3) * image) * (1 + further) - 1


def start_is_near(kernel: Kernel, plain: KernelBound) -> None:
    """PrintingError where the root's start is not shown to be near it, by bounds of float64."""
    wanted = kernel.refinement
    if wanted is None:
        return
    assert kernel.accurate is not None
    known = {output.name: output for output in plain.outputs}
    both = [known[wanted.over], known[wanted.under]]
    units = sum(2 * each.bound for each in both) + 1  # a bound of 2^-52 is two of 2^-53
    low, high = ends(kernel.accurate)
    within = all(each.lowest <= low and high <= each.highest for each in both)
    if plain.format is not FLOAT64 or units * (1 + Fraction(1, 2**30)) > NEAR_UNITS or not within:
        raise PrintingError(f"{kernel.name}: the start of its root errs by {float(units)} * 2^-53")


def ends(given: Input) -> tuple[Fraction, Fraction]:
    """Least and greatest number of a domain that has both."""
    assert given.upper is not None
    return constant(given.lower).between()[0], constant(given.upper).between()[1]
