"""Factors of the norm of a tower element: only where one of them is zero can the element vanish."""

from __future__ import annotations

from typing import Any

from gainproof.verify.judge.exact.polynomial import (
    Poly,
    coefficients_in,
    constant,
    degree,
    grouped,
    text,
    univariate,
)
from gainproof.verify.judge.exact.tower import Root, Tower
from gainproof.verify.judge.exact.work_limits import Undecided


def highest_root(tower: Tower, p: Poly) -> Root | None:
    """The last made root that occurs in p."""
    for root in reversed(tower.roots):
        if degree(p, root.index) > 0:
            return root
    return None


def cofactor(tower: Tower, p: Poly, root: Root) -> Poly:
    """q such that p q holds no more of `root`; p must be reduced.

    Order 2, p = a + b t: q = a - b t. Order 3, p = a + b t + c t^2: q = a^2 + b^2 t^2 + c^2 t^4 - a
    b t - a c t^2 - b c t^3, half a sum of squares of real numbers.
    """
    t = tower.context.gen(root.index)
    if root.order == 2:
        a, b = coefficients_in(p, root.index, 2)
        return a - b * t
    a, b, c = coefficients_in(p, root.index, 3)
    return a**2 + b**2 * t**2 + c**2 * t**4 - a * b * t - a * c * t**2 - b * c * t**3


def vanishing_factors(tower: Tower, p: Poly) -> list[Any]:
    """`ground_factors` in a tower with one parameter, as irreducible integer polynomials; none
    without a parameter. Raises Undecided.
    """
    if tower.parameter_index is None:
        return []
    found: dict[tuple[int, ...], Any] = {}
    for ground in ground_factors(tower, p):
        whole = univariate(ground, tower.parameter_index)
        for factor, _ in whole.factor()[1]:
            found.setdefault(tuple(int(c) for c in factor.coeffs()), factor)
    return list(found.values())


def ground_factors(tower: Tower, p: Poly, *, careful: bool = False) -> list[Poly]:
    """Polynomials of the parameters: where p vanishes without vanishing on a whole connected open
    set on which none of them is zero, one of them is zero.

    The norm of p has p as a factor. If the norm is the zero polynomial then on every such set p or
    its cofactor vanishes identically; where the cofactor does, p is a multiple of its own constant
    coefficient, which is therefore taken too. Coefficients of monomials in free symbols are taken
    one by one. `careful` takes the constant coefficients always: then the same holds on connected
    sets on which one of the polynomials is zero throughout and no other is zero. Raises Undecided.
    """
    found: dict[str, Poly] = {}
    for part in grouped(tower.reduce(p), tower.free_indices).values():
        _collect(tower, part, found, careful)
    return list(found.values())


def _collect(tower: Tower, p: Poly, found: dict[str, Poly], careful: bool) -> bool:
    """Adds the factors of p; whether the norm of p is a nonzero polynomial."""
    p = tower.reduce(p)
    if p.is_zero():
        return False
    complete = True
    for factor, _ in p.factor()[1]:
        complete &= _collect_factor(tower, factor, found, careful)
    return complete


def _collect_factor(tower: Tower, p: Poly, found: dict[str, Poly], careful: bool) -> bool:
    root = highest_root(tower, p)
    if root is None:
        if sum(p.degrees()) > tower.limits.norm_degree:
            raise Undecided(f"a norm of degree more than {tower.limits.norm_degree}")
        if not p.is_constant():
            found.setdefault(text(p), p)
        return True
    lower = tower.reduce(p * cofactor(tower, p, root))
    whole = not lower.is_zero() and _collect(tower, lower, found, careful)
    if careful or not whole:
        _collect(tower, coefficients_in(p, root.index)[0], found, careful)
    return whole


def norm(tower: Tower, p: Poly) -> Poly:
    """The product of p and its cofactors, free of roots; the zero polynomial if p is a zero
    divisor.
    """
    p = tower.reduce(p)
    while (root := highest_root(tower, p)) is not None:
        p = tower.reduce(p * cofactor(tower, p, root))
        if p.is_zero():
            return constant(tower.context, 0)
    return p
