"""Polynomials of a tower as products of factors whose coefficients all have one sign.

What does not show its sign is drawn apart into generators and irreducible factors; a factor is
multiplied by its conjugate, (a - b y)(a + b y) = a^2 - b^2 r with y^2 = r, or by powers of 1 + t:
a polynomial that is positive for every t >= 0, at infinity too, has no negative coefficient after
enough of them (Polya). What is left has no sign, or none that was found.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.stable_form.normal_form import linear
from gainproof.derive.stable_form.polynomial_products import Product, of_poly

DRAWN = "square roots drawn out as common factors"
FACTORED = "polynomials factored"
CONJUGATE = "difference of roots multiplied by its conjugate"
POLYA = "positive polynomial multiplied by powers of 1 + t until no coefficient is negative"
GREATEST_POWER = 12  # of 1 + t
MOST_DRAWN = 12  # generators of one polynomial: a guard, each lowers a degree


def plain(poly: Poly) -> bool:
    """Whether all coefficients have one sign."""
    return len({value > 0 for value in poly.values()}) == 1


class Signs:
    """The search in one tower; `order`: places of generators, in which conjugates are tried.

    `divisors`: factors that stand below the line, which a product needs no sign of to cancel.
    """

    def __init__(self, tower: Tower, order: Sequence[int], divisors: Collection[Poly] = ()) -> None:
        self.tower, self.order, self.divisors = tower, order, divisors
        self.known: dict[Poly, Product] = {}

    def product(self, poly: Poly) -> Product:
        """The polynomial, not 0, as a product; factors that are not `plain` have no known sign."""
        if poly.is_ground:
            return of_poly(poly)
        if poly not in self.known:
            rest, drawn = self._drawn(poly)
            self.known[poly] = drawn * self._factors(rest)
        return self.known[poly]

    def _drawn(self, poly: Poly) -> tuple[Poly, Product]:
        """The polynomial without those generators that divide it."""
        tower, found = self.tower, Product(of_poly(poly.ring.one).constant)
        for position in reversed(range(len(tower.generators))):
            generator = poly.ring.gens[len(tower.parameters) + position]
            radicand = tower.radicands[position]
            if radicand.is_ground:
                continue
            for _ in range(MOST_DRAWN):
                quotient, rest = tower.reduce(poly * generator).div([radicand])
                if rest:
                    break
                (poly,) = quotient
                found = (found * of_poly(generator)).because(DRAWN)
        return poly, found

    def _factors(self, poly: Poly) -> Product:
        constant, factors = poly.factor_list()
        found = of_poly(poly.ring.ground_new(constant))
        if plain(poly) and not all(plain(factor) for factor, _ in factors):
            # as x^3 + 1 = (x + 1)(x^2 - x + 1)
            return self._without_monomial(poly)
        for factor, power in factors:
            part = of_poly(factor) if plain(factor) else self._signed(factor)
            found = found * part**power
        split = sum(power for factor, power in factors if not _is_variable(factor)) > 1
        return found.because(FACTORED) if split else found

    def _without_monomial(self, poly: Poly) -> Product:
        least = tuple(map(min, zip(*poly.keys(), strict=True)))
        content = poly.ring.term_new(least, poly.ring.domain.one)
        found = of_poly(poly.quo(content))
        for generator, power in zip(poly.ring.gens, least, strict=True):
            if power:
                found = found * of_poly(generator) ** power
        return found

    def _signed(self, poly: Poly) -> Product:
        for position in self.order:
            found = self._by_conjugate(poly, position)
            if found is not None:
                return found
        return self._by_powers(poly) or of_poly(poly)

    def _by_conjugate(self, poly: Poly, position: int) -> Product | None:
        index = len(self.tower.parameters) + position
        if poly.degree(index) < 1:
            return None
        other = poly - 2 * linear(poly, index)
        conjugate = self._plain(other)
        square = self.tower.reduce(poly * other)
        if conjugate is None or not square:
            return None
        found = self.product(square) * conjugate**-1
        fine = all(plain(factor) or factor in self.divisors for factor in found.powers)
        return found.because(CONJUGATE) if fine else None

    def _plain(self, poly: Poly) -> Product | None:
        """A product of factors of one sign each, if the polynomial needs no conjugate for it."""
        if plain(poly):
            return self._factors(poly)
        return self._by_powers(poly)

    def _by_powers(self, poly: Poly) -> Product | None:
        ring, times = poly.ring, poly.ring.one
        for number in range(len(self.tower.parameters)):
            if poly.degree(number) > 0:
                times *= ring.one + ring.gens[number]
        power = times
        for _ in range(GREATEST_POWER if times != ring.one else 0):
            whole = self.tower.reduce(poly * power)
            if plain(whole):
                return (of_poly(whole) * of_poly(power) ** -1).because(POLYA)
            power *= times
        return None


def _is_variable(poly: Poly) -> bool:
    return len(poly) == 1
