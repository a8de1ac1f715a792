"""State-space models of tracking, and the scaling that makes them dimensionless."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.model_checks import require_written_well
from gainproof.derive.quantity import SAMPLING_INTERVAL, Unit
from gainproof.derive.state_space import Model, ModelError, Parameter, Ratio, ScaledModel

__all__ = [
    "Model",
    "ModelError",
    "Parameter",
    "Ratio",
    "ScaledModel",
    "noise_at_zero_frequency",
    "scale",
    "unit_length",
]


def scale(model: Model) -> ScaledModel:
    """Make a model dimensionless: units in which T and the reference deviation are 1.

    One unit of a state or measurement of unit m^a s^b is sigma_v^a T^b: the scaling is read off the
    units, and so is each ratio.

    Raises ModelError for a model that is not written well, and when a scaled matrix still depends
    on a quantity.
    """
    require_written_well(model)
    states = tuple(unit_length(model, unit) for unit in model.state_units)
    measurements = tuple(unit_length(model, unit) for unit in model.measurement_units)
    forward = sp.diag(*states)
    backward = sp.diag(*(1 / entry for entry in states))
    seen = sp.diag(*(1 / entry for entry in measurements))
    transition = (backward * model.transition * forward).applyfunc(sp.simplify)
    noise = (backward * model.process_noise * backward).applyfunc(sp.simplify)
    measurement = (seen * model.measurement * forward).applyfunc(sp.simplify)
    for label, matrix in (("transition", transition), ("measurement", measurement)):
        if matrix.free_symbols:
            raise ModelError(
                f"model {model.name}: in units T = 1 and sigma_v = 1 the {label} should hold "
                f"numbers, it holds {', '.join(sorted(map(str, matrix.free_symbols)))}: the units "
                "of the states and the measurement do not take these away"
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
            entry.name.name: entry.quantity.symbol / unit_length(model, entry.quantity.unit)
            for entry in model.ratios
        },
    )


def unit_length(model: Model, unit: Unit) -> sp.Expr:
    """One unit of a quantity once T and the reference deviation are 1."""
    step, deviation = SAMPLING_INTERVAL.symbol, model.deviation.symbol
    return deviation ** sp.Rational(unit.metre) * step ** sp.Rational(unit.second)


def _measurement_noise(model: Model, seen: sp.MatrixBase) -> sp.MatrixBase:
    """R in the units of the scaling, over the names of the ratios."""
    known = {
        entry.quantity.symbol: entry.name.symbol * unit_length(model, entry.quantity.unit)
        for entry in model.ratios
    }
    measured = (seen * model.measurement_noise.subs(known) * seen).applyfunc(sp.simplify)
    names = {entry.name.symbol for entry in model.ratios}
    left = measured.free_symbols - names
    if left:
        raise ModelError(
            f"model {model.name}: the scaled measurement noise should hold numbers and the ratios "
            f"{sorted(map(str, names))}, it holds {sorted(map(str, left))}, which the units of the "
            "measurements do not take away; name a ratio for each further deviation"
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
