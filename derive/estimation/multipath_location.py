"""Location from range and Doppler in multipath: what holds for every number of stations."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.estimation import (
    bias_kernel,
    example_steps,
    free_setting,
    linear_setting,
    location_latex,
    location_setting,
    order_setting,
    selection_order_steps,
    selection_setting,
)
from gainproof.derive.estimation.estimate_parts_steps import parts_steps
from gainproof.derive.estimation.fewer_unknowns_steps import fewer_steps
from gainproof.derive.estimation.free_steps import free_steps
from gainproof.derive.estimation.least_squares_steps import least_squares_steps
from gainproof.derive.estimation.linear_facts import facts
from gainproof.derive.estimation.location_bias_steps import bias_steps
from gainproof.derive.estimation.location_covariance_steps import covariance_steps
from gainproof.derive.estimation.location_doppler_steps import doppler_steps
from gainproof.derive.estimation.location_facts import Found
from gainproof.derive.estimation.location_model_steps import model_steps
from gainproof.derive.estimation.location_noise_steps import noise_steps
from gainproof.derive.estimation.location_rank_steps import rank_steps
from gainproof.derive.estimation.location_solvable_steps import (
    solvable_steps as location_solvable_steps,
)
from gainproof.derive.estimation.order_steps import order_steps
from gainproof.derive.estimation.schur_inverse_steps import inverse_steps
from gainproof.derive.estimation.schur_steps import schur_steps
from gainproof.derive.estimation.selection_steps import selection_steps
from gainproof.derive.estimation.solvable_steps import solvable_steps
from gainproof.derive.source import DOPPLER, MATRICES
from gainproof.derive.subject import Program, Subject

NAME = "multipath-location"
TITLE = "Location from range and Doppler in multipath"
OPENING = (
    "A target is located by ranges and Doppler of n stations, some ranges having a bias of their "
    "own from multipath; linear about a start. What is said of matrices is proved for every number "
    "of stations, of clean ranges and of coordinates, also where ranges and Doppler are "
    "correlated, as an implication: what it takes for granted stands below it, after if. X >= Y is "
    "the order of symmetric matrices, X - Y positive semidefinite; X > 0 is positive definite. "
    "Numbers in brackets are those of the paper."
)


def build() -> Subject:
    """Derive the estimates, their covariances, and when they exist."""
    known, found = facts(), Found()
    made = {bias_kernel.KERNEL: bias_kernel.graph()}
    steps = (
        *least_squares_steps(),
        *parts_steps(known),
        *solvable_steps(known),
        *fewer_steps(known),
        *model_steps(found),
        *location_solvable_steps(found),
        *rank_steps(found),
        *covariance_steps(found),
        *selection_steps(),
        *selection_order_steps.order_steps(),
        *noise_steps(found),
        *bias_steps(found),
        *doppler_steps(found),
        *free_steps(),
        *bias_kernel.kernel_steps(made),
        *example_steps.example_steps(),
        *schur_steps(),
        *inverse_steps(),
        *order_steps(),
    )
    settings = (
        linear_setting.LINEAR,
        location_setting.LOCATION,
        selection_setting.SELECTION,
        free_setting.FREE,
        order_setting.BLOCKS,
        order_setting.ORDER,
    )
    latex = {
        **order_setting.LATEX,
        **selection_setting.LATEX,
        **linear_setting.LATEX,
        **free_setting.LATEX,
        **location_latex.LATEX,
        **bias_kernel.LATEX,
        **example_steps.LATEX,
    }
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (DOPPLER.key, MATRICES.key), latex),
        towers={tower.name: tower for tower in (bias_kernel.tower(), example_steps.tower())},
        programs={
            name: Program({bias_kernel.INPUT: bias_kernel.INPUT}, graph)
            for name, graph in made.items()
        },
        module=bias_kernel.kernel_module(NAME, TITLE, made),
        textbook=dict,
        settings={setting.name: setting for setting in settings},
    )
