"""The relative error that a kernel's docstring bounds, put before Gappa."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from time import perf_counter
from typing import Any

from gainproof.certify import gappa, roundings
from gainproof.certify.cover import Cover, cover
from gainproof.certify.expression import NotExportedError
from gainproof.certify.gappa import Enclosure
from gainproof.certify.operations import operations
from gainproof.certify.piece import Section
from gainproof.certify.sizes import Size, logarithm, sizes
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import program


def covered(
    graph: Mapping[str, Any],
    output: str,
    domain: tuple[Fraction, Fraction],
    bound: Fraction,
    limit: float,
    say: Callable[[int], None] = lambda _: None,
) -> Cover:
    """Whether the output's relative error is at most `bound` * 2^-52 on the domain, by pieces.

    NotExportedError for a kernel that Gappa is not asked about, or a larger bound than `MOST`.
    gappa.OutOfTimeError after `limit` seconds.
    """
    stop = perf_counter() + limit
    whole = plain(program(graph))  # type: ignore[arg-type]
    if len(whole.inputs) != 1:
        raise NotExportedError("kernels of several inputs")
    most = 2 * bound / roundings.MARGIN  # in units of 2^-53, second order taken off
    if most > roundings.MOST:
        raise NotExportedError("bounds above 512 * 2^-52")
    if domain[0] <= 0:
        raise NotExportedError("kernels of inputs that may be 0")
    (argument,) = (n for n, step in enumerate(whole.steps) if step.operation == "input")
    chosen = operations(whole.steps, whole.outputs[output])
    if not _model_holds(stop):
        raise NotExportedError("anything: Gappa does not prove what is assumed of roundings")

    def weighed(low: Fraction, high: Fraction) -> Enclosure | None:
        middle = Size((logarithm(low) + logarithm(high)) / 2, 1, Fraction(1))
        section = Section(chosen, argument, sizes(chosen, {argument: middle}), {}, {}, {})
        return roundings.weighed(section, low, high, stop)

    return cover(weighed, domain, most, say)


@cache
def _model_holds(stop: float) -> bool:
    return gappa.proves(roundings.MODEL, stop)
