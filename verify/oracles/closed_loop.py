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
    for v, multiplicity in roots_of(polynomial.numer()):
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


def roots_of(polynomial: flint.fmpz_poly) -> list[tuple[flint.acb, int]]:
    """All roots with their multiplicities; real ones have an imaginary part of exactly 0.

    Isolating roots nearly as close as two may be takes python-flint half a minute where the index
    is 1e200, so those of a cubic are Cardano's, in balls, where it has no multiple root.
    """
    if polynomial.degree() == 3:
        d, c, b, a = (polynomial[k] for k in range(4))
        second, third = b * b - 3 * a * c, 2 * b**3 - 9 * a * b * c + 27 * a * a * d
        apart = third * third - 4 * second**3  # -27 a^2 times the discriminant
        if apart != 0:
            return [(root, 1) for root in _cardano(a, b, second, third, apart)]
    roots: list[tuple[flint.acb, int]] = polynomial.complex_roots()  # type: ignore[assignment]  # its stub names one root
    return roots


def _cardano(
    a: flint.fmpz, b: flint.fmpz, second: flint.fmpz, third: flint.fmpz, apart: flint.fmpz
) -> list[flint.acb]:
    """-(b + w C + second/(w C))/(3 a) with the cube roots w of 1; C^3 is the larger of two."""
    turn = flint.acb(flint.arb(-1), flint.arb(3).sqrt()) / 2
    sign = -1 if third < 0 else 1
    if apart > 0:
        # one real root: C is real, and so is the first of the three
        cube = flint.acb(abs(flint.arb(third)) + flint.arb(apart).sqrt()) / 2
        factors = [flint.acb(1), turn, turn.conjugate()]
    else:
        # the real part is not negative: no branch of the cube root is near
        cube = flint.acb(abs(flint.arb(third)), flint.arb(-apart).sqrt()) / 2
        factors = [flint.acb(1), turn, turn * turn]
    c = cube.log()
    found = []
    for factor in factors:
        moved = sign * factor * (c / 3).exp()
        found.append(-(flint.acb(b) + moved + flint.acb(second) / moved) / (3 * flint.acb(a)))
    if apart > 0:
        return [flint.acb(found[0].real), *found[1:]]
    return [flint.acb(root.real) for root in found]


def _inside(x: flint.acb) -> bool:
    """Whether |1 - x| < 1 is certain."""
    return bool(x.real * x.real + x.imag * x.imag < 2 * x.real)


def expand(distances: list[flint.acb]) -> list[flint.arb]:
    """Coefficients in powers of x of the product of (x_i - x); real because poles pair up."""
    product = flint.acb_poly([1])
    for distance in distances:
        product = product * flint.acb_poly([distance, -1])
    return [product[k].real for k in range(len(distances) + 1)]
