"""The numbers of a three-state model that its steady state is made of.

With z = (1 + s)/(1 - s), (1 - s)^3 det(zI - F) is g(s) = g3 s^3 + g2 s^2 + g1 s + g0, and the
numerator of the noise's spectrum H adj(zI - F) Q0 adj(I/z - F)' H' times (1 - s^2)^3 is
(1 + u)(n0 + n1 u + n2 u^2) with u = -s^2. g(s) g(-s) is a polynomial in u as well.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from gainproof.derive.any_two_state.domain import FreeNumbers
from gainproof.derive.any_two_state.model_numbers import MeasuredFirst, require_first_measured
from gainproof.derive.model import Model, ScaledModel

S, U = sp.Symbol("s", real=True), sp.Symbol("u", real=True)
Four = tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]


@dataclass(frozen=True)
class Shape(MeasuredFirst):
    """A scaled model of three states with H = [1, 0, 0], R = 1."""

    @cached_property
    def open_loop(self) -> Four:
        """g0, g1, g2, g3; their sum is 8."""
        whole = ((1 + S) * sp.eye(3) - (1 - S) * self.model.transition).det()
        found = sp.Poly(sp.expand(whole), S)
        g0, g1, g2, g3 = (self.readable(found.coeff_monomial(S**k)) for k in range(4))
        return g0, g1, g2, g3

    @cached_property
    def noise_numerator(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """n0, n1, n2."""
        product = (self._line(S) * self.model.process_noise * self._line(-S).T)[0, 0]
        found = sp.Poly(sp.expand(sp.expand(product).subs(S, sp.sqrt(-U))), U)
        n0, n1, n2 = (self.readable(found.coeff_monomial(U**k)) for k in range(3))
        return n0, n1, n2

    def _line(self, s: sp.Expr) -> sp.MatrixBase:
        """(1 - s)^2 H adj(zI - F) at z = (1 + s)/(1 - s)."""
        inner = (1 + s) * sp.eye(3) - (1 - s) * self.model.transition
        return sp.ImmutableDenseMatrix(self.model.measurement * inner.adjugate())

    @cached_property
    def still(self) -> Four:
        """The coefficients of g(s) g(-s) in u."""
        g0, g1, g2, g3 = self.open_loop
        found = (g0**2, g1**2 - 2 * g0 * g2, g2**2 - 2 * g1 * g3, g3**2)
        f0, f1, f2, f3 = map(self.readable, found)
        return f0, f1, f2, f3

    @cached_property
    def shaken(self) -> Four:
        """The coefficients of (1 + u)(n0 + n1 u + n2 u^2)."""
        n0, n1, n2 = self.noise_numerator
        return n0, self.readable(n0 + n1), self.readable(n1 + n2), n2

    @cached_property
    def closed_loop(self) -> tuple[sp.ImmutableDenseMatrix, sp.ImmutableDenseMatrix]:
        """W and w with K = W (d0, d1, d2, d3)'/N - w: the gains over the roots, N their sum.

        From det(zI - F (I - K H)) = det(zI - F) + H adj(zI - F) F K, whose coefficients of z^2, z
        and 1 are those of (z + 1)^3 d((z - 1)/(z + 1))/N.
        """
        matrix, one = self.model.transition, sp.eye(3)
        z = sp.Symbol("z")
        a2, a1, a0 = sp.Poly(sp.expand((z * one - matrix).det()), z).all_coeffs()[1:]
        second = matrix + a2 * one
        rows = sp.Matrix.vstack(
            *(self.model.measurement * m for m in (one, second, matrix * second + a1 * one))
        )
        inverse = (rows * matrix).inv()
        closed = sp.Matrix([[3, 1, -1, -3], [3, -1, -1, 3], [1, -1, 1, -1]])
        own = inverse * sp.Matrix([a2, a1, a0])
        return (
            sp.ImmutableDenseMatrix((inverse * closed).applyfunc(sp.factor)),
            sp.ImmutableDenseMatrix(own.applyfunc(sp.factor)),
        )


def shape_of(model: Model, scaled: ScaledModel) -> Shape:
    """The shape. Raises ModelError unless the first state is measured, with unit gain and noise."""
    require_first_measured(model, scaled)
    return Shape(scaled, FreeNumbers(model.parameters))
