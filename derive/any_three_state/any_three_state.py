"""The whole derivation of a three-state model with its first state measured."""

from __future__ import annotations

from pathlib import Path

from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.kernels import kernel_roots
from gainproof.derive.any_three_state.model_numbers import shape_of
from gainproof.derive.any_three_state.module import module_of
from gainproof.derive.any_three_state.names import LATEX
from gainproof.derive.any_three_state.page_slots import given
from gainproof.derive.any_three_state.towers import roots_of
from gainproof.derive.any_two_state.programs import kernel_steps
from gainproof.derive.any_two_state.proved_module import measured_subject, require_kernels
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.model import Model, ModelError
from gainproof.derive.pages.derivation import FOLDER, written
from gainproof.derive.subject import Subject

PAGE = "first-measured-three-states"


def derive_any_three_state(model: Model, folder: Path = FOLDER) -> Subject:
    """Derive everything about the steady state of three states with the first one measured.

    The steps are those of the page `first-measured-three-states` in `folder`. Raises ModelError,
    naming the reason, for a model outside the method's reach; PageError for a mistake of the page.
    """
    c = Context(model, shape_of(model, scale_free(model)))
    if c.shape.sign(c.shape.determinant) == 0:
        raise ModelError(
            f"model {model.name}: of three states a transition with an inverse is in reach, det F "
            "= 0: its last gains are not in the poles of the filter"
        )
    roots = roots_of(c.shape)
    found = module_of(c)
    require_kernels(found, model)
    steps = kernel_steps(kernel_roots(roots.known), found)
    page = written(PAGE, given(c, steps), folder)
    return measured_subject(c, found, page, LATEX)
