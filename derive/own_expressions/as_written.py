"""A kernel in the order of operations in which its author writes it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.derive.algebra.plain import tower_data
from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.own_expressions.formed import Formed, Ready, first_step
from gainproof.derive.own_expressions.graphs import graph_of_outputs
from gainproof.derive.own_expressions.held import arguments_of, held
from gainproof.derive.own_expressions.kernels import kernel_of
from gainproof.derive.own_expressions.parts import Parts
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.relation import Relation
from gainproof.derive.subject import Program

NO_EVIDENCE: Mapping[str, Any] = {"roots": {}, "branches": {}, "gaps": {}, "nonzero": []}
"""Polynomials are expanded and compared: nothing else is needed."""


def as_written(given: ExpressionKernel) -> Formed:
    """The kernel, and that the arguments of its parts and its outputs are these polynomials.

    NotReadError for what a kernel cannot compute, PrintingError where it has no bound.
    """
    parts = Parts()
    meant = {each.quantity.name: parts.read(each.expression) for each in given.outputs}
    graph = graph_of_outputs(meant, parts)
    kept = held(graph)
    symbols = symbols_of(kept)
    tower = Tower(f"kernel_{given.name}", tuple(map(Parameter, symbols)), (), {})
    arguments = {
        name: argument
        for part in parts.known.values()
        for name, argument in zip(
            arguments_of(part.symbol.name, len(part.arguments)), part.arguments, strict=True
        )
        if name in kept["outputs"]
    }
    step = Step(
        f"kernel-{given.name.replace('_', '-')}",
        "The kernel computes this. Each root, divisor and function is a part with a name; its "
        "arguments, and the outputs, are polynomials over the inputs and other parts.",
        Relation("program", {"program": given.name, "outputs": {**arguments, **meant}}),
        "Expand the polynomials on both sides.",
        tower=tower.name,
        hint={"evidence": NO_EVIDENCE},
    )
    return Formed(
        kernel_of(given, graph),
        {tower.name: Ready(tower_data(tower))},
        {given.name: Program({name: name for name in symbols}, kept)},
        (first_step(given, tower.name), step),
        lambda kernel: {kernel.name: held(kernel.graph)},
    )
