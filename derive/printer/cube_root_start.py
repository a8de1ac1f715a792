"""Numbers near cube roots, from the bits of floating-point numbers.

The bits of a positive normal number x = 2^e (1 + f) are, but for a constant and a power of two, the
number e + f, which is log2(x) less at most 0.0861. A third of them, and a constant, are therefore
the bits of a number y near the cube root: log2(y) = log2(x)/3 + c + d with the d between -0.0861
and 0.0287 that both fractions leave. As x grows eightfold y is doubled, so that one period says
all; on it y is piecewise linear in x, and y^3/x has its extremes where a piece ends or at twice the
piece's zero with the sign turned. A test computes them as fractions for both formats.
"""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.interval import LEAST, Array, Interval

ERROR = 0.0325
"""The number is within a factor 1 + ERROR of the cube root."""

SHIFT = -0.033  # added to the logarithm to base 2: makes both errors alike

SLACK = 2.0**-40  # more than the roundings of a cube root by Newton's method


def added_bits(form: Format) -> int:
    """What is added to a third of the bits of a number."""
    bias = form.greatest_exponent << (form.digits - 1)
    return 2 * bias // 3 + round(SHIFT * 2.0 ** (form.digits - 1))


def cube_root(a: Interval) -> Interval:
    """An enclosure of the cube root; infinity for infinity."""
    low, high = _cube_root(a[0]), _cube_root(a[1])
    return (
        np.maximum(low * (1.0 - SLACK) - LEAST, 0.0),
        np.where(np.isinf(a[1]), np.inf, high * (1.0 + SLACK) + LEAST),
    )


def _cube_root(x: Array) -> Array:
    """Newton's method for y^3 = x from above, where x is 2^(3 k) times a number from 1/2 to 4.

    From a start at most 1.28 times too large the error r becomes less than r^2, five times.
    """
    finite = np.where(np.isfinite(x), x, 1.0)
    fraction, exponent = np.frexp(finite)
    k, rest = np.divmod(exponent, 3)
    part = np.ldexp(fraction, rest)
    y = (part + 2.0) / 3.0
    for _ in range(7):
        square = np.where(part > 0, y * y, 1.0)
        y = (2.0 * y + part / square) / 3.0
    return np.ldexp(np.where(part > 0, y, 0.0), k)
