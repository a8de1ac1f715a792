"""Steps on the kernels of a model with its first state measured: what they compute, or why not."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.any_two_state.kernels import SCALE, Made, known_values
from gainproof.derive.any_two_state.names import INDEX
from gainproof.derive.any_two_state.proved_module import Printed
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.relation import described

DEGREES = {"gain_derivatives": 1, "gain_second_derivatives": 2}


def kernel_steps(roots: Mapping[str, sp.Expr], found: Printed) -> list[Step]:
    """The kernels and those that are not printed; `roots` are tower values of roots in kernels."""
    return [*_program_steps(roots, found), *_refused_steps(found)]


def _program_steps(roots: Mapping[str, sp.Expr], found: Printed) -> list[Step]:
    """One step for each kernel: it computes what its outputs are called."""
    return [
        kernel_step(name, entry.graph, _meant(name, entry), roots=roots)
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


def _refused_steps(found: Printed) -> list[Step]:
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
