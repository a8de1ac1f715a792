"""What pages of steady states say of their model, in the units that it comes in."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from gainproof.derive.model import Model, ScaledModel


def model_slots(model: Model, scaled: ScaledModel) -> dict[str, Any]:
    """The slots by name: matrices, units, what quantities are, and the ratio behind the index."""
    units = sp.diag(*scaled.state_scale).as_immutable()
    inverse = sp.diag(*(1 / entry for entry in scaled.state_scale)).as_immutable()
    listed = ", ".join(f"`{plain(q.latex)}` the {q.meaning}" for q in model.quantities)
    return {
        "transition": model.transition,
        "process_noise": model.process_noise,
        "measurement": model.measurement,
        "measurement_noise": model.measurement_noise,
        "meanings": f" Here {listed.replace('` the', '` is the', 1)}." if listed else "",
        "units": units,
        "inverse_units": inverse,
        "quantities_of_transition": _quantities(model, inverse, model.transition),
        "quantities_of_noise": _quantities(model, inverse, model.process_noise),
        "ratio": scaled.noise_ratio,
        "scaled_transition": scaled.transition,
        "noise": scaled.process_noise,
    }


def plain(latex: str) -> str:
    """A quantity's symbol as it is written on a line of text."""
    return re.sub(r"[\\{} ]|tilde", "", latex)


def _quantities(model: Model, *factors: sp.ImmutableDenseMatrix) -> tuple[sp.Symbol, ...]:
    """The model's quantities in these matrices."""
    found = {symbol for factor in factors for symbol in factor.free_symbols}
    return tuple(q.symbol for q in model.quantities if q.symbol in found)
