"""The whole derivation of a two-state model with its first state measured."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_two_state import module
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.kernels import KERNELS, SCALE, Made, known_values
from gainproof.derive.any_two_state.names import INDEX, LATEX
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.shape import shape_of
from gainproof.derive.any_two_state.steps_covariances import covariance_steps
from gainproof.derive.any_two_state.steps_derivatives import derivative_steps
from gainproof.derive.any_two_state.steps_limits import limit_steps
from gainproof.derive.any_two_state.steps_model import model_steps
from gainproof.derive.any_two_state.steps_proof import proof_steps
from gainproof.derive.any_two_state.steps_spectrum import spectrum_steps
from gainproof.derive.any_two_state.towers import known_roots
from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model, ModelError
from gainproof.derive.relation import Relation, described
from gainproof.derive.subject import Program, Subject

DEGREES = {"gain_derivatives": 1, "gain_second_derivatives": 2}
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
    found = module.printed(c)
    if not found.graphs:
        reasons = "; ".join(found.refused.values())
        raise ModelError(f"model {model.name}: no kernel has a proved bound: {reasons}")
    steps = (
        *model_steps(c),
        *spectrum_steps(c),
        *covariance_steps(c),
        *proof_steps(c),
        *derivative_steps(c),
        *limit_steps(c),
        *_program_steps(c, found),
        *_refused_steps(found),
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


def _program_steps(c: Context, found: module.Printed) -> list[Step]:
    """One step for each kernel: it computes what its outputs are called."""
    roots = known_roots(c.shape)
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
        elif kernel in DEGREES:
            meant[output] = sp.Derivative(real(output), (INDEX, DEGREES[kernel]))
        else:
            meant[output] = real(output)
    return meant


def _refused_steps(found: module.Printed) -> list[Step]:
    """Why a kernel is not printed."""
    return [
        Step(
            f"no-kernel-{name.replace('_', '-')}",
            f"There is no kernel {name}.",
            described(f"no kernel {name}: {found.refused[name]}"),
            "The reason is named.",
        )
        for name in KERNELS
        if name in found.refused
    ]
