"""Steps on the model: scaling and innovation spectrum."""

from __future__ import annotations

import re

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import definition, described, equal
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import INDEX, Z
from gainproof.derive.steady_state.spectrum import (
    V,
    closed_loop_matrix,
    noise_numerator,
)


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
            "With the gain K = (alpha, beta) the poles of the filter are the roots of this c(z).",
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
