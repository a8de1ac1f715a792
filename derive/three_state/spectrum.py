"""The innovation spectrum of a scaled three-state model, on the circle and on a half line.

With c the closed-loop polynomial and S the innovation variance, on the unit circle
det(zI - F) det(I/z - F) + q noise(z) = S c(z) c(1/z). At z = (1 + s)/(1 - s) the circle becomes
the imaginary axis; with u = -s^2, v = 2 - z - 1/z = 4u/(1 + u), and (1 + u)^3 times the left side
is 64 u^3 + q (1 + u)(1 + m1 u + m2 u^2).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.model import ModelError, ScaledModel
from gainproof.derive.steady_state.spectrum import V, in_v
from gainproof.derive.three_state.names import U, Z, gain_vector


@dataclass(frozen=True)
class Spectrum:
    """What the model says before anything is solved.

    noise: numerator of the noise spectrum as a polynomial in v. closed_loop: c(z) in the gains.
    m1, m2: numbers of the noise's second factor (1 + m1 u + m2 u^2).
    """

    noise: sp.Expr
    closed_loop: sp.Expr
    m1: Fraction
    m2: Fraction

    @property
    def a1(self) -> Fraction:
        """Coefficient of u in (1 + u)(1 + m1 u + m2 u^2)."""
        return 1 + self.m1

    @property
    def a2(self) -> Fraction:
        """Coefficient of u^2."""
        return self.m1 + self.m2

    @property
    def e(self) -> Fraction:
        """Coefficient of u^3."""
        return self.m2

    @property
    def rational_in_root(self) -> bool:
        """Whether all gains and the index are rational in the root of 1 - alpha."""
        return self.m1 == 1 and self.m2 == 0


def closed_loop_matrix(model: ScaledModel) -> sp.ImmutableDenseMatrix:
    """F (I - K H), whose eigenvalues are the poles of the filter."""
    return sp.ImmutableDenseMatrix(
        model.transition * (sp.eye(3) - gain_vector() * model.measurement)
    )


def noise_factors(model: ScaledModel) -> tuple[sp.ImmutableDenseMatrix, ...]:
    """H adj(zI - F), Q and adj(I/z - F)' H', whose product is the numerator."""
    forward = (Z * sp.eye(3) - model.transition).adjugate()
    backward = (sp.eye(3) / Z - model.transition).adjugate()
    row, column = model.measurement * forward, (model.measurement * backward).T
    return (
        sp.ImmutableDenseMatrix(row).applyfunc(sp.factor),
        model.process_noise,
        sp.ImmutableDenseMatrix(column).applyfunc(sp.factor),
    )


def factorise(model: ScaledModel) -> Spectrum:
    """The spectrum of a kinematic model of three states.

    Raises ModelError unless det(zI - F) det(I/z - F) is v^3, and unless the noise has no negative
    coefficient in u.
    """
    identity = sp.eye(3)
    if model.transition.shape != (3, 3) or model.measurement.shape != (1, 3):
        raise ModelError(
            f"model {model.name}: three states and one measurement are wanted, the transition is "
            f"{model.transition.shape}, the measurement matrix {model.measurement.shape}"
        )
    transition = model.transition
    product = (Z * identity - transition).det() * (identity / Z - transition).det()
    open_loop = in_v(sp.expand(product), 3)
    if sp.expand(open_loop - V**3) != 0:
        raise ModelError(
            f"model {model.name}: a position and its two rates are wanted, with "
            f"det(zI - F) det(I/z - F) = v^3; it is {open_loop}"
        )
    row, noise, column = noise_factors(model)
    numerator = in_v(sp.expand((row * noise * column)[0, 0]), 2)
    polynomial = sp.Poly(sp.cancel(numerator.subs(V, 4 * U / (1 + U)) * (1 + U) ** 2), U)
    constant, m1, m2 = (polynomial.coeff_monomial(U**n) for n in range(3))
    if constant != 1 or m1 < 0 or m2 < 0:
        raise ModelError(
            f"model {model.name}: a process noise whose spectrum on the unit circle, as a "
            f"polynomial in tan(angle/2)^2, has no negative coefficient is wanted; it is "
            f"{polynomial.as_expr()} times (1 + u)"
        )
    inner = Z * identity - closed_loop_matrix(model)
    closed_loop = sp.collect(sp.expand(inner.det()), Z)
    return Spectrum(numerator, closed_loop, Fraction(str(m1)), Fraction(str(m2)))
