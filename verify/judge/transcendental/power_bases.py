"""Bases of the powers in a product."""

from __future__ import annotations

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.transcendental.monomials import monomials, ordered, terms_expr

MOST_FACTORS = 1_000_000
"""A larger number is a base of its own."""


def bases_of(base: Expr) -> dict[Expr, int]:
    """A product of powers as base -> exponent, numbers as their primes; else the whole base."""
    terms = monomials(base)
    if len(terms) != 1:
        return {terms_expr(terms): 1}
    ((monomial, c),) = terms.items()
    found = {terms_expr(monomials(each)): n for each, n in ordered(monomial)}
    for value, sign in ((abs(c.numerator), 1), (c.denominator, -1)):
        for prime, n in _primes(value).items():
            found[number(prime)] = found.get(number(prime), 0) + sign * n
    if c < 0:
        found[number(-1)] = 1
    return found


def _primes(value: int) -> dict[int, int]:
    if value > MOST_FACTORS:
        return {value: 1}
    found: dict[int, int] = {}
    prime = 2
    while value > 1:
        if prime * prime > value:
            prime = value
        while value % prime == 0:
            found[prime] = found.get(prime, 0) + 1
            value //= prime
        prime += 1
    return found
