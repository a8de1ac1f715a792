"""State-space models of tracking, and the scaling that makes them dimensionless."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.quantity import MEASUREMENT_DEVIATION, SAMPLING_INTERVAL, Quantity, Unit

Rows = list[list[str]]


class ModelError(ValueError):
    """A model that cannot be used; the message says what was wanted and what came."""


@dataclass(frozen=True)
class Model:
    """x(k+1) = F x(k) + w, z = H x + v with E w w' = Q and E v v' = R.

    Matrices are written over the symbols of `quantities`; `state_units` are the units of the state.
    The process noise is one unknown strength times a matrix.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    quantities: tuple[Quantity, ...]
    state_units: tuple[Unit, ...]


@dataclass(frozen=True)
class ScaledModel:
    """The model in units T = 1 and sigma_v = 1: `process_noise` is multiplied by q = index squared.

    `noise_ratio` is q in the quantities of the model, normalised so that the noise polynomial is 1
    at zero frequency; `state_scale` is the length of one unit of each state.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    noise_ratio: sp.Expr
    state_scale: tuple[sp.Expr, ...]

    def data(self) -> dict[str, Any]:
        """Plain data that crosses the border to the judge and the checker."""
        return {
            "name": self.name,
            "title": self.title,
            "transition": _rows(self.transition),
            "process_noise": _rows(self.process_noise),
            "measurement": _rows(self.measurement),
            "measurement_noise": _rows(self.measurement_noise),
        }


def _rows(matrix: sp.ImmutableDenseMatrix) -> Rows:
    return [[str(sp.Rational(entry)) for entry in row] for row in matrix.tolist()]


def scale(model: Model) -> ScaledModel:
    """Make a model with one measured position dimensionless.

    One unit of a state of unit m^a s^b is sigma_v^a T^b: the scaling is read off the units.

    Raises ModelError when a scaled matrix still depends on a quantity.
    """
    step, deviation = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
    scales = tuple(
        deviation ** sp.Rational(unit.metre) * step ** sp.Rational(unit.second)
        for unit in model.state_units
    )
    forward = sp.diag(*scales)
    backward = sp.diag(*(1 / entry for entry in scales))
    transition = (backward * model.transition * forward).applyfunc(sp.simplify)
    noise = (backward * model.process_noise * backward).applyfunc(sp.simplify)
    measurement = (model.measurement * forward / deviation).applyfunc(sp.simplify)
    measured = (model.measurement_noise / deviation**2).applyfunc(sp.simplify)
    for label, matrix in (("transition", transition), ("measurement", measurement)):
        if matrix.free_symbols:
            raise ModelError(
                f"model {model.name}: the scaled {label} should be numbers, it holds "
                f"{sorted(map(str, matrix.free_symbols))}; check the units of the state"
            )
    ratio = sp.simplify(noise_at_zero_frequency(transition, noise, measurement))
    if not _is_positive(ratio):
        raise ModelError(
            f"model {model.name}: a process noise that reaches the measured position with a "
            f"positive strength is wanted, at zero frequency it is {ratio}"
        )
    relative = (noise / ratio).applyfunc(sp.simplify)
    if relative.free_symbols or measured.free_symbols:
        raise ModelError(
            f"model {model.name}: the process noise should be one strength times a matrix of "
            f"numbers, the scaled noise is {relative}"
        )
    if not sp.ImmutableDenseMatrix(relative).is_positive_semidefinite or measured[0, 0] <= 0:
        raise ModelError(
            f"model {model.name}: covariances are wanted; the scaled process noise is "
            f"{relative.tolist()}, the scaled measurement noise {measured.tolist()}"
        )
    return ScaledModel(
        model.name,
        model.title,
        sp.ImmutableDenseMatrix(transition),
        sp.ImmutableDenseMatrix(relative),
        sp.ImmutableDenseMatrix(measurement),
        sp.ImmutableDenseMatrix(measured),
        ratio,
        scales,
    )


def _is_positive(ratio: sp.Expr) -> bool:
    """Whether a product of powers of positive quantities has a positive number in front."""
    return not ratio.has(sp.zoo, sp.nan) and bool(ratio.as_coeff_Mul()[0] > 0)


def noise_at_zero_frequency(
    transition: sp.MatrixBase, noise: sp.MatrixBase, measurement: sp.MatrixBase
) -> sp.Expr:
    """The numerator of the process noise's spectrum at z = 1: H adj(I - F) Q adj(I - F)' H'."""
    adjugate = (sp.eye(transition.rows) - transition).adjugate()
    row = measurement * adjugate
    return sp.expand((row * noise * row.T)[0, 0])
