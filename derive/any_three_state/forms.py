"""Forms of a quantity without a subtraction, or with both of its parts known: found by a search.

A quantity of the steady state is a polynomial in the roots, of many signs. Times a product of
positive sums of the roots and reduced by the relations it is another one, and for some products
every sign is plain: the form is that polynomial over the product. The sums are N = d(1); d(s) at
the places s = (1 - r)/(1 + r) that mirror the real poles r of the model, since d(s) d(-s) holds the
noise alone there; and d_k + g_k, since d_k^2 - g_k^2 is a sum of positive terms. Nothing here is
believed: each form is a statement of the certificate.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations_with_replacement

import sympy as sp

from gainproof.derive.algebra.tower import Fraction, Poly, Tower
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.monomials import Term, against_others, terms_of
from gainproof.derive.any_three_state.names import ROOTS, TOTAL
from gainproof.derive.model import ModelError

MOST_FACTORS = 5
EFFORT = (20_000, 5_000, 800)  # terms of all products tried: without, with one, with more numbers
LONGEST = 150  # terms of a quantity itself, parameters multiplied out: more would not be checked


@dataclass(frozen=True)
class Form:
    """(sum of plus - sum of minus)/product of below; every term and factor is positive."""

    plus: tuple[Term, ...]
    minus: tuple[Term, ...]
    below: tuple[sp.Expr, ...]

    @property
    def cancels(self) -> bool:
        """Whether both parts are there."""
        return bool(self.plus) and bool(self.minus)


def multipliers(shape: Shape) -> list[sp.Expr]:
    """Positive sums of the roots."""
    found = [TOTAL]
    for pole in _real_poles(shape):
        away, near = shape.readable(1 - pole), shape.readable(1 + pole)
        weights = [away**k * near ** (3 - k) for k in range(4)]
        plain = all(w.is_Rational for w in weights)
        scale = sp.ilcm(*(sp.denom(w) for w in weights)) if plain else 1
        found.append(sp.Add(*(root * w * scale for root, w in zip(ROOTS, weights, strict=True))))
    for root, own, noise in zip(ROOTS, shape.open_loop, shape.shaken, strict=True):
        moves = shape.sign(noise) != 0 or root in ROOTS[1:3]
        if moves and shape.sign(own) > 0:
            found.append(root + own)
    return [*found, *ROOTS[1:3]]


def _real_poles(shape: Shape) -> list[sp.Expr]:
    """Eigenvalues of the transition, rational in the parameters, between -1 and 1."""
    z = sp.Symbol("z")
    _, factors = sp.factor_list((z * sp.eye(3) - shape.model.transition).det(), z)
    found = []
    for factor, _power in factors:
        if sp.degree(factor, z) != 1:
            continue
        pole = sp.factor(-sp.Poly(factor, z).nth(0) / sp.Poly(factor, z).nth(1))
        try:
            inside = shape.sign(1 - pole) > 0 and shape.sign(1 + pole) > 0
        except ModelError:
            continue
        if inside:
            found.append(pole)
    return found


def find(shape: Shape, tower: Tower, value: Fraction, more: tuple[sp.Expr, ...] = ()) -> Form:
    """The form of a value over the sums `more`: without a subtraction where the search finds one.

    The value's denominator is a positive number of the model. Raises ModelError for a value too
    long to search.
    """
    if len(value.num) > LONGEST:
        raise ModelError(
            f"model {shape.model.name}: with its free numbers multiplied out a quantity has "
            f"{len(value.num)} terms, more than {LONGEST}: no form is looked for"
        )
    known = [(entry, tower.fraction(entry)) for entry in multipliers(shape)]
    best: tuple[int, tuple[int, ...], Poly] | None = None
    sums = [entry.num for _, entry in known]
    for chosen, product in _products(tower, value.num, sums):
        against = against_others(shape, tower, product)
        if best is None or against < best[0]:
            best = against, chosen, product
        if against == 0:
            break
    assert best is not None
    _, chosen, product = best
    bottom = tower.expression(Fraction(value.den, tower.ring.one))
    for place in chosen:
        bottom *= tower.expression(Fraction(known[place][1].den, tower.ring.one))
    plus, minus = terms_of(shape, tower, product, bottom)
    return Form(plus, minus, (*more, *(known[place][0] for place in chosen)))


def _products(
    tower: Tower, value: Poly, known: list[Poly]
) -> Iterator[tuple[tuple[int, ...], Poly]]:
    """The quantity times each product of the sums, few factors first."""
    limit = EFFORT[min(len(tower.parameters), len(EFFORT)) - 1]
    made: dict[tuple[int, ...], Poly] = {(): value}
    yield (), value
    tried = 0
    for degree in range(1, MOST_FACTORS + 1):
        for chosen in combinations_with_replacement(range(len(known)), degree):
            before = made.get(chosen[:-1])
            if before is None or tried > limit:
                continue
            made[chosen] = tower.reduce(before * known[chosen[-1]])
            tried += len(made[chosen])
            yield chosen, made[chosen]
