"""A kernel in the order of operations in which its author writes it, or with outputs in others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from gainproof.derive.algebra.plain import tower_data
from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.equal_forms import (
    difference,
    require_values,
    same_arguments,
)
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.own_expressions.formed import Formed, Ready, first_step
from gainproof.derive.own_expressions.graphs import graph_of_outputs
from gainproof.derive.own_expressions.held import arguments_of, held
from gainproof.derive.own_expressions.kernels import kernel_of
from gainproof.derive.own_expressions.other_forms import Form
from gainproof.derive.own_expressions.parts import Parts
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.relation import Relation, equal
from gainproof.derive.subject import Program

NO_EVIDENCE: Mapping[str, Any] = {"roots": {}, "branches": {}, "gaps": {}, "nonzero": []}
"""Polynomials are expanded and compared: nothing else is needed."""


def as_written(given: ExpressionKernel, forms: Mapping[str, Form] | None = None) -> Formed:
    """The kernel, and that the arguments of its parts and its outputs are these polynomials; of
    outputs with another form, that this is equal to what its author writes.

    NotReadError for what a kernel cannot compute or another form that is not shown to be equal,
    PrintingError where it has no bound.
    """
    parts, chosen = Parts(), forms or {}
    required = asked(given.conditions)
    conditions = {each.required.name: parts.read(each.value) for each in required}
    positive = [conditions[each.required.name] for each in required if each.positive]
    outputs = {each.quantity.name: each.expression for each in given.outputs}
    printed = {name: chosen.get(name, Form(value)) for name, value in outputs.items()}
    meant = {name: parts.read(form.value, form.roots) for name, form in printed.items()}
    in_pairs = [name for name, form in printed.items() if form.in_pairs]
    graph = graph_of_outputs(meant | conditions, parts, in_pairs)
    kept, used = held(graph), list(parts.known.values())
    changed = {name: meant[name] for name, form in printed.items() if form != Form(outputs[name])}
    same = list(_same(given, parts, changed))
    require_values(used, list(parts.known.values()), positive)
    symbols = symbols_of(kept)
    sides = [side for each in same for side in each.relation.parts.values() if side]
    more = sorted({str(symbol) for side in sides for symbol in side.free_symbols})
    names = dict.fromkeys([*symbols, *more])
    tower = Tower(f"kernel_{given.name}", tuple(map(Parameter, names)), (), {})
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
        Relation(
            "program", {"program": given.name, "outputs": {**arguments, **meant, **conditions}}
        ),
        "Expand the polynomials on both sides.",
        tower=tower.name,
        hint={"evidence": NO_EVIDENCE},
    )
    return Formed(
        kernel_of(given, graph, stepwise=forms is not None),
        {tower.name: Ready(tower_data(tower))},
        {given.name: Program({name: name for name in symbols}, kept)},
        (first_step(given, tower.name), step, *(replace(each, tower=tower.name) for each in same)),
        lambda kernel: {kernel.name: held(kernel.graph)},
    )


def _same(given: ExpressionKernel, parts: Parts, meant: Mapping[str, sp.Expr]) -> Iterator[Step]:
    """That what is printed of these outputs is what was given."""
    for output in given.outputs:
        name = output.quantity.name
        if name not in meant:
            continue
        value = parts.read(output.expression)
        known = list(parts.known.values())
        start = f"form-{given.name}-{name}".replace("_", "-")
        yield Step(
            start,
            f"What is given of {name} less what is printed is a sum of multiples of what is 0, as "
            f"{'; '.join(map(str, known))}.",
            equal(value - meant[name], difference(value - meant[name], known)),
            "Expand the polynomials on both sides.",
            hint={"evidence": {"nonzero": []}},
        )
        for number, pair in enumerate(same_arguments(known), 1):
            hint = {"evidence": {"nonzero": list[str]()}}
            yield joined(f"{start}-{number}", equal(*pair), hint=hint)
