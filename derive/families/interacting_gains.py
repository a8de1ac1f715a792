"""Filters with matrix gains: what is true for every number of coordinates."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.fixed_gain import (
    interacting_setting,
    interacting_steps_best,
    interacting_steps_none,
    interacting_steps_rows,
    interacting_steps_scalar,
    interacting_steps_sharing,
)
from gainproof.derive.fixed_gain.interacting_module import kernel_module
from gainproof.derive.fixed_gain.interacting_steps_covariance import covariance_steps
from gainproof.derive.fixed_gain.interacting_steps_existence import existence_steps
from gainproof.derive.fixed_gain.interacting_steps_filter import filter_steps
from gainproof.derive.fixed_gain.interacting_steps_fixed import fixed_steps
from gainproof.derive.fixed_gain.interacting_steps_lag import lag_steps
from gainproof.derive.fixed_gain.interacting_steps_loop import loop_steps, separate_steps
from gainproof.derive.fixed_gain.interacting_steps_stationary import stationary_steps
from gainproof.derive.source import LECTURE, MATRICES
from gainproof.derive.subject import Program, Subject

NAME = "interacting-gains"
TITLE = "Filters with matrix gains"
OPENING = (
    "Several coordinates tracked together, each correcting all: the gains are matrices. What is "
    "said of matrices is proved for every number of coordinates, as an implication: what it takes "
    "for granted stands below it, after if; where nothing stands there, nothing is needed. X >= Y "
    "is the order of symmetric matrices, X - Y positive semidefinite; X > 0 is positive definite."
)


def build() -> Subject:
    """Derive filters with matrix gains."""
    made = {interacting_steps_scalar.KERNEL: interacting_steps_scalar.graph()}
    steps = (
        *filter_steps(),
        *covariance_steps(),
        *lag_steps(),
        *loop_steps(),
        *separate_steps(),
        *interacting_steps_best.best_steps(),
        *fixed_steps(),
        *interacting_steps_scalar.scalar_steps(made),
        *stationary_steps(),
        *existence_steps(),
        *interacting_steps_sharing.sharing_steps(),
        *interacting_steps_none.none_steps(),
    )
    settings = (
        interacting_setting.SETTING,
        interacting_steps_best.UPDATE,
        interacting_steps_rows.SETTING,
    )
    latex = {
        **interacting_steps_scalar.LATEX,
        **interacting_steps_none.LATEX,
        **interacting_steps_best.LATEX,
        **interacting_steps_rows.LATEX,
        **interacting_setting.LATEX,
    }
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (LECTURE.key, MATRICES.key), latex),
        towers={
            tower.name: tower
            for tower in (
                *interacting_steps_scalar.towers(),
                interacting_steps_sharing.tower(),
                interacting_steps_none.tower(),
            )
        },
        programs={
            name: Program({"variance_ratio": "variance_ratio"}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
        settings={setting.name: setting for setting in settings},
    )
