"""Common factors of two polynomials in several variables, found by FLINT.

SymPy's own gcd of sparse polynomials is in Python: towers of radicals spent a sixth of all
derivations in it. What is divided out is checked by the division, which leaves no remainder; that
it is the greatest decides how short a fraction is written, never whether it is right.
"""

from __future__ import annotations

import flint

from gainproof.derive.algebra.variables import Poly


def without_common_factor(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    """Numerator and denominator divided by their greatest common divisor, up to one constant.

    `num` and `den` are polynomials over the rationals in one ring, neither 0.
    """
    if num.is_ground or den.is_ground:
        return num, den
    context = flint.fmpq_mpoly_ctx.get(("x", num.ring.ngens), flint.Ordering.lex)
    top, bottom = (context.from_dict(_rationals(poly)) for poly in (num, den))
    common = top.gcd(bottom)
    if common.is_constant():
        return num, den
    return _element(num, top / common), _element(num, bottom / common)


def _rationals(poly: Poly) -> dict[tuple[int, ...], flint.fmpq]:
    """The terms as FLINT takes them, whatever rationals SymPy computes with."""
    if poly.ring.domain.dtype is flint.fmpq:
        return dict(poly)
    return {powers: flint.fmpq(int(c.numerator), int(c.denominator)) for powers, c in poly.items()}


def _element(like: Poly, poly: flint.fmpq_mpoly) -> Poly:
    """The polynomial in the ring of another."""
    rational = like.ring.domain
    terms = {tuple(map(int, powers)): c for powers, c in poly.to_dict().items()}
    if rational.dtype is not flint.fmpq:
        terms = {powers: rational(int(c.p), int(c.q)) for powers, c in terms.items()}
    return like.ring.from_dict(terms)
