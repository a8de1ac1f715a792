"""Where an input may lie, and where an output's true value is a normal number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.exact import crossing, is_normal, last_that_holds
from gainproof.derive.printer.formats import FLOAT32, Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.kernel import Input
from gainproof.derive.printer.step_ranges import Box, Grid, PrintingError, true_size

FINER = 6  # bisections of all boxes before an output is given up as nowhere normal


def input_range(given: Input, form: Format) -> tuple[float, float]:
    """The least and the greatest number of the format in an input's domain.

    An end that is admitted means the number nearest to it, so that 1e-30 is in from 1e-30 on.
    """
    if given.single is not None and form is FLOAT32:
        return input_range(
            replace(given, lower=given.single[0], upper=given.single[1], single=None), form
        )
    lower = constant(given.lower)
    lowest = lower.at_least(form) if given.lower_open else lower.nearest(form)
    if given.lower_open and lower.is_exact(form):
        lowest = form.after(lowest)
    if given.upper is None:
        return lowest, form.largest
    upper = constant(given.upper)
    if upper.rational is not None and upper.rational > Fraction(form.largest):
        return lowest, form.largest
    highest = upper.at_most(form) if given.upper_open else upper.nearest(form)
    if given.upper_open and upper.is_exact(form):
        highest = form.before(highest)
    return lowest, highest


def product(inputs: Sequence[Input], form: Format) -> Box:
    """The domain of several inputs; PrintingError unless all are closed and positive."""
    for given in inputs:
        if given.upper is None or given.lower_open or given.upper_open:
            raise PrintingError(
                f"input {given.name}: a domain with both ends is wanted here: give its least and "
                "its greatest number"
            )
    domain = tuple(input_range(given, form) for given in inputs)
    for given, (low, high) in zip(inputs, domain, strict=True):
        if given.signed and low == 0 < high:
            continue
        if not form.least_normal <= low < high:
            raise PrintingError(
                f"input {given.name}: a domain of positive normal numbers is wanted here, "
                f"got {low!r} to {high!r}"
            )
    return domain


def greatest_normal(form: Format, drift: float = 0.0) -> float:
    """The largest number, less room for the rounding error of a value next to it.

    `drift`: a crude bound of that error, where it may be more than the usual room.
    """
    return form.largest * (1.0 - max(64.0 * form.epsilon, 2.0 * drift))


def normal_interval(
    forward: Forward, number: int, again: Callable[[Grid], Forward]
) -> tuple[float, float]:
    """The largest interval of inputs where a step's true value is a normal number.

    It starts from boxes where that is sure and ends at exact numbers of the format, found by
    bisection with balls. What lies between sure boxes is left to the error bound, which proves
    nothing where a value is not normal. `again` makes the forward pass over finer boxes.
    PrintingError if no box is sure.
    """
    program, form = forward.program, forward.form
    drift = np.asarray(forward.values[number].drift)
    top = greatest_normal(form, float(np.max(drift, initial=0.0, where=drift < 1e-3)))
    for _ in range(FINER):
        low, high = (end[0] for end in true_size(forward.values[number]))
        sure = np.flatnonzero((low >= form.least_normal) & (high <= top))
        if len(sure):
            break
        finer = boxes.halves(forward.grid, form)
        order = np.argsort(finer.low[0], kind="stable")
        forward = again(boxes.grid(finer.low[:, order], finer.high[:, order]))
    else:
        raise PrintingError("an output is nowhere surely a normal number")

    def normal(x: float) -> bool:
        return is_normal(program, number, x, form, top)

    def end(inside: float, places: list[float]) -> float:
        for place in places:
            if not normal(place):
                guess = crossing(program, number, inside, place, form, top)
                return last_that_holds(normal, inside, place, form, guess)
            inside = place
        return inside

    (low_ends,), (high_ends,) = forward.grid.low, forward.grid.high
    # ends of boxes may lie between numbers of a narrower format
    lows = [form.at_least(Fraction(x)) for x in low_ends[: sure[0]][::-1].tolist()]
    highs = [form.at_most(Fraction(x)) for x in high_ends[sure[-1] + 1 :].tolist()]
    first = form.at_least(Fraction(float(low_ends[sure[0]])))
    last = form.at_most(Fraction(float(high_ends[sure[-1]])))
    return end(first, lows), end(last, highs)
