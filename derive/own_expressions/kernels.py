"""A user's kernel as the printer takes it."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import replace

from gainproof.derive.own_expressions.angles import with_angles
from gainproof.derive.own_expressions.checks import require_number
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionError,
    ExpressionKernel,
    Result,
)
from gainproof.derive.own_expressions.kernel_names import result_class
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output, closed, signed
from gainproof.derive.printer.signed_inputs import has_signs, references
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
