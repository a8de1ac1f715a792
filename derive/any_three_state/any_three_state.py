"""The whole derivation of a three-state model with its first state measured."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_three_state import module
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.kernels import kernel_roots
from gainproof.derive.any_three_state.names import INDEX
from gainproof.derive.any_three_state.shape import shape_of
from gainproof.derive.any_three_state.steps_forms import (
    covariance_steps,
    derivative_steps,
    form_steps,
)
from gainproof.derive.any_three_state.steps_limits import limit_steps, root_steps
from gainproof.derive.any_three_state.steps_proof import proof_steps
from gainproof.derive.any_three_state.steps_spectrum import spectrum_steps
from gainproof.derive.any_three_state.towers import Roots, roots_of
from gainproof.derive.any_two_state.kernels import SCALE, Made, known_values
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.steps_model import model_steps
from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model, ModelError
from gainproof.derive.relation import Relation, described
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
    found = module.printed(c)
    if not found.graphs:
        reasons = "; ".join(found.refused.values())
        raise ModelError(f"model {model.name}: no kernel has a proved bound: {reasons}")
    steps = (
        *model_steps(c),
        *root_steps(c),
        *spectrum_steps(c),
        *covariance_steps(c),
        *form_steps(c),
        *proof_steps(c),
        *derivative_steps(c),
        *limit_steps(c),
        *_program_steps(roots, found),
        *_refused_steps(found),
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


def _program_steps(known: Roots, found: module.Printed) -> list[Step]:
    """One step for each kernel: it computes what its outputs are called."""
    roots = kernel_roots(known.known)
    return [
        Step(
            f"kernel-{name.replace('_', '-')}",
            f"The kernel {name} computes what it says.",
            Relation("program", {"program": name, "outputs": _meant(name, entry)}),
            "Evaluate the kernel's graph in the tower.",
            hint={"graph": entry.graph, "roots": roots},
            shown=False,
        )
        for name, entry in found.graphs.items()
    ]


def _meant(kernel: str, entry: Made) -> dict[str, sp.Expr]:
    """What each output stands for; a scale is the sum of the parts whose difference it measures."""
    values = known_values(entry.values)
    meant: dict[str, sp.Expr] = {}
    for output in entry.graph["outputs"]:
        if output.endswith(SCALE):
            meant[output] = values[output]
        elif kernel == "gain_derivatives":
            meant[output] = sp.Derivative(real(output), INDEX)
        else:
            meant[output] = real(output)
    return meant


def _refused_steps(found: module.Printed) -> list[Step]:
    """Why a kernel is not printed."""
    return [
        Step(
            f"no-kernel-{name.replace('_', '-')}",
            f"There is no kernel {name}.",
            described(f"no kernel {name}: {reason}"),
            "The reason is named.",
        )
        for name, reason in found.refused.items()
    ]
