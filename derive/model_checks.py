"""How a model has to be written before anything is derived; each refusal names entry or property.

All of it raises ModelError, a ValueError, which says what was wanted and what came.
"""

from __future__ import annotations

import keyword
import re

import numpy as np
import sympy as sp

from gainproof.derive.own_expressions.checks import require_tuple
from gainproof.derive.own_expressions.dimensions import unit_of
from gainproof.derive.own_expressions.expressions import ExpressionError
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, Quantity, Unit
from gainproof.derive.state_space import Model, ModelError

DIGITS = 300
"""Certificates of models with more of them are far too long for the checker."""
MOST = 10**DIGITS
LONG = 2**40
"""A quotient by a power of 2 whose numerator is no less came out of a float: nobody wrote it."""
NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")
SEVERAL = ("quantities", "state_units", "measurement_units", "parameters", "ratios")


def require_written_well(model: Model) -> None:
    """Raise ModelError unless names, shapes, numbers, symmetry, units and a domain for each symbol
    are there.
    """
    if not NAME.fullmatch(model.name):
        raise ModelError(
            f"model {model.name!r}: a name of lower-case letters, digits and single hyphens is "
            "wanted, a letter first: its module has this name"
        )
    require_fields(model)
    _require_shapes(model)
    _require_rational(model)
    for name in ("process_noise", "measurement_noise"):
        _require_symmetric(model, name)
    _require_parameters(model)
    _require_domains(model)
    require_units(model)
    require_noise_units(model)


def _require_shapes(model: Model) -> None:
    size, seen = model.transition.rows, model.measurement.rows
    wanted = {
        "transition": (size, size),
        "process_noise": (size, size),
        "measurement": (seen, size),
        "measurement_noise": (seen, seen),
    }
    for name, shape in wanted.items():
        found = getattr(model, name).shape
        if found != shape or 0 in found:
            raise ModelError(
                f"model {model.name}: {name} should have the shape {shape}, it has {found}"
            )


def _require_rational(model: Model) -> None:
    """Sums, products and quotients of quantities, parameters and quotients of whole numbers: the
    towers begin with these. Roots of quantities are scaled away.
    """
    free = {entry.quantity.symbol for entry in model.parameters}
    for name in MATRICES:
        matrix = getattr(model, name)
        for place, entry in enumerate(matrix.flat()):
            row, column = divmod(place, matrix.cols)
            where = f"its entry {row + 1},{column + 1} holds"
            numbers = entry.atoms(sp.Number, sp.NumberSymbol)
            roots = [p for p in entry.atoms(sp.Pow) if not p.exp.is_Integer]
            wrong = [n for n in (*numbers, *roots) if not n.free_symbols and not n.is_Rational]
            if wrong or entry.has(sp.I, sp.zoo):
                found = min(map(str, wrong), default=str(entry))
                raise ModelError(
                    f"model {model.name}: {name} should hold rational numbers, {where} {found}; "
                    "write a quotient of whole numbers, or make it a parameter"
                )
            for number in numbers:
                if number.q > 1 and abs(number.p) >= LONG and number == sp.Rational(float(number)):
                    raise ModelError(
                        f"model {model.name}: {name} should hold numbers as they were measured, "
                        f"{where} {number}, a float in binary; write it as a text, "
                        f'sp.Rational("{float(number)!r}")'
                    )
            if any(max(abs(n.p), n.q) >= MOST for n in numbers):
                raise ModelError(
                    f"model {model.name}: {name} should hold numbers of at most {DIGITS} digits, "
                    f"{where} a longer one; round it"
                )
            bases = [p for p in roots if p.free_symbols & free or not p.exp.is_Rational]
            others = [
                node
                for node in sp.preorder_traversal(entry)
                if not (node.is_Atom or node.is_Add or node.is_Mul or node.is_Pow)
            ]
            if bases or others:
                found = str((*others, *bases)[0])
                raise ModelError(
                    f"model {model.name}: {name} should be made of sums, products and quotients, "
                    f"{where} {found}, which is out of reach as a function; make {found} a "
                    "parameter of its own, a number without a unit, and so what else depends on it"
                )


def _require_symmetric(model: Model, name: str) -> None:
    matrix = getattr(model, name)
    for i in range(matrix.rows):
        for j in range(i):
            if sp.simplify(matrix[i, j] - matrix[j, i]) != 0:
                raise ModelError(
                    f"model {model.name}: {name} should be symmetric, its entry {j + 1},{i + 1} is "
                    f"{matrix[j, i]} and its entry {i + 1},{j + 1} is {matrix[i, j]}"
                )


def _require_parameters(model: Model) -> None:
    used = set[sp.Basic]().union(*(getattr(model, each).free_symbols for each in MATRICES))
    for entry in model.parameters:
        name = entry.quantity.name
        if entry.quantity.symbol not in used:
            raise ModelError(
                f"model {model.name}: the parameter {name} occurs in no matrix: leave it out, or "
                "use its quantity's .symbol"
            )
        if not name.isidentifier() or keyword.iskeyword(name) or name == "out":
            raise ModelError(
                f"model {model.name}: the parameter {name!r} should have the name of a Python "
                "variable, and not `out`: it is an argument of the kernels"
            )
        if entry.quantity.unit != Unit():
            raise ModelError(
                f"model {model.name}: the parameter {name} should have no unit, it has "
                f"{entry.quantity.unit}"
            )
        least, most = map(sp.Rational, entry.kernel_range)
        top = 1 if entry.below_one else sp.oo
        # in float32 too: the certificate says nothing of a parameter that is 1
        if not 0 < least < most or not np.float32(float(most)) < top:
            raise ModelError(
                f"model {model.name}: kernels need {name} from a positive number to a greater one"
                f"{' below 1' if entry.below_one else ''}, the range is {least} to {most}"
            )


def _require_domains(model: Model) -> None:
    known = {
        *(quantity.name for quantity in model.quantities),
        *(entry.quantity.name for entry in model.parameters),
        SAMPLING_INTERVAL.name,
        model.deviation.name,
    }
    for name in MATRICES:
        for symbol in sorted(getattr(model, name).free_symbols, key=str):
            if symbol.name not in known:
                raise ModelError(
                    f"model {model.name}: {name} holds the symbol {symbol}, which has no domain; "
                    "name it in quantities (positive, with a unit) or in parameters (a free "
                    "number, positive or between 0 and 1)"
                )
            if symbol != sp.Symbol(symbol.name, real=True):
                raise ModelError(
                    f"model {model.name}: {name} holds another symbol named {symbol}; take the "
                    "one that its quantity gives (.symbol)"
                )


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


def require_units(model: Model) -> None:
    """Raise ModelError unless there is a unit for each state and measurement, and a reference."""
    if model.deviation.unit != METRE:
        raise ModelError(
            f"model {model.name}: the reference deviation should be a length, "
            f"{model.deviation.name} has the unit {model.deviation.unit}; of an angle or anything "
            "else write METRE instead of its unit, also in those of the states: gains and "
            "kernels are numbers without units, and stay what they are"
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
