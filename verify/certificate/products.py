"""Products of the terms of two polynomials with integer coefficients."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from math import prod
from operator import add, mul

from gainproof.verify.certificate.rejection import MAXIMUM_TERMS, RejectedError

Monomial = tuple[int, ...]
Terms = Mapping[Monomial, int]

# Places of a list cost a third of what a pair of terms costs that makes its own key.
_PLACES_A_PAIR = 3
_FEW_PAIRS = 32
# Terms of the shorter one from which places pay in a table too.
_SEVERAL = 12


def product_of(first: Terms, second: Terms, degrees: Sequence[int]) -> dict[Monomial, int]:
    """The terms of the product, which has these degrees; some may be zero.

    RejectedError if there are too many.
    """
    pairs = len(first) * len(second)
    places = prod(degree + 1 for degree in degrees)
    short, long = sorted((first, second), key=len)
    if pairs > _FEW_PAIRS and places <= min(_PLACES_A_PAIR * pairs, MAXIMUM_TERMS):
        return _by_places(short, long, degrees)
    return _by_pairs(short, long, degrees)


def _by_places(short: Terms, long: Terms, degrees: Sequence[int]) -> dict[Monomial, int]:
    """In a list with a place for every monomial that the degrees allow, for most are there.

    The place is the exponents read as the digits of a number, so that places add as exponents do.
    """
    sizes, strides = _digits(degrees)
    row = [(sum(map(mul, monomial, strides)), c) for monomial, c in long.items()]
    total = [0] * prod(sizes)
    for monomial, factor in short.items():
        start = sum(map(mul, monomial, strides))
        for place, c in row:
            total[start + place] += factor * c
    monomials = product(*map(range, sizes))
    return {monomial: c for monomial, c in zip(monomials, total, strict=True) if c}


def _by_pairs(short: Terms, long: Terms, degrees: Sequence[int]) -> dict[Monomial, int]:
    """Pair by pair, where few monomials are there.

    Their places stand for them until all are found: a sum of numbers costs less than a new tuple.
    """
    if len(short) < _SEVERAL:
        return _one_by_one(short, long)
    _, strides = _digits(degrees)
    row = [(sum(map(mul, monomial, strides)), c) for monomial, c in long.items()]
    found: dict[int, int] = {}
    made: dict[int, Monomial] = {}
    for monomial, factor in short.items():
        start = sum(map(mul, monomial, strides))
        for (place, c), other in zip(row, long, strict=True):
            total = start + place
            if total in found:
                found[total] += factor * c
            else:
                found[total] = factor * c
                made[total] = tuple(map(add, monomial, other))
        if len(found) > MAXIMUM_TERMS:
            raise RejectedError(f"a polynomial grew beyond {MAXIMUM_TERMS} terms")
    return {made[total]: c for total, c in found.items()}


def _one_by_one(short: Terms, long: Terms) -> dict[Monomial, int]:
    """The same with their exponents themselves."""
    found: dict[Monomial, int] = {}
    for left, first in short.items():
        if not found:  # no two products of one term with others meet
            found = {tuple(map(add, left, m)): first * c for m, c in long.items()}
        else:
            for right, second in long.items():
                monomial = tuple(map(add, left, right))
                found[monomial] = found.get(monomial, 0) + first * second
        if len(found) > MAXIMUM_TERMS:
            raise RejectedError(f"a polynomial grew beyond {MAXIMUM_TERMS} terms")
    return found


def _digits(degrees: Sequence[int]) -> tuple[list[int], list[int]]:
    """How many exponents there are for each variable, and what one of them counts in a place."""
    sizes = [degree + 1 for degree in degrees]
    return sizes, [prod(sizes[variable + 1 :]) for variable in range(len(sizes))]
