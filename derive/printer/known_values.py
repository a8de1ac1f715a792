"""Exact values of kernels at seeded points, as plain data that tests of a package read.

The values are those of the graph, in balls, and a certificate says what the graph is. What is
computed in float64 or float32 has no part in them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from random import Random
from typing import Any

import flint

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.exact import Point, enclosures_at
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Input, Kernel, Output, Requirement, least_admitted
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.signed_inputs import has_signs, references

COUNT = 8
"""Seeded points in each format, half of them of ordinary sizes."""
ORDINARY = (1e-3, 1e3)


def points(kernel: Kernel, bound: KernelBound, seed: str) -> Iterator[tuple[float, ...]]:
    """Numbers of the format for all inputs, each point once; the same for the same seed."""
    generator = Random(f"{seed} {kernel.name} {bound.format.name}")
    known = dict.fromkeys(_ends(bound))
    for turn in range(COUNT):
        known |= {
            tuple(
                _drawn(generator, given, ends, bound.format, ordinary=turn % 2 == 0)
                for given, ends in zip(kernel.inputs, bound.inputs, strict=True)
            ): None
        }
    zeros = [0.0 if given.zero else ends[1] for given, ends in _pairs(kernel, bound)]
    if any(given.zero for given in kernel.inputs):
        known |= {tuple(zeros): None}
    yield from known


def _pairs(kernel: Kernel, bound: KernelBound) -> Iterator[tuple[Input, tuple[float, float]]]:
    yield from zip(kernel.inputs, bound.inputs, strict=True)


def _ends(bound: KernelBound) -> Iterator[tuple[float, ...]]:
    """Of one input the ends of its domain and of what is promised; of several two corners."""
    for side in (0, 1):
        yield tuple(ends[side] for ends in bound.inputs)
    if len(bound.inputs) == 1:
        for output in bound.outputs:
            yield (output.lowest,)
            yield (output.highest,)


def _drawn(
    generator: Random, given: Input, ends: tuple[float, float], form: Format, *, ordinary: bool
) -> float:
    """Uniform in the logarithm; next to an end that is excluded as near as to any other number."""
    low, high = max(ends[0], form.least), ends[1]
    if ordinary:
        narrowed = max(low, ORDINARY[0]), min(high, ORDINARY[1])
        low, high = narrowed if narrowed[0] < narrowed[1] else (low, high)
    # log2 of the largest float64 rounds to 1024, whose power is no float
    exponent = generator.uniform(math.log2(low), min(math.log2(high), 1023.999999))
    whole = math.floor(exponent)
    # 2^-1074.. is subnormal: scaled after the power
    size = form.nearest(Fraction(math.ldexp(2.0 ** (exponent - whole), whole)))
    size = min(max(size, low), high)
    size = float(round(size)) if given.integer else size
    return -size if given.signed and generator.random() < 0.5 else size


DIGITS = 40
"""Significant decimal digits of a value; it is known to more than these."""
KNOWN = 2.0**-140
"""What the radius of a ball may be of the scale."""
HALVINGS = 64
PRECISIONS = (256, 1024, 4096, 8192)

Balls = Sequence[flint.arb]


def known_values(kernel: Kernel, bounds: Sequence[KernelBound], seed: str) -> dict[str, Any]:
    """Inputs with their domains, outputs with their bounds, and values at points.

    By format: of an input least and greatest number; of an output its bound in epsilons and what
    may come beside it; points, each with the numbers `at` which it is, `values` by output as text
    and `scales` of those whose error is measured by something else. A value is left out where
    nothing is promised of the output.
    """
    return {
        "inputs": [
            {
                "name": given.name,
                "whole": given.integer,
                "zero": given.zero,
                "signed": given.signed,
                **{bound.format.name: list(bound.inputs[place]) for bound in bounds},
            }
            for place, given in enumerate(kernel.inputs)
        ],
        "outputs": [
            {
                "name": output.name,
                **{
                    bound.format.name: {
                        "bound": str(bound.outputs[row].bound),
                        "beside": bound.outputs[row].beside,
                    }
                    for bound in bounds
                },
            }
            for row, output in enumerate(kernel.outputs)
        ],
        "points": {bound.format.name: _points(kernel, bound, seed) for bound in bounds},
    }


def _points(kernel: Kernel, bound: KernelBound, seed: str) -> list[dict[str, Any]]:
    form = bound.format
    used, known = references(kernel, form) if has_signs(kernel) else (kernel.program, None)
    found = []
    for drawn in points(kernel, bound, seed):
        at = together(kernel, used, known, drawn, bound)
        point = tuple(Fraction(at[_place(kernel, name)]) for name in used.inputs)
        entry = _known(kernel, bound, used, known, point, at)
        if entry is not None:
            found.append(entry)
    return found


def _place(kernel: Kernel, name: str) -> int:
    return [given.name for given in kernel.inputs].index(name)


def _known(
    kernel: Kernel,
    bound: KernelBound,
    used: Program,
    known: Sequence[Reference] | None,
    point: Point,
    at: Sequence[float],
) -> dict[str, Any] | None:
    """The entry of a point; None where the inputs together are not admitted, or too few bits are
    at hand for an output.
    """
    promised = [
        output
        for output, stated in zip(kernel.outputs, bound.outputs, strict=True)
        if len(at) > 1 or stated.lowest <= at[0] <= stated.highest
    ]
    for precision in PRECISIONS:
        balls = enclosures_at(used, point, bound.format, precision)
        with flint.ctx.workprec(precision):
            if not admitted(kernel, used, known, balls, bound.format):
                return None
            sizes = scales(used, known, balls)
            pairs = {output: _pair(output, used, balls, sizes) for output in promised}
            if all(value.rad() <= scale * KNOWN for value, scale in pairs.values()):
                entry: dict[str, Any] = {
                    "at": list(at),
                    "values": {output.name: _text(value) for output, (value, _) in pairs.items()},
                }
                measured = {o.name: _text(s) for o, (_, s) in pairs.items() if _by_other(o)}
                return entry | ({"scales": measured} if measured else {})
    return None


def _by_other(output: Output) -> bool:
    return output.by_terms or output.relative_to is not None


def admitted(
    kernel: Kernel, used: Program, known: Sequence[Reference] | None, balls: Balls, form: Format
) -> bool:
    """Whether what is required of the inputs together is so, also as it is computed."""
    return all(_fulfilled(each, used, known, balls, form) for each in kernel.requirements)


def _fulfilled(
    required: Requirement,
    used: Program,
    known: Sequence[Reference] | None,
    balls: Balls,
    form: Format,
) -> bool:
    """With room for what the computed value may be off."""
    number = used.outputs[required.name]
    value, least = balls[number], flint.arb(least_admitted(required, form))
    room = abs(least) * 2.0**-10
    if known is not None and known[number].clean:
        room = abs(value) * (2.0 * known[number].count * form.unit_roundoff)
    return bool(value > least + room)


def together(
    kernel: Kernel,
    used: Program,
    known: Sequence[Reference] | None,
    at: Sequence[float],
    bound: KernelBound,
) -> Sequence[float]:
    """A point as it is or, if its inputs together are not admitted, times a number with which they
    are, where halving finds one: what is too small asks for a larger one.
    """
    if not kernel.requirements or not any(at):
        return at
    sizes = [
        (max(low, bound.format.least) / abs(x), high / abs(x))
        for x, (low, high) in zip(at, bound.inputs, strict=True)
        if x
    ]
    low, high = max(low for low, _ in sizes), min(high for _, high in sizes)
    found, factor = list(at), 1.0
    for _ in range(HALVINGS):
        point = tuple(Fraction(found[_place(kernel, name)]) for name in used.inputs)
        balls = enclosures_at(used, point, bound.format, PRECISIONS[0])
        with flint.ctx.workprec(PRECISIONS[0]):
            short = [
                each
                for each in kernel.requirements
                if not _fulfilled(each, used, known, balls, bound.format)
            ]
        if not short:
            return found
        if least_admitted(short[0], bound.format) > 0:
            low = factor
        else:
            high = factor
        factor = math.sqrt(low) * math.sqrt(high)
        found = [bound.format.nearest(Fraction(x * factor)) for x in at]
    return at


def _pair(
    output: Output, used: Program, balls: Balls, scales: Balls
) -> tuple[flint.arb, flint.arb]:
    """An output and what its error is measured by."""
    number = used.outputs[output.name]
    if output.relative_to is not None:
        return balls[number], abs(balls[used.outputs[output.relative_to]])
    return balls[number], scales[number] if output.by_terms else abs(balls[number])


def scales(used: Program, known: Sequence[Reference] | None, balls: Balls) -> Balls:
    """Of every step its formula with the terms of sums taken positive (see `reference`)."""
    if known is None:
        return balls
    found: list[flint.arb] = []
    for number, step in enumerate(used.steps[: len(balls)]):
        parts = [found[part] for part in step.operands]
        if known[number].tight:
            found.append(abs(balls[number]))
        elif step.operation in ("add", "sub"):
            found.append(parts[0] + parts[1])
        elif step.operation == "mul":
            found.append(parts[0] * (parts[1] if step.scale is None else flint.arb(step.scale)))
        elif step.operation == "div":
            found.append(parts[0] / abs(balls[step.operands[1]]))
        elif step.operation == "atan2":
            y, x = (balls[part] for part in step.operands)
            may_turn = (parts[0] * abs(x) + parts[1] * abs(y)) / (x * x + y * y)
            found.append(abs(balls[number]) + may_turn)
        else:
            found.append(parts[0])
    return found


def _text(value: flint.arb) -> str:
    return "0" if value == 0 else str(value.mid().str(DIGITS, radius=False))
