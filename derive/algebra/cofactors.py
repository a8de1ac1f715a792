"""Division by the monic relations of a tower, quotients kept."""

from __future__ import annotations

from gainproof.derive.algebra.tower import Poly, Tower


class NotInIdeal(ArithmeticError):
    """A polynomial that should vanish in the tower and does not."""


def cofactors(tower: Tower, poly: Poly) -> list[Poly]:
    """c with poly = sum of c_g (y_g^n_g - radicand_g), one c per generator.

    Raises NotInIdeal when a remainder is left.
    """
    quotients: list[Poly] = [tower.ring.zero] * len(tower.generators)
    if any(generator.partner for generator in tower.generators):
        raise NotInIdeal(f"tower {tower.name} has coupled generators: no division in order")
    for position in reversed(range(len(tower.generators))):
        index = len(tower.parameters) + position
        power, radicand = tower.generators[position].power, tower.radicands[position]
        while poly.degree(index) >= power:
            quotient = tower.ring.zero
            for exponents, coefficient in poly.terms():
                if exponents[index] >= power:
                    lowered = list(exponents)
                    lowered[index] -= power
                    quotient += tower.ring.term_new(tuple(lowered), coefficient)
            poly -= quotient * (tower.ring.gens[index] ** power - radicand)
            quotients[position] += quotient
    if poly:
        raise NotInIdeal(f"remainder {poly.as_expr()} in tower {tower.name}")
    return quotients
