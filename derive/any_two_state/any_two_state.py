"""The whole derivation of a two-state model with its first state measured."""

from __future__ import annotations

from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.module import module_of
from gainproof.derive.any_two_state.names import LATEX
from gainproof.derive.any_two_state.printed import require_kernels
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.shape import shape_of
from gainproof.derive.any_two_state.steps_covariances import covariance_steps
from gainproof.derive.any_two_state.steps_derivatives import derivative_steps
from gainproof.derive.any_two_state.steps_kernels import kernel_steps
from gainproof.derive.any_two_state.steps_limits import limit_steps
from gainproof.derive.any_two_state.steps_model import model_steps
from gainproof.derive.any_two_state.steps_proof import proof_steps
from gainproof.derive.any_two_state.steps_spectrum import spectrum_steps
from gainproof.derive.any_two_state.towers import known_roots
from gainproof.derive.derivation import Derivation
from gainproof.derive.model import Model, ModelError
from gainproof.derive.subject import Program, Subject

OPENING = (
    "The first of two states is measured at a fixed interval. How much of each innovation should a "
    "Kalman filter in its steady state believe?"
)


def derive_any_two_state(model: Model) -> Subject:
    """Derive everything about the steady state of a two-state model with its first state measured.

    Raises ModelError, naming the reason, for a model outside the method's reach.
    """
    c = Context(model, shape_of(model, scale_free(model)))
    if c.shape.sign(c.shape.entry(1, 2)) == 0:
        raise ModelError(f"model {model.name}: F12 should not vanish, the pair is unobservable")
    found = module_of(c)
    require_kernels(found, model)
    steps = (
        *model_steps(c),
        *spectrum_steps(c),
        *covariance_steps(c),
        *proof_steps(c),
        *derivative_steps(c),
        *limit_steps(c),
        *kernel_steps(known_roots(c.shape), found),
    )
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(OPENING, steps, (), {**LATEX, **c.latex()}),
        towers={"main": c.tower},
        programs={
            name: Program({entry.name: entry.name for entry in kernel.inputs}, kernel.graph)
            for name, kernel in ((entry.name, entry) for entry in found.module.kernels)
        },
        module=found.module,
        textbook=dict,
    )
