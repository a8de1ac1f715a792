"""The steady covariance over the process noise: the linear map and what each entry of Q counts."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, lyapunov_map, pairs, tidy

NOISE = "q"

STABLE = {"alpha": "1/2", "beta": "1/4", "gamma": "1/16"}
"""Gains inside, where a sign is looked up."""


def inverse(loop: Loop) -> tuple[sp.ImmutableDenseMatrix, sp.Expr]:
    """The inverse of the map as numerators over one denominator, which is positive inside."""
    found = DomainMatrix.from_Matrix(lyapunov_map(loop))
    domain = found.domain
    numerators, denominator = found.inv_den()
    shared = denominator
    for line in numerators.to_list():
        for entry in line:
            shared = domain.gcd(shared, entry)
    common = sp.factor(domain.to_sympy(domain.quo(denominator, shared)))
    at = {real(name): sp.Rational(value) for name, value in STABLE.items()}
    sign = sp.sign(common.subs(at))
    above = numerators.to_Matrix().applyfunc(
        lambda x: sign * sp.factor(sp.cancel(x / domain.to_sympy(shared)))
    )
    return above.as_immutable(), 1 / tidy(1 / (sign * common))


Shares = dict[str, dict[tuple[str, str], sp.Expr]]


def noise_shares(loop: Loop) -> Shares:
    """What each entry of Q counts in each entry of D, after prediction and update, in the gains."""
    above, below = inverse(loop)
    names = pairs(loop.size)
    found: Shares = {"predicted": {}, "updated": {}}
    for j, kl in enumerate(names):
        matrix = symmetric_of(loop.size, [above[i, j] / below for i in range(len(names))])
        after = loop.rest * matrix * loop.rest.T
        for i, ij in enumerate(names):
            row_, column = int(ij[0]) - 1, int(ij[1]) - 1
            found["predicted"][ij, kl] = above[i, j] / below
            found["updated"][ij, kl] = sp.factor(after[row_, column])
    return found


def symmetric_of(size: int, entries: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of the entries of its upper triangle."""
    named = dict(zip(pairs(size), entries, strict=True))
    return sp.ImmutableDenseMatrix(
        size, size, lambda i, j: named[f"{min(i, j) + 1}{max(i, j) + 1}"]
    )
