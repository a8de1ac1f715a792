"""Proved bounds of the ways of writing one value, and which of them is best."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.derive.printer.bound import OutputBound, prove
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.stable_form.written_value import SCALE, VALUE, Text, Writing

FIRST = 8  # candidates that are tried for fewer inputs, where none has a bound for all
SHORTEST = 3  # candidates that are tried where differences are left
RANGES = (500, 200, 100, 50)  # powers of 2 that inputs are then within


@dataclass(frozen=True)
class Candidate:
    """One way of writing a value: its graph, and what is left of subtractions there.

    The graph's output is `VALUE`, and `SCALE` where a difference of computed values is left: the
    same with both sides of each added.
    """

    text: Text
    rules: tuple[str, ...]
    writing: Writing
    graph: Graph
    differences: tuple[str, ...]


@dataclass(frozen=True)
class Found:
    """The candidate that was chosen; `bound` in float64, or why there is none."""

    candidate: Candidate
    bound: OutputBound | None
    refusal: str
    tried: int


def cost(candidate: Candidate, bound: OutputBound | None) -> tuple[float, ...]:
    if bound is None:
        return (len(candidate.differences), 1, 0.0, len(candidate.graph["nodes"]))
    width = sum(math.log(high) - math.log(max(low, 2.0**-1074)) for low, high in bound.domain)
    return (len(candidate.differences), 0, -round(width), float(bound.bound))


def bounded(candidate: Candidate, inputs: Sequence[Input]) -> tuple[OutputBound | None, str]:
    try:
        return prove(kernel(candidate.graph, candidate.differences, inputs), FLOAT64).outputs[0], ""
    except (ValueError, NotImplementedError) as error:
        return None, str(error)


def kernel(graph: Graph, differences: Sequence[str], inputs: Sequence[Input]) -> Kernel:
    """A kernel of one candidate's graph, for its bound."""
    scale = SCALE if SCALE in graph["outputs"] else None
    output = Output(VALUE, "the value", relative_to=scale)
    named = dict.fromkeys(differences, "no form without it was found")
    words = ("stable_form", "StableForm", "A stable form.", ())
    return Kernel(*words, tuple(inputs), (output,), graph, "an expression", named)


def within_range(every: Sequence[Found], inputs: Sequence[Input]) -> Found:
    """The first, if it has no bound with one for fewer inputs: those far from the format's ends."""
    ranked = every[:FIRST]
    if ranked[0].bound is not None:
        return ranked[0]
    if ranked[0].candidate.differences:
        proved = [_proved(each, inputs) for each in ranked[:SHORTEST]]
        return min(proved, key=lambda each: cost(each.candidate, each.bound))
    for exponent in RANGES:
        fewer = [_nearer(given, Fraction(2) ** exponent) for given in inputs]
        if fewer == list(inputs):
            continue
        found = [
            replace(each, bound=bound)
            for each in ranked
            for bound in [bounded(each.candidate, fewer)[0]]
            if bound is not None and not each.candidate.differences
        ]
        if found:
            return min(found, key=lambda each: cost(each.candidate, each.bound))
    return ranked[0]


def _proved(found: Found, inputs: Sequence[Input]) -> Found:
    bound, reason = bounded(found.candidate, inputs)
    return replace(found, bound=bound, refusal=reason)


def _nearer(given: Input, most: Fraction) -> Input:
    """The input, not above `most` and not below its inverse."""
    low, high = constant(given.lower).rational, None
    if given.upper is not None:
        high = constant(given.upper).rational
    found = given
    if low is not None and low < 1 / most:
        found = replace(found, lower=1 / most, lower_open=False, single=None)
    if given.upper is None or (high is not None and high > most):
        found = replace(found, upper=most, upper_open=False, single=None)
    return found
