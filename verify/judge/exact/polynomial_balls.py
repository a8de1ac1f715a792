"""Polynomials at balls."""

from __future__ import annotations

import flint

from gainproof.verify.judge.exact.polynomial import (
    Ball,
    Poly,
    terms,
)


def evaluate(p: Poly, values: list[Ball | None]) -> Ball:
    """The polynomial at these balls, at the current working precision; not finite where a value is
    missing.
    """
    total = flint.arb(0)
    powers: dict[int, list[Ball]] = {}
    for exponents, coefficient in terms(p):
        product = flint.arb(flint.fmpq(coefficient))
        for index, exponent in enumerate(exponents):
            if not exponent:
                continue
            value = values[index]
            if value is None:
                return flint.arb.nan()
            # by multiplication: arb's own power is not a number for a ball that contains zero
            known = powers.setdefault(index, [flint.arb(1)])
            while len(known) <= exponent:
                known.append(known[-1] * value)
            product = product * known[exponent]
        total = total + product
    return total
