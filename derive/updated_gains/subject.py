"""Gains that follow the tracking index to first order: errors, limits, drift, variances."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.families.random_acceleration import model
from gainproof.derive.model import scale
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.source import KALATA, MATRICES, UPDATED
from gainproof.derive.subject import Program, Subject
from gainproof.derive.updated_gains.kernels import graphs
from gainproof.derive.updated_gains.module import kernel_module
from gainproof.derive.updated_gains.names import LATEX
from gainproof.derive.updated_gains.steps_followed import followed_steps
from gainproof.derive.updated_gains.steps_gains import gain_steps
from gainproof.derive.updated_gains.steps_held import held_steps
from gainproof.derive.updated_gains.steps_kernels import INPUTS, kernel_steps
from gainproof.derive.updated_gains.steps_mismatch import mismatch_steps
from gainproof.derive.updated_gains.steps_path import path_steps
from gainproof.derive.updated_gains.steps_sight import sight_steps
from gainproof.derive.updated_gains.steps_update import update_steps
from gainproof.derive.updated_gains.steps_variance import variance_steps
from gainproof.derive.updated_gains.towers import (
    axis_tower,
    bounds_tower,
    circle_tower,
    main_tower,
    sight_tower,
    within_tower,
)

NAME = "updated-gains"
TITLE = "Gains that follow the tracking index to first order"
OPENING = (
    "A radar's Cartesian noise changes with range and angle, and with it the best gains. Instead "
    "of computing them anew one may follow their derivatives. How far does that lead, and where "
    "does it end?"
)


def build() -> Subject:
    """Derive errors, limits and drift of first-order gains, and what wrong gains cost."""
    made = graphs()
    scaled = scale(model())
    steps = (
        *gain_steps(scaled),
        *update_steps(),
        *held_steps(),
        *path_steps(),
        *mismatch_steps(),
        *followed_steps(scaled),
        *sight_steps(),
        *variance_steps(),
        *kernel_steps(made),
    )
    towers = (
        main_tower(),
        axis_tower(),
        bounds_tower(),
        circle_tower(),
        sight_tower(),
        within_tower(),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=scaled,
        derivation=Derivation(OPENING, steps, (KALATA.key, MATRICES.key, UPDATED.key), LATEX),
        towers={tower.name: tower for tower in towers},
        programs={name: Program(_inputs(name, graph), graph) for name, graph in made.items()},
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
    )


def _inputs(name: str, graph: Graph) -> dict[str, str]:
    named = INPUTS.get(name, {})
    symbols = symbols_of(graph)
    return {symbol: named.get(symbol, symbol) for symbol in symbols}
