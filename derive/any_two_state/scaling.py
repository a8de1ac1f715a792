"""A model in units T = 1 and sigma_v = 1 whose matrices may hold free dimensionless numbers."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_two_state.domain import shown
from gainproof.derive.model import Model, ModelError, ScaledModel, unit_length
from gainproof.derive.model_checks import require_units
from gainproof.derive.quantity import SAMPLING_INTERVAL


def scale_free(model: Model) -> ScaledModel:
    """The scaled model; q is the strength in front of the process noise, the given matrix is left.

    Raises ModelError where more than numbers and the model's parameters is left of a matrix, or
    the process noise is no single strength times a matrix.
    """
    require_units(model)
    states = tuple(unit_length(model, unit) for unit in model.state_units)
    seen = tuple(unit_length(model, unit) for unit in model.measurement_units)
    forward, backward = sp.diag(*states), sp.diag(*(1 / entry for entry in states))
    outward = sp.diag(*(1 / entry for entry in seen))
    matrices = {
        "transition": backward * model.transition * forward,
        "measurement": outward * model.measurement * forward,
        "measurement_noise": outward * model.measurement_noise * outward,
    }
    found = {
        name: sp.ImmutableDenseMatrix(entry.applyfunc(sp.cancel))
        for name, entry in matrices.items()
    }
    for name, entry in found.items():
        left = entry.free_symbols - _names(model)
        if left:
            raise ModelError(
                f"model {model.name}: in units T = 1 and sigma_v = 1 the {name} should hold "
                f"numbers and the model's parameters, it holds {_listed(left)}: the units of the "
                "states and the measurement do not take these away; where the units are right, "
                "write what they make up as a parameter, a number without a unit"
            )
    strength, noise = _strength(model, (backward * model.process_noise * backward))
    return ScaledModel(
        model.name,
        model.title,
        found["transition"],
        noise,
        found["measurement"],
        found["measurement_noise"],
        strength,
        states,
        seen,
    )


def _names(model: Model) -> set[sp.Symbol]:
    return {entry.quantity.symbol for entry in model.parameters}


def _listed(symbols: set[sp.Symbol]) -> str:
    return ", ".join(sorted(map(str, symbols)))


def _strength(model: Model, scaled: sp.MatrixBase) -> tuple[sp.Expr, sp.ImmutableDenseMatrix]:
    """q, a product of powers of the model's quantities, and the matrix that it multiplies."""
    first = next((entry for entry in map(sp.factor, scaled.flat()) if entry != 0), None)
    if first is None:
        raise ModelError(f"model {model.name}: a process noise is wanted, all its entries are 0")
    names = _names(model)
    factors = sp.Mul.make_args(first)
    strength: sp.Expr = sp.Mul(*(entry for entry in factors if entry.free_symbols - names))
    noise = sp.ImmutableDenseMatrix((scaled / strength).applyfunc(sp.cancel))
    left = noise.free_symbols - names
    powers = all(entry.as_base_exp()[0].is_Symbol for entry in sp.Mul.make_args(strength))
    if left or not (powers or strength.is_Number):
        raise ModelError(
            f"model {model.name}: the process noise should be one strength times a matrix of "
            f"numbers and of the model's parameters, the scaled noise is {shown(scaled)}; of "
            "several strengths keep one and write the others over it as parameters, numbers "
            "without a unit, such as w**2*[[r*T**2, 0], [0, 1]] with r = d**2/(w*T)**2"
        )
    if not strength.free_symbols - {SAMPLING_INTERVAL.symbol, model.deviation.symbol}:
        raise ModelError(
            f"model {model.name}: a process noise with a strength of its own is wanted, the scaled "
            f"one is {strength} times {shown(noise)}, which fixes the tracking index: put a "
            "quantity in front, and call the kernels with its value"
        )
    return strength, noise
