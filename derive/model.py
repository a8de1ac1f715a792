"""State-space models of tracking, and the scaling that makes them dimensionless."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from gainproof.derive.expression import graph_of
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    Quantity,
    Unit,
)

Rows = list[list[Any]]


class ModelError(ValueError):
    """A model that cannot be used; the message says what was wanted and what came."""


@dataclass(frozen=True)
class Ratio:
    """A parameter left by scaling: `quantity` in the unit that T and the reference give it.

    `name` is the dimensionless number, such as S = sigma_d T/sigma_o for a velocity deviation.
    """

    name: Quantity
    quantity: Quantity


@dataclass(frozen=True)
class Model:
    """x(k+1) = F x(k) + w, z = H x + v with E w w' = Q and E v v' = R.

    Matrices are written over the symbols of `quantities`; `state_units` and `measurement_units` are
    the units of the state and of the measurement. The process noise is one unknown strength times
    a matrix. `deviation` is the length, in metres, that becomes 1: the deviation of the first
    measurement; every further deviation in R has its ratio to it in `ratios`.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    quantities: tuple[Quantity, ...]
    state_units: tuple[Unit, ...]
    measurement_units: tuple[Unit, ...] = (METRE,)
    deviation: Quantity = MEASUREMENT_DEVIATION
    ratios: tuple[Ratio, ...] = ()


@dataclass(frozen=True)
class ScaledModel:
    """The model in units T = 1 and sigma_v = 1: `process_noise` is multiplied by q = index squared.

    `noise_ratio` is q in the quantities of the model, normalised so that the noise polynomial of
    the first measurement is 1 at zero frequency; `state_scale` and `measurement_scale` are the
    lengths of one unit of each state and measurement. `measurement_noise` is written over the names
    in `ratios`, which gives each in the quantities of the model; the rest are numbers.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    noise_ratio: sp.Expr
    state_scale: tuple[sp.Expr, ...]
    measurement_scale: tuple[sp.Expr, ...] = ()
    ratios: Mapping[str, sp.Expr] = field(default_factory=dict)

    def data(self) -> dict[str, Any]:
        """Plain data that crosses the border to the judge and the checker.

        An entry is a number as text or, where a ratio occurs, an expression graph over its name.
        """
        return {
            "name": self.name,
            "title": self.title,
            "transition": _rows(self.transition),
            "process_noise": _rows(self.process_noise),
            "measurement": _rows(self.measurement),
            "measurement_noise": _rows(self.measurement_noise),
        }


def _rows(matrix: sp.ImmutableDenseMatrix) -> Rows:
    return [[_entry(entry) for entry in row] for row in matrix.tolist()]


def _entry(entry: sp.Expr) -> Any:
    return graph_of(entry) if entry.free_symbols else str(sp.Rational(entry))


def scale(model: Model) -> ScaledModel:
    """Make a model dimensionless: units in which T and the reference deviation are 1.

    One unit of a state or measurement of unit m^a s^b is sigma_v^a T^b: the scaling is read off the
    units, and so is each ratio.

    Raises ModelError when a scaled matrix still depends on a quantity.
    """
    _require_units(model)
    states = tuple(_length(model, unit) for unit in model.state_units)
    measurements = tuple(_length(model, unit) for unit in model.measurement_units)
    forward = sp.diag(*states)
    backward = sp.diag(*(1 / entry for entry in states))
    seen = sp.diag(*(1 / entry for entry in measurements))
    transition = (backward * model.transition * forward).applyfunc(sp.simplify)
    noise = (backward * model.process_noise * backward).applyfunc(sp.simplify)
    measurement = (seen * model.measurement * forward).applyfunc(sp.simplify)
    for label, matrix in (("transition", transition), ("measurement", measurement)):
        if matrix.free_symbols:
            raise ModelError(
                f"model {model.name}: the scaled {label} should be numbers, it holds "
                f"{sorted(map(str, matrix.free_symbols))}; check the units of the state "
                "and of the measurement"
            )
    measured = _measurement_noise(model, seen)
    ratio = sp.simplify(noise_at_zero_frequency(transition, noise, measurement))
    if not _is_positive(ratio):
        raise ModelError(
            f"model {model.name}: a process noise that reaches the measured position with a "
            f"positive strength is wanted, at zero frequency it is {ratio}"
        )
    relative = (noise / ratio).applyfunc(sp.simplify)
    if relative.free_symbols:
        raise ModelError(
            f"model {model.name}: the process noise should be one strength times a matrix of "
            f"numbers, the scaled noise is {relative}"
        )
    if not sp.ImmutableDenseMatrix(relative).is_positive_semidefinite or not _is_definite(measured):
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
        states,
        measurements,
        {
            entry.name.name: entry.quantity.symbol / _length(model, entry.quantity.unit)
            for entry in model.ratios
        },
    )


def _length(model: Model, unit: Unit) -> sp.Expr:
    """One unit of a quantity once T and the reference deviation are 1."""
    step, deviation = SAMPLING_INTERVAL.symbol, model.deviation.symbol
    return deviation ** sp.Rational(unit.metre) * step ** sp.Rational(unit.second)


def _require_units(model: Model) -> None:
    """Raise ModelError unless there is a unit for each state and measurement, and a reference."""
    if model.deviation.unit != METRE:
        raise ModelError(
            f"model {model.name}: the reference deviation should be a length, "
            f"{model.deviation.name} has the unit {model.deviation.unit}"
        )
    for label, units, size in (
        ("state", model.state_units, model.transition.rows),
        ("measurement", model.measurement_units, model.measurement.rows),
    ):
        if len(units) != size:
            raise ModelError(
                f"model {model.name}: a unit for each of {size} entries of the {label} is wanted, "
                f"there are {len(units)}"
            )


def _measurement_noise(model: Model, seen: sp.MatrixBase) -> sp.MatrixBase:
    """R in the units of the scaling, over the names of the ratios."""
    known = {
        entry.quantity.symbol: entry.name.symbol * _length(model, entry.quantity.unit)
        for entry in model.ratios
    }
    measured = (seen * model.measurement_noise.subs(known) * seen).applyfunc(sp.simplify)
    names = {entry.name.symbol for entry in model.ratios}
    left = measured.free_symbols - names
    if left:
        raise ModelError(
            f"model {model.name}: the scaled measurement noise should hold numbers and the ratios "
            f"{sorted(map(str, names))}, it holds {sorted(map(str, left))}; check the units of the "
            "measurement, and name a ratio for each further deviation"
        )
    if names - measured.free_symbols:
        raise ModelError(
            f"model {model.name}: the ratios {sorted(map(str, names - measured.free_symbols))} do "
            f"not occur in the scaled measurement noise {measured.tolist()}"
        )
    return measured


def _is_definite(measured: sp.MatrixBase) -> bool:
    """Whether every leading minor is positive for all positive values of the ratios."""
    positive = {name: sp.Dummy(positive=True) for name in measured.free_symbols}
    minors = (measured[:n, :n].det() for n in range(1, measured.rows + 1))
    return measured.is_symmetric() and all(
        bool(sp.factor(sp.sympify(minor).subs(positive)).is_positive) for minor in minors
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
