"""The relative error that a kernel's docstring bounds, put before Gappa."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from time import perf_counter
from typing import Any

from gainproof.certify import gappa, roundings, singly
from gainproof.certify.branches import branches
from gainproof.certify.cover import Cover, Weighing, cover
from gainproof.certify.expression import NotExportedError
from gainproof.certify.gappa import Enclosure
from gainproof.certify.iterated import iterated
from gainproof.certify.operations import operations
from gainproof.certify.piece import Section
from gainproof.certify.sizes import Size, logarithm, sizes
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program, program
from gainproof.derive.printer.unrolled_fixed_point import Cycle

LEAST_POSITIVE = Fraction(1, 2**1074)


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
    most = 2 * bound / roundings.MARGIN  # in units of 2^-53, second order taken off
    if most > roundings.MOST:
        raise NotExportedError("bounds above 512 * 2^-52")
    full = program(graph)  # type: ignore[arg-type]
    whole = plain(full)
    if len(whole.inputs) != 1:
        raise NotExportedError("kernels of several inputs")
    above = max(domain[0], LEAST_POSITIVE), domain[1]
    parts = [
        (part, _weighing(steps, full.cycles, output, stop))
        for part, steps in branches(whole, above)
    ]
    if domain[0] < above[0]:  # 0 is asked about by itself, with what is chosen next to it
        parts.insert(0, ((Fraction(0), Fraction(0)), parts[0][1]))
    if not _model_holds(stop):
        raise NotExportedError("anything: Gappa does not prove what is assumed of roundings")
    found = Cover(0, Fraction(0))
    for part, weighed in parts:
        before = found.pieces

        def told(pieces: int, before: int = before) -> None:
            say(before + pieces)

        own = cover(weighed, part, most, told)
        found = Cover(before + own.pieces, max(found.largest, own.largest), own.failed)
        if own.failed:
            break
    return found


def weighed_at(
    graph: Mapping[str, Any], output: str, low: Fraction, high: Fraction, limit: float
) -> Enclosure | None:
    """How much the roundings of an output weigh from low to high, in units of 2^-53.

    On a piece of few numbers it is the largest error itself. NotExportedError as `covered`, and
    where a choice changes between the ends; gappa.OutOfTimeError after `limit` seconds.
    """
    full = program(graph)  # type: ignore[arg-type]
    parts = list(branches(plain(full), (low, high)))
    if len(parts) != 1:
        raise NotExportedError("a choice that changes")
    return _weighing(parts[0][1], full.cycles, output, perf_counter() + limit)(low, high)


def _weighing(whole: Program, cycles: Sequence[Cycle], output: str, stop: float) -> Weighing:
    """How much the roundings of an output weigh on a piece, of a program that chooses nothing."""
    (argument,) = (n for n, step in enumerate(whole.steps) if step.operation == "input")
    end = whole.outputs[output]
    held = _roots(whole, cycles, end)
    root = iterated(whole.steps, held[0], end) if held else None
    chosen = () if root else operations(whole.steps, end)

    def weighed(low: Fraction, high: Fraction) -> Enclosure | None:
        if root:
            return root.weighed(argument, low, high, stop)
        alone = singly.errors(chosen, low, high, stop)
        if alone is not None:
            return alone
        middle = Size((logarithm(low) + logarithm(high)) / 2, 1, Fraction(1))
        section = Section(chosen, argument, sizes(chosen, {argument: middle}), {}, {}, {})
        return roundings.weighed(section, low, high, stop)

    return weighed


def steps_of(graph: Mapping[str, Any], output: str) -> tuple[object, ...]:
    """The steps of an output by their places: equal for outputs that are computed alike."""
    whole = program(graph)  # type: ignore[arg-type]
    place: dict[int, int] = {}
    found: list[object] = [cycle.within for cycle in whole.cycles]
    for number in sorted(_needed(whole, whole.outputs[output])):
        step = whole.steps[number]
        place[number] = len(place)
        value = step.constant.between() if step.constant else None
        parts = tuple(place[part] for part in step.operands)
        found.append((step.operation, parts, value, step.scale))
    return tuple(found)


def _needed(whole: Program, end: int) -> set[int]:
    needed, wanted = set[int](), [end]
    while wanted:
        number = wanted.pop()
        if number not in needed:
            needed.add(number)
            wanted += whole.steps[number].operands
    return needed


def _roots(whole: Program, cycles: Sequence[Cycle], end: int) -> list[Cycle]:
    """The iterated roots that an output holds. NotExportedError for several."""
    needed = _needed(whole, end)
    found = [each for each in cycles if whole.steps[each.iterates[-1]].operands[0] in needed]
    if len(found) > 1:
        raise NotExportedError("kernels with several iterated roots")
    return found


@cache
def _model_holds(stop: float) -> bool:
    return gappa.proves(roundings.MODEL, stop)
