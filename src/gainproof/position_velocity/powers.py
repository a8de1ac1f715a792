"""Products of powers that leave the range of float64 only where their value does.

sigma_a T^2/sigma_o can be an ordinary number while T^2 is not one. Exponents are therefore taken
apart and summed as integers: only the mantissas, between 1/2 and 1, are multiplied.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Factor = tuple[Reals, int]


def product(*factors: Factor) -> Reals:
    """The product of each number raised to its power, a small integer.

    Each multiplication or division rounds once, so that the relative error is at most their
    number times 2^-53 (and second-order terms); a result outside the normal numbers comes as
    infinity, a subnormal number or 0. Numbers must not be negative or NaN; infinity and 0 pass
    only with power 1.
    """
    mantissa, exponent = _apart(factors)
    with np.errstate(over="ignore", under="ignore"):
        return np.asarray(np.ldexp(mantissa, exponent))


def _apart(factors: Iterable[Factor]) -> tuple[Reals, NDArray[np.intc]]:
    mantissa: Reals = np.ones(())
    exponent: NDArray[np.int64] = np.zeros((), np.int64)
    for number, power in factors:
        part, shift = np.frexp(number)
        for _ in range(abs(power)):
            mantissa = mantissa * part if power > 0 else mantissa / part
        exponent = exponent + power * shift.astype(np.int64)
    # the type that ldexp takes on every system
    return mantissa, np.clip(exponent, -(2**20), 2**20).astype(np.intc)
