"""A kernel in a form without cancellation, where one is found, with the proof that it is equal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.derive.derivation import Step
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.own_expressions.formed import Formed, Ready, first_step
from gainproof.derive.own_expressions.kernels import inputs_of, kernel_of
from gainproof.derive.relation import Relation
from gainproof.derive.stable_form import StableForm, stable
from gainproof.derive.stable_form.certificate import GIVEN, STABLE
from gainproof.derive.subject import Program


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
            replace(output, relative_to=form.scales.get(output.name)) for output in kernel.outputs
        ),
    )
    document = form.certificate
    names = {GIVEN: f"{given.name}_as_given", STABLE: given.name}
    towers = {name: f"{given.name}_{name}" for name in document["towers"]}
    return Formed(
        kernel,
        {towers[name]: Ready(data) for name, data in document["towers"].items()},
        {
            names[key]: Program(program["inputs"], program["graph"])
            for key, program in document["programs"].items()
        },
        (first_step(given, next(iter(towers.values()))), *_steps(form, names, towers)),
    )


def _steps(form: StableForm, names: dict[str, str], towers: dict[str, str]) -> Iterator[Step]:
    for statement in form.certificate["statements"]:
        program, output = statement["claim"]["program"], statement["tower"]
        if program == GIVEN:
            sentence = (
                f"On the domain {output} as written is an element of a tower of positive roots."
            )
            reason = "Every root and every divisor is shown to be positive or negative."
        else:
            rules = "; ".join(form.rules[output]) or "sums and products in another order"
            sentence = f"The form that is printed is the same element. What was done: {rules}."
            reason = "Both are reduced to one normal form."
        yield Step(
            f"kernel-{names[program]}-{output}".replace("_", "-"),
            sentence,
            Relation("program", {**statement["claim"], "program": names[program]}),
            reason,
            tower=towers[output],
            hint={"evidence": statement["evidence"]},
        )
