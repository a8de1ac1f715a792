"""Steps on the model: its own matrices, their scaling, and the numbers that stay free."""

from __future__ import annotations

from typing import Protocol

import sympy as sp

from gainproof.derive.any_two_state.free_numbers import free_number_steps
from gainproof.derive.any_two_state.names import INDEX
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import Model, ScaledModel
from gainproof.derive.pages.model_slots import plain
from gainproof.derive.relation import Relation, definition, described, equal

COUNTS = {2: "two", 3: "three"}


class Described(Protocol):
    """What these steps speak of: the model as it came, and scaled."""

    @property
    def original(self) -> Model: ...

    @property
    def model(self) -> ScaledModel: ...


def model_steps(c: Described) -> list[Step]:
    """From the model in its own units to the index and the parameters."""
    return [*_own_model(c), *_scaling(c), *free_number_steps(c.original)]


def _own_model(c: Described) -> list[Step]:
    model = c.original
    listed = ", ".join(f"`{plain(q.latex)}` the {q.meaning}" for q in model.quantities)
    return [
        Step(
            "model",
            f"The state `x` has {COUNTS[model.transition.rows]} entries, of which the first is "
            "measured as `y`. From one sample "
            "to the next the state moves by `F` and is shaken by process noise. Both noises are "
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


def _scaling(c: Described) -> list[Step]:
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    noise = sp.ImmutableDenseMatrix(c.model.noise_ratio * c.model.process_noise)
    return [
        Step(
            "scaled-transition",
            "Measure time in units of `T`, and each entry of the state in the unit that `T` and "
            "the deviation of the measurement give it. The transition is then free of units.",
            _scaled(c, (backward, c.original.transition, forward), c.model.transition),
            "New coordinates turn `F` of step @model into `D^-1 F D`, where `D` holds the units "
            "on its diagonal.",
        ),
        Step(
            "scaled-process-noise",
            "In the same units the process noise is one ratio times a matrix `Q0`.",
            _scaled(c, (backward, c.original.process_noise, backward), noise),
            "A covariance `Q` becomes `D^-1 Q D^-1`; `R` becomes 1.",
        ),
        Step(
            "index",
            "The root of this ratio is the tracking index `Lambda`. From here on `T = 1`, "
            "`sigma_v = 1`, and the process noise has covariance `Lambda^2 Q0`.",
            definition(INDEX**2, c.model.noise_ratio),
            "The factor in front in step @scaled-process-noise.",
        ),
    ]


def _scaled(
    c: Described, factors: tuple[sp.ImmutableDenseMatrix, ...], wanted: sp.ImmutableDenseMatrix
) -> Relation:
    own = {entry.quantity.name for entry in c.original.parameters}
    found = {str(symbol) for factor in factors for symbol in factor.free_symbols} - own
    named = [*c.original.quantities]
    free = tuple(q.name for q in named if q.name in found)
    return equal(sp.MatMul(*factors, evaluate=False), wanted, free)
