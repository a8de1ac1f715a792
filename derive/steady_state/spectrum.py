"""The innovation spectrum of a scaled two-state model and what its factorisation says.

With c the closed-loop polynomial and S the innovation variance, on the unit circle
det(zI - F) det(I/z - F) + q noise(z) = S c(z) c(1/z): the left side comes from the model, the
right side holds the gains.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.model import ModelError, ScaledModel
from gainproof.derive.steady_state.names import ALPHA, BETA, INDEX, Z

V = sp.Symbol("v", real=True)


@dataclass(frozen=True)
class Spectrum:
    """What spectral factorisation gives.

    noise: numerator of the noise spectrum as a polynomial in v = 2 - z - 1/z.
    ratio: e = noise(4)/noise(0). closed_loop: c(z) in alpha, beta.
    relation: the polynomial in alpha and beta that vanishes.
    """

    noise: sp.Expr
    ratio: sp.Rational
    closed_loop: sp.Expr
    relation: sp.Expr


def gain_vector() -> sp.ImmutableDenseMatrix:
    """The filter gain (alpha, beta) in units T = 1."""
    return sp.ImmutableDenseMatrix([[ALPHA], [BETA]])


def closed_loop_matrix(model: ScaledModel) -> sp.ImmutableDenseMatrix:
    """F (I - K H), whose eigenvalues are the poles of the filter."""
    identity = sp.eye(2)
    return sp.ImmutableDenseMatrix(
        model.transition * (identity - gain_vector() * model.measurement)
    )


def noise_numerator(model: ScaledModel) -> sp.MatMul:
    """H adj(zI - F) Q adj(I/z - F)' H', not multiplied out."""
    forward = (Z * sp.eye(2) - model.transition).adjugate()
    backward = (sp.eye(2) / Z - model.transition).adjugate()
    row, column = model.measurement * forward, (model.measurement * backward).T
    return sp.MatMul(
        sp.ImmutableDenseMatrix(row),
        model.process_noise,
        sp.ImmutableDenseMatrix(column),
        evaluate=False,
    )


def in_v(expression: sp.Expr, degree: int) -> sp.Expr:
    """A Laurent polynomial that is symmetric under z -> 1/z, as a polynomial in v = 2 - z - 1/z."""
    unknown = sp.symbols(f"a0:{degree + 1}")
    candidate = sp.Add(*(entry * V**n for n, entry in enumerate(unknown)))
    difference = sp.expand((candidate.subs(V, 2 - Z - 1 / Z) - expression) * Z**degree)
    solution = sp.solve(sp.Poly(difference, Z).coeffs(), unknown, dict=True)
    if not solution:
        raise ModelError(f"the spectrum should be symmetric under z -> 1/z, it is {expression}")
    return sp.expand(candidate.subs(solution[0]))


def factorise(model: ScaledModel) -> Spectrum:
    """Compare coefficients of the innovation spectrum and eliminate q and S.

    Raises ModelError unless det(zI - F) det(I/z - F) is v^2, that is for kinematic transitions.
    """
    open_loop = in_v(
        sp.expand(
            (Z * sp.eye(2) - model.transition).det() * (sp.eye(2) / Z - model.transition).det()
        ),
        2,
    )
    if sp.expand(open_loop - V**2) != 0:
        raise ModelError(
            f"model {model.name}: a position and its rate are wanted, with "
            f"det(zI - F) det(I/z - F) = v^2; it is {open_loop}"
        )
    noise = in_v(sp.expand(noise_numerator(model).as_explicit()[0, 0]), 1)
    closed_loop = sp.collect(sp.expand((Z * sp.eye(2) - closed_loop_matrix(model)).det()), Z)
    variance, ratio = sp.symbols("S q")
    product = in_v(sp.expand(closed_loop * closed_loop.subs(Z, 1 / Z)), 2)
    difference = sp.Poly(V**2 + ratio * noise - variance * product, V)
    constant, linear, square = (difference.coeff_monomial(V**n) for n in range(3))
    innovation = sp.solve(square, variance)[0]
    strength = sp.solve(constant.subs(variance, innovation), ratio)[0]
    remaining = sp.numer(sp.together(linear.subs(ratio, strength).subs(variance, innovation)))
    relation = sp.Poly(sp.factor(remaining), ALPHA, BETA)
    factors = [factor for factor, _ in relation.factor_list()[1] if factor.has(BETA)]
    return Spectrum(
        noise,
        sp.Rational(noise.subs(V, 4) / noise.subs(V, 0)),
        closed_loop,
        _positive_lead(factors[-1].as_expr()),
    )


def _positive_lead(relation: sp.Expr) -> sp.Expr:
    poly = sp.Poly(relation, ALPHA, BETA).clear_denoms(convert=True)[1].primitive()[1]
    return poly.as_expr() if poly.coeff_monomial(ALPHA**2) > 0 else -poly.as_expr()


def index_equation(spectrum: Spectrum) -> sp.Expr:
    """sigma c(-1) with alpha = 1 - 1/sigma^2 and beta = Lambda/sigma, where sigma^2 = S."""
    sigma = sp.Symbol("innovation_deviation", real=True)
    at_minus_one = spectrum.closed_loop.subs(Z, -1)
    value = sigma * at_minus_one.subs({ALPHA: 1 - 1 / sigma**2, BETA: INDEX / sigma})
    return sp.expand(value)
