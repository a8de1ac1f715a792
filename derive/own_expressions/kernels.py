"""A user's kernel as the printer takes it.

Where both arguments of an atan2 are 0 an angle has no value; NumPy and C answer by the signs of the
zeros: 0, pi or their negatives. A bound says nothing there, so that a domain that admits it is
refused. Where the first alone is 0 and the second is negative, the angle is pi, or by the sign of a
zero -pi: that is one direction, and what is printed says so.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import replace

from gainproof.derive.own_expressions.checks import require_number
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    Result,
)
from gainproof.derive.own_expressions.kernel_names import result_class
from gainproof.derive.printer.formats import FLOAT64, FORMATS
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output, closed, signed
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.signed_inputs import has_signs, known_steps, references
from gainproof.derive.printer.step_text import formula
from gainproof.derive.quantity import ONE, Quantity

COLUMNS = 88
"""Of a formula in a docstring."""


def kernel_of(given: ExpressionKernel, graph: Graph, stepwise: bool = False) -> Kernel:
    """The kernel of this graph; `stepwise`: with bounds step by step where boxes say nothing. An
    output whose terms may cancel is measured by them.

    PrintingError where it has no bound, ExpressionError for a domain that cannot be one, or that
    admits what has no value.
    """
    made = Kernel(
        name=given.name,
        result=result_class(given.name),
        summary=f"{given.title.removesuffix('.')}.",
        equations=tuple(line for output in given.outputs for line in _formula(output)),
        inputs=inputs_of(given),
        outputs=tuple(
            Output(o.quantity.name, _meaning(o.quantity), accepted=o.by_terms)
            for o in given.outputs
        ),
        graph=graph,
        source=given.source,
        stepwise=stepwise,
        requirements=tuple(each.required for each in asked(given.conditions)),
    )
    if not has_signs(made):
        return made
    used, known = references(made, FLOAT64)
    outputs = (
        replace(output, by_terms=not known[used.outputs[output.name]].tight)
        for output in made.outputs
    )
    return with_angles(replace(made, outputs=tuple(outputs)))


def inputs_of(given: ExpressionKernel) -> tuple[Input, ...]:
    """The inputs as the printer takes them; ExpressionError for a domain that cannot be one."""
    return tuple(_input(each, given) for each in given.inputs)


def _formula(output: Result) -> Iterator[str]:
    text = f"{output.quantity.name} = {output.expression}"
    yield from textwrap.wrap(text, COLUMNS, subsequent_indent="    ", break_long_words=False)


def _meaning(quantity: Quantity) -> str:
    return quantity.meaning if quantity.unit == ONE else f"{quantity.meaning}, {quantity.unit}"


def _input(argument: Argument, kernel: ExpressionKernel) -> Input:
    quantity = argument.quantity
    place = f"{kernel.name}: {quantity.name}"
    lower, upper = require_number(place, argument.lower), argument.upper
    if lower < 0 or (upper is not None and require_number(place, upper) <= lower):
        raise ExpressionError(
            f"{place}: a domain of positive numbers is wanted, its greatest above its least, it is "
            f"{argument.lower} to {upper}; signed=True makes it one of magnitudes"
        )
    for text in argument.single or ():
        require_number(place, text)
    words = quantity.name, _meaning(quantity)
    if upper is not None and (argument.signed or lower > 0):
        if argument.signed:
            return signed(*words, argument.lower, upper, argument.single)
        return closed(*words, argument.lower, upper, argument.single, argument.zero)
    if len(kernel.inputs) > 1 or argument.signed:
        raise ExpressionError(
            f"{place}: one of several inputs, or a signed one, needs a greatest number, and a "
            f"least one above 0 unless it is signed; it is from {argument.lower} to {upper}"
            + ("; zero=True admits 0 beside such a domain" if lower == 0 else "")
        )
    if argument.zero:
        raise ExpressionError(f"{place}: 0 is admitted beside a domain with both ends above 0")
    return Input(*words, argument.lower, upper, lower == 0, upper is None, single=argument.single)


SOUTH = (
    "where y = 0 and x < 0 the sign of the zero decides between pi and -pi for atan2(y, x):",
    "bounds are of the one that it gives",
)
UNSURE = (
    "where x < 0 and y is within its error of 0 its computed sign decides between angles",
    "near pi and near -pi for atan2(y, x): bounds are up to a whole turn",
)
TERMS = (
    "terms of an angle atan2(y, x) are its magnitude and (Y |x| + X |y|)/(x^2 + y^2), with",
    "the terms Y of y and X of x taken positive",
)


def with_angles(kernel: Kernel) -> Kernel:
    """The kernel of functions or signed inputs, with a sentence on angles whose sign a zero
    decides.

    ExpressionError where both arguments of an atan2 may be 0.
    """
    angles = list(_angles(kernel))
    for over, under, apart, text in angles:
        if over.zero and under.zero and not apart:
            raise ExpressionError(
                f"{kernel.name}: atan2 has no value where both of its arguments are 0, as the "
                "domain admits; wanted: a domain in which one of them is not 0, such as one that "
                f"is not signed, or the condition {text} > 0"
            )
    said: list[str] = []
    in_south = [over.tight for over, under, _, _ in angles if over.zero and under.sign <= 0]
    if in_south:
        said += SOUTH if all(in_south) else UNSURE
    if not all(over.tight and under.tight for over, under, _, _ in angles):
        said += TERMS
    return replace(kernel, equations=(*kernel.equations, *said)) if said else kernel


def _angles(kernel: Kernel) -> Iterator[tuple[Reference, Reference, float, str]]:
    """What is known of both arguments of each atan2, in every format, what the root of the sum of
    their squares is at least, and that sum as a formula.
    """
    for form in FORMATS:
        found = known_steps(kernel, form)
        for step in found.program.steps:
            if step.operation == "atan2":
                over, under = (found.steps[part] for part in step.operands)
                texts = (f"({formula(found.program, part)})**2" for part in step.operands)
                yield over, under, found.apart(*step.operands), " + ".join(texts)
