"""Products of the terms of two polynomials with integer coefficients."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.certificate.rejection import MAXIMUM_TERMS, RejectedError

Terms = Mapping[int, int]
"""Coefficients by monomial, each a number (`monomials`)."""


def product_of(first: Terms, second: Terms) -> dict[int, int]:
    """The terms of the product, whose exponents have to be within their digits; some may be zero.

    RejectedError if there are too many.
    """
    short, long = sorted((first, second), key=len)
    row = list(long.items())
    found: dict[int, int] = {}
    known = found.get
    for left, factor in short.items():
        if not found:  # no two products of one term with others meet
            found.update([(left + right, factor * c) for right, c in row])
        else:
            for right, c in row:
                monomial = left + right
                found[monomial] = known(monomial, 0) + factor * c
        if len(found) > MAXIMUM_TERMS:
            raise RejectedError(f"a polynomial grew beyond {MAXIMUM_TERMS} terms")
    return found
