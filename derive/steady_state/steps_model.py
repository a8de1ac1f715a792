"""Steps from the model to the gains: scaling, spectrum, factorisation, closed form."""

from __future__ import annotations

import re
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, described, equal, increasing_onto
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, ROOT, Z
from gainproof.derive.steady_state.spectrum import (
    V,
    closed_loop_matrix,
    index_equation,
    noise_numerator,
)
from gainproof.derive.steady_state.towers import ROOT_S, rational, root_of_16


def model_steps(c: Context) -> list[Step]:
    """The model, its scaling and its innovation spectrum."""
    v = 2 - Z - 1 / Z
    open_loop = (Z * sp.eye(2) - c.model.transition).det() * (
        sp.eye(2) / Z - c.model.transition
    ).det()
    return [
        Step(
            "model",
            f"{c.original.title}: the position is measured, the state moves by F and is shaken by "
            "a process noise of covariance Q.",
            described(_model_text(c)),
            "This is the model; everything below follows from it.",
        ),
        *_scaling_steps(c),
        Step(
            "index",
            "In units of the sampling interval and of the measurement's standard deviation the "
            "model has one number left, the tracking index Lambda; its square is the noise ratio.",
            definition(INDEX**2, c.model.noise_ratio),
            "What is left of the process noise is this ratio times a matrix of numbers.",
        ),
        Step(
            "open-loop",
            "Without measurements the spectrum is governed by v = 2 - z - 1/z.",
            equal(open_loop, v**2, free=("z",)),
            "The determinants of zI - F and I/z - F.",
        ),
        Step(
            "noise-spectrum",
            "The process noise reaches the measured position through this numerator; in v it is "
            f"{c.spectrum.noise}.",
            equal(
                noise_numerator(c.model),
                sp.ImmutableDenseMatrix([[c.spectrum.noise.subs(V, v)]]),
                free=("z",),
            ),
            "H adj(zI - F) Q adj(I/z - F)' H', written in v.",
        ),
        Step(
            "closed-loop",
            "With the gain K = (alpha, beta) the poles of the filter are the roots of c(z).",
            equal(
                (Z * sp.eye(2) - closed_loop_matrix(c.model)).det(),
                c.spectrum.closed_loop,
                free=("z",),
            ),
            "c(z) = det(zI - F(I - K H)).",
        ),
    ]


def _scaling_steps(c: Context) -> list[Step]:
    """The scaled matrices are the model's own, in the units of the scaling."""
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    free = tuple(quantity.name for quantity in c.original.quantities)
    scaled = {
        "transition": ((backward, c.original.transition, forward), c.model.transition),
        "process noise": (
            (backward, c.original.process_noise, backward),
            c.model.noise_ratio * c.model.process_noise,
        ),
    }
    return [
        Step(
            f"scaled-{name.replace(' ', '-')}",
            f"The {name} in units of the sampling interval and the measurement's deviation.",
            equal(
                sp.MatMul(*factors, evaluate=False),
                sp.ImmutableDenseMatrix(value),
                free=_used(free, factors),
            ),
            "A state of unit m^a s^b is measured in sigma_v^a T^b.",
        )
        for name, (factors, value) in scaled.items()
    ]


def _used(names: tuple[str, ...], factors: tuple[sp.ImmutableDenseMatrix, ...]) -> tuple[str, ...]:
    found = {str(symbol) for factor in factors for symbol in factor.free_symbols}
    return tuple(name for name in names if name in found)


def _model_text(c: Context) -> str:
    """The matrices in the model's own quantities, by rows."""
    plain = {
        quantity.symbol: sp.Symbol(re.sub(r"[\\{} ]|tilde", "", quantity.latex))
        for quantity in c.original.quantities
    }

    def rows(matrix: sp.ImmutableDenseMatrix) -> str:
        entries = matrix.subs(plain).tolist()
        texts = (", ".join(str(entry).replace("**", "^") for entry in row) for row in entries)
        return "[" + "; ".join(texts) + "]"

    return (
        f"F = {rows(c.original.transition)}, Q = {rows(c.original.process_noise)}, "
        f"H = {rows(c.original.measurement)}, R = {rows(c.original.measurement_noise)}"
    )


