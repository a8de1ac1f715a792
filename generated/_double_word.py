"""Double-words: sums of two float64 with 106 digits, for kernels that are asked to be accurate.

Algorithms 6, 10 and 17 of Joldes, Muller and Popescu (2017), of Lefevre, Louvet, Muller, Picot and
Rideau (2023) for the root; products by Dekker and Veltkamp, since NumPy has no fused multiply-add.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from gainproof.generated._signature import Array

    Part: TypeAlias = NDArray[np.float64] | float
    Pair: TypeAlias = tuple[Part, Part]

SPLIT = 134217729.0  # 2^27 + 1


def exact(x: Array | float) -> Pair:
    """Numbers of either type as they are."""
    return x.astype(np.float64) if isinstance(x, np.ndarray) else float(x), 0.0


def add(a: Pair, b: Pair) -> Pair:
    """The sum, 3 u^2 + 13 u^3 off with u = 2^-53."""
    high = a[0] + b[0]
    part = high - a[0]
    low = a[1] + b[1]
    lower = low - a[1]
    rest = (a[1] - (low - lower)) + (b[1] - lower)
    high, low = _short(high, ((a[0] - (high - part)) + (b[0] - part)) + low)
    return _short(high, rest + low)


def multiply(a: Pair, b: Pair) -> Pair:
    """The product, 7 u^2 off."""
    high, low = _product(a[0], b[0])
    return _short(high, low + (a[0] * b[1] + a[1] * b[0]))


def scale(a: Pair, power: float) -> Pair:
    """Times a power of 2, exactly."""
    return a[0] * power, a[1] * power


def divide(a: Pair, b: Pair) -> Pair:
    """The quotient, 15 u^2 + 56 u^3 off."""
    first = a[0] / b[0]
    high, low = _product(b[0], first)
    high, rest = _short(high, b[1] * first)
    high, low = _short(high, rest + low)
    return _short(first, ((a[0] - high) + (a[1] - low)) / b[0])


def root(a: Pair) -> Pair:
    """The square root, 25/8 u^2 off."""
    first: Part = sqrt(a[0]) if isinstance(a[0], float) else np.sqrt(a[0])
    high, low = _product(first, first)
    return _short(first, (a[1] + ((a[0] - high) - low)) / (2.0 * first))


def refined(near: Pair, image: Pair, slope: Pair) -> Pair:
    """The root of x = f(x) from a float64 near it, f there, and the logarithmic slope of f."""
    off = (image[0] - near[0]) + image[1]
    high, low = _short(image[0], off * slope[0] / (1.0 - slope[0]))
    return _short(high, low + image[1])


def _short(a: Part, b: Part) -> Pair:
    """a + b with a the larger, and what its rounding leaves."""
    total = a + b
    return total, b - (total - a)


def _product(a: Part, b: Part) -> Pair:
    """a b, and what its rounding leaves."""
    product = a * b
    (high, low), (front, back) = _halves(a), _halves(b)
    return product, low * back - (((product - high * front) - low * front) - high * back)


def _halves(a: Part) -> Pair:
    """Two numbers of at most 26 bits each whose sum is a."""
    wide = SPLIT * a
    high = wide - (wide - a)
    return high, a - high
