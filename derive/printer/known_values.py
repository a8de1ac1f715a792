"""Exact values of kernels at seeded points, as plain data that tests of a package read.

The values are those of the graph, in balls, and a certificate says what the graph is. What is
computed in float64 or float32 has no part in them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import flint

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.exact import Point, enclosures_at
from gainproof.derive.printer.formats import FLOAT32, Format
from gainproof.derive.printer.kernel import Kernel, Output, Requirement
from gainproof.derive.printer.points import points
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.signed_inputs import has_signs, references

DIGITS = 40
"""Significant decimal digits of a value; it is known to more than these."""
KNOWN = 2.0**-140
"""What the radius of a ball may be of the scale."""
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
    for at in points(kernel, bound, seed):
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
            if not admitted(kernel, used, balls, bound.format):
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


def admitted(kernel: Kernel, used: Program, balls: Balls, form: Format) -> bool:
    """Whether what is required of the inputs together is so, with room for rounding."""

    def limit(each: Requirement) -> flint.arb:
        least = each.single if form is FLOAT32 else each.least
        return flint.arb(constant(least).nearest(form))

    return all(
        balls[used.outputs[each.name]] > limit(each) * (1 + 2.0**-10)
        for each in kernel.requirements
    )


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
        else:
            found.append(parts[0])
    return found


def _text(value: flint.arb) -> str:
    return "0" if value == 0 else str(value.mid().str(DIGITS, radius=False))
