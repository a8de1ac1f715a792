"""The whole derivation of a two-state model with its first state measured."""

from __future__ import annotations

from pathlib import Path

from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.model_numbers import shape_of
from gainproof.derive.any_two_state.module import module_of
from gainproof.derive.any_two_state.names import LATEX
from gainproof.derive.any_two_state.page_slots import given
from gainproof.derive.any_two_state.programs import kernel_steps
from gainproof.derive.any_two_state.proved_module import measured_subject, require_kernels
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.towers import known_roots
from gainproof.derive.model import Model, ModelError
from gainproof.derive.pages.derivation import FOLDER, written
from gainproof.derive.subject import Subject

PAGE = "first-measured-two-states"


def derive_any_two_state(model: Model, folder: Path = FOLDER) -> Subject:
    """Derive everything about the steady state of a two-state model with its first state measured.

    The steps are those of the page `first-measured-two-states` in `folder`. Raises ModelError,
    naming the reason, for a model outside the method's reach; PageError for a mistake of the page.
    """
    c = Context(model, shape_of(model, scale_free(model)))
    if c.shape.sign(c.shape.entry(1, 2)) == 0:
        raise ModelError(f"model {model.name}: F12 should not vanish, the pair is unobservable")
    found = module_of(c)
    require_kernels(found, model)
    page = written(PAGE, given(c, kernel_steps(known_roots(c.shape), found)), folder)
    return measured_subject(c, found, page, LATEX)
