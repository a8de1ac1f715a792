"""Steps on the model: state, noises, scaling, the two numbers that are left, filter equations."""

from __future__ import annotations

import re

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, definition, described, equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import INDEX, RATIO, SPEED, row


def model_steps(c: Context) -> list[Step]:
    """From the model in its own units to the two dimensionless parameters."""
    (ratio,) = c.model.ratios.values()
    return [
        *_own_model(c),
        *_scaling_steps(c),
        Step(
            "index",
            "Two numbers are left. The first is the tracking index `Lambda`: how far the process "
            "noise moves the target in one interval, measured by `sigma_o`. The process noise now "
            "has covariance `Lambda^2 Q0`, and `Q0` holds numbers only.",
            definition(INDEX**2, c.model.noise_ratio),
            "Entry 22 of step @scaled-process-noise.",
        ),
        Step(
            "ratio",
            "The second is the velocity ratio `S`: the error of the measured velocity, in units of "
            "`sigma_o/T`. Their quotient `t` is to the measured velocity what `Lambda` is to the "
            "position. From here on `T = 1` and `sigma_o = 1`.",
            definition(row(RATIO**2, SPEED), row(ratio**2, INDEX / RATIO)),
            "Entry 22 of step @scaled-measurement-noise: `R` holds 1 and `S^2`.",
        ),
        Step(
            "filter",
            "Let `P` be the covariance of the prediction's error, `U` that of the update's error "
            "and `K` the gain of the filter. In the steady state one interval leads from `U` to "
            "`P` and one measurement from `P` back to `U`. We look for the `P`, `U` and `K` that "
            "fit together; their entries are `P11`, `P12`, `P22`, `U11`, `U12`, `U22` and `K11`, "
            "`K12`, `K21`, `K22`.",
            described("P = F U F' + Lambda^2 Q0, U^-1 = P^-1 + R^-1, K = U R^-1"),
            "The equations of the Kalman filter with `H = I`, its covariances held still.",
        ),
    ]


def _own_model(c: Context) -> list[Step]:
    """The model in its own quantities."""
    model = c.original
    listed = ", ".join(f"`{_plain(q.latex)}` the {q.meaning}" for q in model.quantities)
    return [
        Step(
            "model",
            "The state `x` holds position and velocity. From one sample to the next it moves by "
            "`F` and is shaken by process noise; a radar measures both, as `y`. All noises are "
            "white and independent of each other.",
            described("`x(k+1) = F x(k)` + process noise of covariance `Q`"),
            f"This is the model. Here {listed.replace('` the', '` is the', 1)}.",
            heading="The model",
        ),
        joined(
            "model-measurement",
            described("`y(k) = H x(k)` + measurement noise of covariance `R`"),
        ),
        *(
            joined(f"model-{name.replace('_', '-')}", definition(real(name), matrix))
            for name, matrix in (
                ("transition_matrix", model.transition),
                ("process_noise", model.process_noise),
                ("measurement_matrix", model.measurement),
                ("measurement_noise", model.measurement_noise),
            )
        ),
    ]


def _scaling_steps(c: Context) -> list[Step]:
    """The scaled matrices are the model's own, in the units of the scaling."""
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    seen = sp.diag(*(1 / entry for entry in c.model.measurement_scale)).as_immutable()
    values = {sp.Symbol(name, real=True): value for name, value in c.model.ratios.items()}
    return [
        Step(
            "scaled-transition",
            "Measure time in units of `T`, positions in units of `sigma_o` and velocities in units "
            "of `sigma_o/T`. The transition is then a matrix of numbers.",
            _scaled(c, (backward, c.original.transition, forward), c.model.transition),
            "Each entry of `F` (step @model) is divided by the unit of its row and multiplied by "
            "that of its column.",
        ),
        Step(
            "scaled-process-noise",
            "In the same units the process noise is one ratio times a matrix of numbers.",
            _scaled(
                c,
                (backward, c.original.process_noise, backward),
                sp.ImmutableDenseMatrix(c.model.noise_ratio * c.model.process_noise),
            ),
            "An entry of a covariance is divided by the units of its row and of its column.",
        ),
        Step(
            "scaled-measurement-noise",
            "And of the measurement noise one other ratio is left.",
            _scaled(
                c,
                (seen, c.original.measurement_noise, seen),
                c.model.measurement_noise.subs(values),
            ),
            "Likewise, the measurements being of the state itself.",
        ),
    ]


def _scaled(
    c: Context,
    factors: tuple[sp.ImmutableDenseMatrix, ...],
    value: sp.ImmutableDenseMatrix,
) -> Relation:
    """The product of the factors is the scaled matrix, for all values of the quantities."""
    found = {str(symbol) for factor in factors for symbol in factor.free_symbols}
    free = tuple(q.name for q in c.original.quantities if q.name in found)
    return equal(sp.MatMul(*factors, evaluate=False), sp.ImmutableDenseMatrix(value), free=free)


def _plain(latex: str) -> str:
    """A quantity's symbol as it is written on a line of text."""
    return re.sub(r"[\\{} ]|tilde", "", latex)