def _ratio_text(number: Fraction) -> str:
    return "Lambda" if number == 1 else f"({number}) Lambda"


def _high_text(c: Context) -> str:
    if c.e == 0:
        return "H = 4"
    return "H^2 = 16 + Lambda^2" if c.e == 1 else f"H^2 = 16 + ({c.e}) Lambda^2"


def gain_steps(c: Context) -> list[Step]:
    """Spectral factorisation solved for the gains."""
    v = 2 - Z - 1 / Z
    noise = c.spectrum.noise
    closed = c.spectrum.closed_loop
    high, ratio = root_of_16(c.e), rational(c.e)
    return [
        Step(
            "parameter",
            "Every positive index is the square of exactly one positive p.",
            increasing_onto(INDEX, sp.Integer(0), "infinity", variable="p"),
            "The square is increasing and unbounded.",
            hint={"form": 2 * ROOT, "ends": c.ends},
        ),
        Step(
            "variance",
            "The constant coefficient at v^2 gives the innovation variance sigma^2.",
            equal(DEVIATION**2, c.spectrum.variance),
            "Compare coefficients of v^2 in the factorisation.",
        ),
        Step(
            "velocity-gain",
            "At z = 1, where v = 0, the factorisation ties the velocity gain to the index.",
            equal(DEVIATION * BETA, INDEX),
            "The positive square root of q noise(0) = S c(1)^2.",
        ),
        Step(
            "other-end",
            "At z = -1, where v = 4, it gives an equation for sigma alone.",
            equal(index_equation(c.spectrum), high),
            f"The positive square root of 16 + q noise(4) = S c(-1)^2, with {_high_text(c)}.",
        ),
        Step(
            "deviation",
            "Its root above 1 is sigma; s is a root of positive terms only.",
            equal(DEVIATION, (ROOT**2 + high + 2 * ROOT * ROOT_S) / 4),
            "The quadratic sigma + 1/sigma = (Lambda + H)/2, with 4 s^2 = "
            f"{_ratio_text(1 + c.e)} + 2 H and {_high_text(c)}.",
        ),
        Step(
            "roots",
            "The radicals are the positive roots of positive expressions.",
            equal(
                sp.ImmutableDenseMatrix([[high**2, 4 * ROOT_S**2]]),
                sp.ImmutableDenseMatrix([[16 + ratio * INDEX**2, (1 + ratio) * INDEX + 2 * high]]),
            ),
            f"The defining equations of the tower; {_high_text(c)}.",
        ),
        Step(
            "position-gain",
            "The position gain follows from the variance.",
            equal(ALPHA, ROOT * ROOT_S / DEVIATION),
            "alpha = 1 - 1/sigma^2 and sigma - 1/sigma = p s.",
        ),
        Step(
            "factorisation",
            "With these gains the innovation spectrum factors through the closed-loop polynomial.",
            equal(
                v**2 + INDEX**2 * noise.subs(V, v),
                DEVIATION**2 * closed * closed.subs(Z, 1 / Z),
                free=("z",),
            ),
            "Both sides agree for every z.",
        ),
        Step(
            "gain-relation",
            "Free of the index, the two gains lie on one curve.",
            equal(c.spectrum.relation, sp.Integer(0)),
            "Eliminate q and S from the three coefficients.",
        ),
        Step(
            "predictor-gain",
            "The predictor gain F K adds the velocity gain to the position gain.",
            equal(
                c.model.transition * sp.ImmutableDenseMatrix([[ALPHA], [BETA]]),
                sp.ImmutableDenseMatrix([[real("predictor_position")], [BETA]]),
            ),
            "Multiply out.",
        ),
    ]
