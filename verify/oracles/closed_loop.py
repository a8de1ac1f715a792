"""Closed-loop poles, certified, from the exact innovation spectrum.

Part of the ball oracle: the roots of the spectrum come in pairs z, 1/z, and those inside the unit
circle are the poles of the stabilising solution. python-flint isolates the roots of the rational
polynomial with certainty; which of a pair lies inside is decided in balls.
"""

from __future__ import annotations

import flint

from gainproof.verify.oracles.spectrum import Spectrum


class Unresolved(Exception):
    """The working precision does not yet decide; more bits are needed."""


def distances_from_one(spectrum: Spectrum, q: flint.fmpq) -> list[flint.acb]:
    """x = 1 - z for each closed-loop pole z, certified inside the unit circle.

    A root v of the spectrum belongs to the pair of roots of x^2 - v x + v = 0, whose z are
    reciprocal. Kept as distances from 1 because slow filters have all their poles there.
    """
    polynomial = spectrum.still + q * spectrum.driven
    found: list[flint.acb] = []
    roots: list[tuple[flint.acb, int]] = polynomial.numer().complex_roots()  # type: ignore[assignment]  # its stub names one root
    for v, multiplicity in roots:
        if v.abs_lower() == 0:
            raise Unresolved
        # one factor under each root: the product v (v - 4) can be negative for complex v
        root = v.sqrt() * (v - 4).sqrt()
        plus, minus = (v + root) / 2, (v - root) / 2
        larger = plus if plus.abs_lower() > minus.abs_lower() else minus
        pair = [x for x in (larger, v / larger) if _inside(x)]
        if len(pair) != 1:
            raise Unresolved
        found += pair * int(multiplicity)
    # roots v that have gone to infinity are poles z = 0
    return found + [flint.acb(1)] * (spectrum.model.size - len(found))


def _inside(x: flint.acb) -> bool:
    """Whether |1 - x| < 1 is certain."""
    return bool(x.real * x.real + x.imag * x.imag < 2 * x.real)


def expand(distances: list[flint.acb]) -> list[flint.arb]:
    """Coefficients in powers of x of the product of (x_i - x); real because poles pair up."""
    product = flint.acb_poly([1])
    for distance in distances:
        product = product * flint.acb_poly([distance, -1])
    return [product[k].real for k in range(len(distances) + 1)]
