"""The root of a + b y, with y^2 = r, as the sum or the difference of two roots.

With d^2 = a^2 - b^2 r the two are those of (a + d)/2 and (a - d)/2: their sum where b is positive.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.stable_form.normal import linear


def halves(tower: Tower, poly: Poly) -> Iterator[tuple[Poly, Poly]]:
    """(a + d)/2 and (a - d)/2 for every generator y for which d is a polynomial."""
    for position in reversed(range(len(tower.generators))):
        index = len(tower.parameters) + position
        if poly.degree(index) != 1:
            continue
        rooted = linear(poly, index)
        free = poly - rooted
        root = _root(tower.reduce(free * free - rooted * rooted))
        if root is not None:
            yield (free + root).quo_ground(2), (free - root).quo_ground(2)


def _root(poly: Poly) -> Poly | None:
    """The polynomial whose square this is, of either sign."""
    if not poly:
        return None
    constant, factors = poly.factor_list()
    number = sp.sqrt(poly.ring.domain.to_sympy(constant))
    if not number.is_Rational or any(power % 2 for _, power in factors):
        return None
    found = poly.ring.ground_new(poly.ring.domain.from_sympy(number))
    for factor, power in factors:
        found *= factor ** (power // 2)
    return found
