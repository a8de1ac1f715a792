"""The whole derivation of a family with position and velocity measured.

The steps are the page `position-velocity` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.subject import Program, Subject
from gainproof.derive.vector_measurement import module
from gainproof.derive.vector_measurement.context import Context, context
from gainproof.derive.vector_measurement.corners import (
    fixed_index_tower,
    narrow_tower,
    outer_tower,
)
from gainproof.derive.vector_measurement.ends import ends_tower, index_tower
from gainproof.derive.vector_measurement.evidence_hints import hints, tower_ends
from gainproof.derive.vector_measurement.kernel_meanings import kernel_steps
from gainproof.derive.vector_measurement.names import INDEX, LATEX, UPDATED
from gainproof.derive.vector_measurement.page_slots import page_slots
from gainproof.derive.vector_measurement.pole_towers import pole_towers
from gainproof.derive.vector_measurement.textbook import textbook_forms

NAME = "position-velocity"
"""The page, for every process noise in reach."""


@dataclass(frozen=True)
class Printed:
    """What a source prints: its symbols as elements of the main tower, what the page's steps on it
    leave open, and what it says at steps of the derivation, by their ids.
    """

    elements: Callable[[Tower], Mapping[str, sp.Expr]]
    slots: Callable[[Tower], Mapping[str, object]]
    remarks: Mapping[str, str]

    def beside(self, step: Step) -> Step:
        """The step with what the source says there after its sentence."""
        remark = self.remarks.get(step.id)
        return replace(step, sentence=f"{step.sentence} {remark}") if remark else step


NOTHING = Printed(lambda _: {}, lambda _: {"source": ""}, {})


def derive_position_velocity(
    model: Model,
    sources: tuple[str, ...],
    printed: Printed = NOTHING,
    folder: Path = FOLDER,
) -> Subject:
    """Derive everything about the steady state of a model with position and velocity measured.

    `folder`: where the page is. Raises ModelError, naming the reason, for a model outside the
    method's reach, and PageError with the line of a mistake on the page.
    """
    c = context(model, printed.elements)
    graphs = module.graphs(c.noise)
    given = Given(
        towers=_towers(c),
        models={"model": c.model_data},
        slots={"": {**page_slots(c), **printed.slots(c.tower)}},
        hints=hints(c),
        ends=tower_ends(c.noise),
    )
    page = written(NAME, given, folder)
    steps = (*map(printed.beside, page.steps), *kernel_steps(c, graphs))
    latex = {
        **{
            name: shown for name, shown in {**page.latex, **LATEX}.items() if _occurs(c.tower, name)
        },
        **{quantity.name: quantity.latex for quantity in model.quantities},
    }
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(page.opening, steps, sources, latex),
        towers=page.towers,
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in graphs.items()
        },
        module=module.kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _occurs(tower: Tower, name: str) -> bool:
    """Whether a name is that of something here: a source's symbols are on its own page alone."""
    return not name.startswith("source_") or name in tower.expressions


def _towers(c: Context) -> tuple[Tower, ...]:
    """All towers of a family."""
    noise = c.noise
    towers = (
        c.tower,
        _bending_tower(c.tower),
        ends_tower(noise),
        fixed_index_tower(noise),
        narrow_tower(noise),
        *pole_towers(noise),
    )
    return (*towers, index_tower(noise), outer_tower()) if noise.determinant else towers


def _bending_tower(main: Tower) -> Tower:
    """The main tower with D, the derivative of the updated covariance by Lambda^2, by name."""
    changes = {
        entry.replace("updated", "change"): derivative(main, real(entry), "tracking_index")
        for entry in UPDATED
    }
    named = {name: main.expression(value) / (2 * INDEX) for name, value in changes.items()}
    return Tower("bending", main.parameters, main.generators, {**main.expressions, **named})
