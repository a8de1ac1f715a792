"""The whole derivation of a family with position and velocity measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.model import Model
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.subject import Program, Subject
from gainproof.derive.vector_measurement import module
from gainproof.derive.vector_measurement.context import Context, context
from gainproof.derive.vector_measurement.corners import LATEX as CORNER_LATEX
from gainproof.derive.vector_measurement.corners import fixed_index_tower, narrow_tower
from gainproof.derive.vector_measurement.ends import LATEX as END_LATEX
from gainproof.derive.vector_measurement.ends import ends_tower, index_tower
from gainproof.derive.vector_measurement.names import LATEX
from gainproof.derive.vector_measurement.pole_towers import LATEX as POLE_LATEX
from gainproof.derive.vector_measurement.pole_towers import pole_towers
from gainproof.derive.vector_measurement.steps_bending import (
    BENDING_LATEX,
    bending_steps,
    bending_tower,
)
from gainproof.derive.vector_measurement.steps_corners import corner_steps
from gainproof.derive.vector_measurement.steps_derivatives import derivative_steps
from gainproof.derive.vector_measurement.steps_entries import cross_steps
from gainproof.derive.vector_measurement.steps_limits import limit_steps
from gainproof.derive.vector_measurement.steps_model import model_steps
from gainproof.derive.vector_measurement.steps_poles import pole_steps
from gainproof.derive.vector_measurement.steps_position import position_steps
from gainproof.derive.vector_measurement.steps_program import program_steps
from gainproof.derive.vector_measurement.steps_proof import form_steps, proof_steps
from gainproof.derive.vector_measurement.steps_ratio import improvement_steps
from gainproof.derive.vector_measurement.steps_spectrum import spectrum_steps
from gainproof.derive.vector_measurement.steps_trends import trend_steps
from gainproof.derive.vector_measurement.steps_width import width_steps
from gainproof.derive.vector_measurement.steps_width_small import LATEX as WIDTH_LATEX
from gainproof.derive.vector_measurement.steps_width_small import outer_tower
from gainproof.derive.vector_measurement.steps_without_trend import without_trend_steps
from gainproof.derive.vector_measurement.textbook import textbook_forms

OPENING = (
    "A radar measures a target's position and, by its Doppler shift, the velocity, at a fixed "
    "interval. How accurate is the track in the steady state, and what does the velocity add?"
)


@dataclass(frozen=True)
class Printed:
    """What a source prints: its symbols as elements of the main tower, its equations, their LaTeX,
    and what it says at steps of the derivation, by their ids.
    """

    elements: Callable[[Tower], Mapping[str, sp.Expr]]
    steps: Callable[[Context], Sequence[Step]]
    latex: Mapping[str, str]
    places: Mapping[str, str]

    def beside(self, step: Step) -> Step:
        """The step with what the source says there after its sentence."""
        place = self.places.get(step.id)
        return replace(step, sentence=f"{step.sentence} {place}") if place else step


NOTHING = Printed(lambda _: {}, lambda _: (), {}, {})


def derive_position_velocity(
    model: Model,
    sources: tuple[str, ...],
    printed: Printed = NOTHING,
) -> Subject:
    """Derive everything about the steady state of a model with position and velocity measured.

    Raises ModelError, naming the reason, for a model outside the method's reach.
    """
    c = context(model, printed.elements)
    graphs = module.graphs(c.noise)
    steps = (
        *model_steps(c),
        *spectrum_steps(c),
        *cross_steps(c),
        *position_steps(c),
        *proof_steps(c),
        *form_steps(c),
        *printed.steps(c),
        *limit_steps(c),
        *corner_steps(c),
        *derivative_steps(c),
        *trend_steps(c),
        *without_trend_steps(c),
        *bending_steps(c),
        *improvement_steps(c),
        *width_steps(c),
        *pole_steps(c),
        *program_steps(c, graphs),
    )
    symbols = {quantity.name: quantity.latex for quantity in model.quantities}
    towers = _towers(c)
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(
            OPENING,
            tuple(printed.beside(step) for step in steps),
            sources,
            {
                **LATEX,
                **END_LATEX,
                **CORNER_LATEX,
                **WIDTH_LATEX,
                **POLE_LATEX,
                **BENDING_LATEX,
                **printed.latex,
                **symbols,
            },
        ),
        towers={tower.name: tower for tower in towers},
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in graphs.items()
        },
        module=module.kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _towers(c: Context) -> tuple[Tower, ...]:
    """All towers of a family."""
    noise = c.noise
    towers = (
        c.tower,
        bending_tower(c),
        ends_tower(noise),
        fixed_index_tower(noise),
        narrow_tower(noise),
        *pole_towers(noise),
    )
    return (*towers, index_tower(noise), outer_tower()) if noise.determinant else towers
