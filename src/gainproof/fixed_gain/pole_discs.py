"""Closed-loop poles of any alpha-beta-gamma filter, each in a disc that is proved to hold it.

Of u = z - 1 the poles are the roots of u^3 + s u^2 + b u + gamma, s = alpha + beta + gamma/2 and
b = beta + 3 gamma/2 (derivation alpha-beta-gamma, step reduced-cubic). A power of two takes u to a
size at which nothing overflows.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.cubic_discs import MORE, NOISE, centres, radii
from gainproof.fixed_gain.cubic_roots import Cubic, roots
from gainproof.fixed_gain.stability import moderate
from gainproof.fixed_gain.twofold import Twofold

Complex = NDArray[np.complex128]
BLOCK = 8192
"""Filters at once, so that their numbers stay in the second-level cache."""
SMALLEST = 2.0**-1070
"""More than what all parts of a pole lose below the smallest normal number."""


class PoleDiscs(NamedTuple):
    """Three closed-loop poles each, that of largest modulus first; the last axis has length 3.

    The true poles of the gains as floats can be numbered so that |z_i - poles_i| <= radii_i, and
    |z_i - 1 - less_one_i| <= less_one_radii_i with the same numbers: of small gains the second
    tells more.
    """

    poles: Complex
    radii: Reals
    less_one: Complex
    less_one_radii: Reals


def pole_discs(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> PoleDiscs:
    """The poles of any gains up to 1e100 in magnitude, stable or not, with a proved radius each.

    alpha, beta, gamma: numbers or arrays, broadcast together. `cubic_discs` holds the proof. How
    large a radius gets is not proved but seen, on ten million filters made to be hard: to 1.5 2^-53
    of |pole| or 1 where poles are apart, to 3e-14 of the largest |z - 1| at a double pole and to
    7e-10 of it where three agree.

    ValueError for NaN, infinity, larger gains and shapes that do not fit; TypeError for no real
    number.
    """
    gains = moderate((alpha, beta, gamma))
    flat = [gain.reshape(-1) for gain in gains]
    starts = range(0, max(gains[0].size, 1), BLOCK)
    with np.errstate(all="ignore"):
        blocks = [_block(*(gain[first : first + BLOCK] for gain in flat)) for first in starts]
    shape = (*gains[0].shape, 3)
    return PoleDiscs._make(
        np.concatenate(each).reshape(shape) for each in zip(*blocks, strict=True)
    )


def _block(alpha: Reals, beta: Reals, gamma: Reals) -> PoleDiscs:
    a, b, c = (Twofold.of(gain) for gain in (alpha, beta, gamma))
    # twice the coefficients: half of the least gamma is no float
    twice = a * 2 + b * 2 + c, (c * 2 + c) + b * 2, c * 2
    exponent = _exponent(*(each.high for each in twice))
    cubic = Cubic(*(_scaled(x, -k * exponent - 1) for k, x in enumerate(twice, start=1)))
    found = roots(cubic)
    columns = [
        _column(real, aside, radius, exponent)
        for (real, aside), radius in zip(centres(found), radii(cubic, found), strict=True)
    ]
    discs = PoleDiscs._make(np.stack(each, axis=-1) for each in zip(*columns, strict=True))
    order = np.argsort(-np.abs(discs.poles), axis=-1, kind="stable")
    return PoleDiscs._make(np.take_along_axis(each, order, axis=-1) for each in discs)


def _exponent(a: Reals, b: Reals, c: Reals) -> NDArray[np.intc]:
    """Of a power of two that is at least |a|, |b|^(1/2) and |c|^(1/3) of twice the coefficients."""
    sizes = np.abs(a), np.sqrt(np.abs(b)), np.cbrt(np.abs(c))
    exponent: NDArray[np.intc] = np.frexp(np.maximum.reduce(sizes) * MORE)[1]
    return exponent


def _scaled(x: Twofold, exponent: NDArray[np.intc]) -> Twofold:
    return Twofold(np.ldexp(x.high, exponent), np.ldexp(x.low, exponent))


def _column(real: Twofold, aside: Twofold, radius: Reals, exponent: NDArray[np.intc]) -> PoleDiscs:
    """One pole of each filter: its disc about the nearest floats."""
    x, y = _scaled(real, exponent), _scaled(aside, exponent)
    z = x + 1.0
    wide = (np.ldexp(radius, exponent) + np.abs(y.low)) * MORE + SMALLEST
    return PoleDiscs(
        _complex(z.high, y.high),
        (wide + np.abs(z.low) + NOISE * np.abs(z.high)) * MORE,
        _complex(x.high, y.high),
        (wide + np.abs(x.low)) * MORE,
    )


def _complex(real: Reals, aside: Reals) -> Complex:
    found = np.empty(real.shape, np.complex128)
    found.real, found.imag = real + 0.0, aside + 0.0  # -0 becomes 0
    return found
