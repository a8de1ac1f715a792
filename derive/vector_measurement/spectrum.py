"""The innovation spectrum of a scaled model with position and velocity measured.

On the unit circle det(D R D* + q Q0)/det R with D = zI - F, D* = (I/z - F)' is sigma^2 c(z) c(1/z):
sigma^2 = det(P + R)/det R, and c(z) = det(zI - F(I - K)) is the closed-loop polynomial. The left
side comes from the model alone; with v = 2 - z - 1/z it is v^2 + linear v + constant.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.model import ModelError, ScaledModel
from gainproof.derive.steady_state.spectrum import in_v
from gainproof.derive.vector_measurement.names import INDEX, Z, gain_matrix
from gainproof.derive.vector_measurement.process_noise import HALF, Noise

V = sp.Symbol("v", real=True)


@dataclass(frozen=True)
class Spectrum:
    """Coefficients of the spectrum in v, over Lambda and S, and the numbers of the noise."""

    linear: sp.Expr
    constant: sp.Expr
    noise: Noise

    @property
    def polynomial(self) -> sp.Expr:
        """The spectrum in v."""
        return V**2 + self.linear * V + self.constant

    @property
    def at_minus_one(self) -> sp.Expr:
        """The spectrum at z = -1, where v = 4."""
        return sp.expand(self.polynomial.subs(V, 4))


def spectral_matrix(model: ScaledModel) -> sp.ImmutableDenseMatrix:
    """D R D* + q Q0."""
    identity = sp.eye(2)
    forward = Z * identity - model.transition
    backward = (identity / Z - model.transition).T
    noise = INDEX**2 * model.process_noise
    return sp.ImmutableDenseMatrix(forward * model.measurement_noise * backward + noise)


def closed_loop(model: ScaledModel) -> sp.Expr:
    """c(z) = det(zI - F(I - K)) over the named gains."""
    matrix = model.transition * (sp.eye(2) - gain_matrix() * model.measurement)
    return sp.collect(sp.expand((Z * sp.eye(2) - matrix).det()), Z)


def factorise(model: ScaledModel) -> Spectrum:
    """The spectrum in v and the numbers e and n of the process noise.

    Raises ModelError for another model than position and velocity, both measured and moving as
    kinematics says, and for a process noise of another shape: n = 1/2 with e in [0, 1], or n = 0
    with e = 1, are in reach.
    """
    if model.measurement != sp.eye(2) or model.transition != sp.Matrix([[1, 1], [0, 1]]):
        raise ModelError(
            f"model {model.name}: a position and its rate, both measured, are wanted; F is "
            f"{model.transition.tolist()}, H is {model.measurement.tolist()}"
        )
    determinant = sp.expand(spectral_matrix(model).det() / model.measurement_noise.det())
    poly = sp.Poly(in_v(determinant, 2), V)
    if poly.coeff_monomial(V**2) != 1:
        raise ModelError(
            f"model {model.name}: independent errors of the measurements are wanted, R is "
            f"{model.measurement_noise.tolist()}"
        )
    noise = _noise(model)
    return Spectrum(poly.coeff_monomial(V), sp.factor(poly.coeff_monomial(1)), noise)


def _noise(model: ScaledModel) -> Noise:
    first, cross, second = (model.process_noise[ij] for ij in ((0, 0), (0, 1), (1, 1)))
    n = Fraction(str(sp.Rational(cross / second)))
    e = 1 - 4 * n + 4 * Fraction(str(sp.Rational(first / second)))
    if not (n == HALF and 0 <= e <= 1) and not (n == 0 and e == 1):
        raise ModelError(
            f"model {model.name}: Q12/Q22 = 1/2 and noise(4)/noise(0) in [0, 1], or 0 and 1, are "
            f"wanted; they are {n} and {e}"
        )
    return Noise(e, n)
