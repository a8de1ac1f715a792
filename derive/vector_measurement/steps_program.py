"""Steps on kernels: each computes what its outputs are called."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import DERIVATIVES, SCALE
from gainproof.derive.vector_measurement.ends import FAR
from gainproof.derive.vector_measurement.module import KNOWN
from gainproof.derive.vector_measurement.pole_module import is_of_poles
from gainproof.derive.vector_measurement.rates import Rates
from gainproof.derive.vector_measurement.steps_pole_kernels import pole_program_steps
from gainproof.derive.vector_measurement.towers import graph_roots


def program_steps(c: Context, graphs: Mapping[str, Graph]) -> list[Step]:
    """One step for each kernel; the position's limits live in the tower over the index alone."""
    known = "without_ratio" if c.noise.determinant else "ends"
    roots = {**graph_roots(c.noise), "far": FAR}
    return [
        Step(
            f"kernel-{name.replace('_', '-')}",
            f"The kernel {name} computes what it says.",
            Relation("program", {"program": name, "outputs": _meant(c, name, graph)}),
            "Evaluate the kernel's graph in the tower.",
            tower=known if name == KNOWN else "main",
            hint={"graph": graph, "roots": roots},
            shown=False,
        )
        for name, graph in graphs.items()
        if not is_of_poles(name)
    ] + pole_program_steps(c, graphs)


def _meant(c: Context, kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What each output stands for; a scale is the sum of the terms whose difference it measures."""
    if kernel == KNOWN:
        return {output: real(f"known_{output}") for output in graph["outputs"]}
    _, by, variable = kernel.partition("_by_")
    if not by:
        return {output: real(output) for output in graph["outputs"]}
    found = DERIVATIVES[kernel](Rates(c.basis))
    return {
        output: sp.Add(*found[output.removesuffix(SCALE)])
        if output.endswith(SCALE)
        else sp.Derivative(real(output), real(variable))
        for output in graph["outputs"]
    }
