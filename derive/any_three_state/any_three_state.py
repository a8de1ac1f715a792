"""The whole derivation of a three-state model with its first state measured."""

from __future__ import annotations

from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.kernels import kernel_roots
from gainproof.derive.any_three_state.module import module_of
from gainproof.derive.any_three_state.shape import shape_of
from gainproof.derive.any_three_state.steps_forms import (
    covariance_steps,
    derivative_steps,
    form_steps,
)
from gainproof.derive.any_three_state.steps_limits import limit_steps, root_steps
from gainproof.derive.any_three_state.steps_proof import proof_steps
from gainproof.derive.any_three_state.steps_spectrum import spectrum_steps
from gainproof.derive.any_three_state.towers import roots_of
from gainproof.derive.any_two_state.printed import require_kernels
from gainproof.derive.any_two_state.programs import kernel_steps
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.steps_model import model_steps
from gainproof.derive.derivation import Derivation
from gainproof.derive.model import Model, ModelError
from gainproof.derive.subject import Program, Subject

OPENING = (
    "The first of three states is measured at a fixed interval. How much of each innovation should "
    "a Kalman filter in its steady state believe?"
)


def derive_any_three_state(model: Model) -> Subject:
    """Derive everything about the steady state of three states with the first one measured.

    Raises ModelError, naming the reason, for a model outside the method's reach.
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
    steps = (
        *model_steps(c),
        *root_steps(c),
        *spectrum_steps(c),
        *covariance_steps(c),
        *form_steps(c),
        *proof_steps(c),
        *derivative_steps(c),
        *limit_steps(c),
        *kernel_steps(kernel_roots(roots.known), found),
    )
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(OPENING, steps, (), c.latex()),
        towers={"main": c.tower},
        programs={
            entry.name: Program({given.name: given.name for given in entry.inputs}, entry.graph)
            for entry in found.module.kernels
        },
        module=found.module,
        textbook=dict,
    )
