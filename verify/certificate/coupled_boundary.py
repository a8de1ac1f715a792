"""The values of generators at an end of a parameter's domain, shown by their rescaled relations.

Of a coupled pair (`coupled_roots`) x = X t^-v, y = Y t^-w with t -> 0 the rescaled equations are
X^2 = A + B Y and Y^2 = C + E X with A = t^(2v) a, B = t^(2v - w) b, C = t^(2w) c, E = t^(2w - v) e;
none of them may hold a negative power of t, so that they tend to some A0, B0, C0, E0 >= 0, and X
and Y stay bounded: X^2 <= A + B sqrt(C + E X). Every limit of X and Y along a sequence then solves
the equations at t = 0 and is not negative. There is one such solution where B0 = 0 or E0 = 0: the
one root gives the other. Elsewhere X Y >= B E, shown in `coupled_roots`, keeps the limits positive,
and there is one positive solution, also shown there. So X and Y tend to what solves the equations
at t = 0, is not negative, and is positive unless B0 or E0 vanishes for all values of the parameters
that are held.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.rejection import RejectedError

if TYPE_CHECKING:
    from gainproof.verify.certificate.boundary import Boundary


def require_root(boundary: Boundary, index: int, root: Polynomial, place: str) -> None:
    """Reject unless a nonnegative value solves a generator's rescaled relation at the boundary."""
    generator = boundary.field.generators[index]
    weight = generator.power * boundary.weights[index]
    right = _at_boundary(boundary, generator.radicand, weight, place)
    if not boundary.constants.is_zero(root**generator.power - right):
        raise RejectedError(f"{place}: not a root of the rescaled relation at the boundary")


def require_pair(
    boundary: Boundary, index: int, roots: tuple[Polynomial, Polynomial], place: str
) -> None:
    """The same for two coupled generators, of which ``index`` is the first."""
    pair, constants = boundary.field.generators[index].pair, boundary.constants
    assert pair is not None
    linked: list[Polynomial] = []
    for own, other in ((0, 1), (1, 0)):
        weight = 2 * boundary.weights[index + own]
        free = _at_boundary(boundary, pair.free[own], weight, place)
        slope = _at_boundary(
            boundary, pair.slopes[own], weight - boundary.weights[index + other], place
        )
        if not constants.is_zero(roots[own] ** 2 - free - slope * roots[other]):
            raise RejectedError(f"{place}: not a root of the rescaled relation at the boundary")
        linked.append(slope)
    if any(constants.is_zero(slope) for slope in linked):
        return
    if not all(constants.positive(root) for root in roots):
        raise RejectedError(f"{place}: the values of a coupled pair are not manifestly positive")


def _at_boundary(
    boundary: Boundary, coefficient: Polynomial, weight: int, place: str
) -> Polynomial:
    """The value there of a polynomial in earlier variables, times the power of t."""
    zero = boundary.constants.ring.constant(0)
    if not coefficient:
        return zero
    order, value = boundary.lowest_terms(coefficient)
    if order + weight < 0:
        raise RejectedError(
            f"{place}: the weight is too small, the rescaled relation has a negative power of x"
        )
    return value if order + weight == 0 else zero
