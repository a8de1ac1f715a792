"""Steps on the model: state, noises, scaling, the two numbers that are left, filter equations."""

from __future__ import annotations

import re

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import definition, described, equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import INDEX, RATIO, SPEED


def model_steps(c: Context) -> list[Step]:
    """From the model in its own units to the two dimensionless parameters."""
    (ratio,) = c.model.ratios.values()
    return [
        Step(
            "model",
            f"{c.original.title}: the state (position, velocity) moves by F over one interval T "
            "and is shaken by a process noise of covariance Q. A radar measures both entries, with "
            "independent errors of standard deviations sigma_o (position) and sigma_d (velocity).",
            described(_model_text(c)),
            "This is the model; everything below follows from it.",
        ),
        *_scaling_steps(c),
        Step(
            "index",
            "In units of T and of the position's deviation sigma_o only two numbers are left. The "
            "first is the tracking index Lambda: how far the process noise moves the target in one "
            "interval, measured by sigma_o.",
            definition(INDEX**2, c.model.noise_ratio),
            "The strength of the scaled process noise; what is left of Q is a matrix of numbers.",
        ),
        Step(
            "ratio",
            "The second is the velocity ratio S: the velocity's error, measured by sigma_o/T. "
            "Their quotient t is to the measured velocity what Lambda is to the position.",
            definition(
                sp.ImmutableDenseMatrix([[RATIO**2, SPEED]]),
                sp.ImmutableDenseMatrix([[ratio**2, INDEX / RATIO]]),
            ),
            "S is the only number left in the scaled R.",
        ),
        Step(
            "filter",
            "Let P be the covariance of the prediction and U that of the update. In the steady "
            "state one interval leads from U to P and one measurement from P back to U, and K is "
            "the gain. We look for the P, U and K that fit together.",
            described("P = F U F' + Lambda^2 Q0, U^-1 = P^-1 + R^-1, K = U R^-1"),
            "The Kalman filter with H = I, its covariances held still.",
        ),
    ]


def _scaling_steps(c: Context) -> list[Step]:
    """The scaled matrices are the model's own, in the units of the scaling."""
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    seen = sp.diag(*(1 / entry for entry in c.model.measurement_scale)).as_immutable()
    values = {sp.Symbol(name, real=True): value for name, value in c.model.ratios.items()}
    scaled = {
        "transition": ((backward, c.original.transition, forward), c.model.transition),
        "process noise": (
            (backward, c.original.process_noise, backward),
            c.model.noise_ratio * c.model.process_noise,
        ),
        "measurement noise": (
            (seen, c.original.measurement_noise, seen),
            c.model.measurement_noise.subs(values),
        ),
    }
    names = [quantity.name for quantity in c.original.quantities]
    return [
        Step(
            f"scaled-{name.replace(' ', '-')}",
            f"The {name} in units of T and sigma_o: positions in sigma_o, velocities in sigma_o/T.",
            equal(
                sp.MatMul(*factors, evaluate=False),
                sp.ImmutableDenseMatrix(value),
                free=_used(names, factors),
            ),
            "An entry of unit m^a s^b is measured in sigma_o^a T^b.",
        )
        for name, (factors, value) in scaled.items()
    ]


def _used(names: list[str], factors: tuple[sp.ImmutableDenseMatrix, ...]) -> tuple[str, ...]:
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
