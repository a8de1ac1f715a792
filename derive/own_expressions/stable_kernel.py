"""A kernel in a form without cancellation, where one is found, with the proof that it is equal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from gainproof.derive.derivation import Step
from gainproof.derive.own_expressions.certified_kernel import Formed, Ready, first_step
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.own_expressions.kernels import inputs_of, kernel_of
from gainproof.derive.own_expressions.program_match import require_instance
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.relation import Relation
from gainproof.derive.stable_form import StableForm, stable
from gainproof.derive.stable_form.certificate import GIVEN, STABLE
from gainproof.derive.subject import Program

SUM = "the same with both sides of its differences added"


def rewritten(given: ExpressionKernel) -> Formed:
    """The kernel of the stable form; a subtraction that remains is named, and its output measured
    by what its two sides add up to.

    ValueError where the expressions cannot be read on their domain.
    """
    outputs = {each.quantity.name: each.expression for each in given.outputs}
    form = stable(outputs, inputs_of(given))
    kernel = kernel_of(given, form.graph)
    kernel = replace(
        kernel,
        cancellations=form.cancellations,
        outputs=tuple(
            replace(output, relative_to=form.scales[output.name], scale_meaning=SUM)
            if output.name in form.scales
            else output
            for output in kernel.outputs
        ),
    )
    document, name = form.certificate, given.name
    towers = {tower: f"{name}_{tower}" for tower in document["towers"]}
    programs = {
        f"{name}_{key}": Program(program["inputs"], program["graph"])
        for key, program in document["programs"].items()
    }
    return Formed(
        kernel,
        {towers[tower]: Ready(data) for tower, data in document["towers"].items()},
        programs,
        (first_step(given, next(iter(towers.values()))), *_steps(form, name, towers)),
        lambda made: _held(made, form, programs),
    )


def _held(kernel: Kernel, form: StableForm, programs: Mapping[str, Program]) -> dict[str, Graph]:
    """The program of each output, functions of a library as symbols; ValueError if the kernel's
    graph is not that.
    """
    start = f"{kernel.name}_{STABLE}_"
    stable_ones = {
        name.removeprefix(start): program.graph
        for name, program in programs.items()
        if name.startswith(start)
    }
    for output in kernel.outputs:
        require_instance(kernel.graph, output.name, stable_ones, form.functions)
    return {start + output.name: stable_ones[output.name] for output in kernel.outputs}


def _steps(form: StableForm, name: str, towers: Mapping[str, str]) -> Iterator[Step]:
    for statement in form.certificate["statements"]:
        kind, subject = statement["kind"], statement["tower"]
        claim = dict(statement["claim"])
        if kind == "positive":
            sentence = f"{subject} is positive: {form.positive[subject]}."
            reason = "It has no minus sign."
        elif claim["program"].startswith(GIVEN):
            sentence = f"On the domain {subject} as it came is an element of a tower of roots."
            reason = "Every root and every divisor is shown to be positive or negative."
        else:
            rules = "; ".join(form.rules.get(subject, ())) or "terms and factors in another order"
            sentence = f"The form that is printed is the same element. What was done: {rules}."
            reason = "Both are reduced to one normal form."
        if "program" in claim:
            claim["program"] = f"{name}_{claim['program']}"
        yield Step(
            f"{name}-{statement['id']}".replace("_", "-"),
            sentence,
            Relation(kind, claim),
            reason,
            tower=towers[subject],
            hint={"evidence": statement["evidence"]},
        )
