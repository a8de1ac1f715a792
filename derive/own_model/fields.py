"""What the fields of a model are: matrices, quantities with units, and units that agree."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.model import Model, ModelError
from gainproof.derive.own_expressions.checks import require_tuple
from gainproof.derive.own_expressions.dimensions import unit_of
from gainproof.derive.own_expressions.expressions import ExpressionError
from gainproof.derive.quantity import SAMPLING_INTERVAL, Quantity, Unit

MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")
SEVERAL = ("quantities", "state_units", "measurement_units", "parameters", "ratios")


def require_fields(model: Model) -> None:
    """Raise ModelError unless matrices are SymPy's, units are units, and T and the reference
    deviation are among the quantities.
    """
    for name in MATRICES:
        value = getattr(model, name)
        if not isinstance(value, sp.MatrixBase):
            raise ModelError(
                f"model {model.name}: {name} should be a matrix of SymPy, "
                f"sp.ImmutableDenseMatrix([[...], ...]), it is of type {type(value).__name__}"
            )
    for name in SEVERAL:
        require_tuple(f"model {model.name}", name, getattr(model, name), ModelError)
    own = [*model.quantities, *(entry.quantity for entry in model.parameters)]
    for quantity in own:
        if not isinstance(quantity, Quantity):
            raise ModelError(
                f"model {model.name}: quantities are of the type Quantity, {quantity!r} is not"
            )
    units = [(f"the quantity {quantity.name}", quantity.unit) for quantity in own]
    units += [(f"state {k + 1}", unit) for k, unit in enumerate(model.state_units)]
    units += [(f"measurement {k + 1}", unit) for k, unit in enumerate(model.measurement_units)]
    for what, unit in units:
        if not isinstance(unit, Unit):
            raise ModelError(
                f"model {model.name}: {what} should have a unit made of METRE, SECOND and the "
                f"like, such as METRE / SECOND**2, it has {unit!r}"
            )
    for wanted in (SAMPLING_INTERVAL, model.deviation):
        if wanted not in model.quantities:
            raise ModelError(
                f"model {model.name}: quantities should hold {wanted.name}, they hold "
                f"{', '.join(quantity.name for quantity in model.quantities) or 'nothing'}"
            )


def require_noise_units(model: Model) -> None:
    """Raise ModelError unless each entry of the process noise has the product of the units of its
    two states: the scaling would make any strength a number, also one with a square forgotten.
    """
    units = {each.symbol: each.unit for each in (*model.quantities, *_ratios(model))}
    units |= {entry.quantity.symbol: entry.quantity.unit for entry in model.parameters}
    for i, row in enumerate(model.state_units):
        for j, column in enumerate(model.state_units):
            entry = sp.sympify(model.process_noise[i, j])
            if entry.is_zero:
                continue
            place = f"model {model.name}: entry {i + 1},{j + 1} of process_noise"
            try:
                found = unit_of(entry, units)
            except ExpressionError as error:
                raise ModelError(f"{place}: {error}") from None
            if found != row * column:
                cure = (
                    "; numbers as measured get a strength in front, such as w**2 with w in "
                    f"{model.state_units[-1]}, and a T for each second that an entry then lacks"
                )
                raise ModelError(
                    f"{place} should have the unit {row * column}, that of the product of its two "
                    f"states; {entry} has {found}{cure if entry.is_number else ''}"
                )


def _ratios(model: Model) -> list[Quantity]:
    return [quantity for entry in model.ratios for quantity in (entry.name, entry.quantity)]
