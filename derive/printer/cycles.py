"""Fixed points in the forward pass: how near each iterate is.

The exact value of every iterate is the fixed point X itself, and that of every step that holds one
is its value at X. What an iterate's distance from X makes of such a step is part of its drift; the
distances follow from each other by the theorem in `newton`.
"""

from __future__ import annotations

from dataclasses import replace
from math import sqrt
from typing import TYPE_CHECKING
from weakref import proxy

import numpy as np

from gainproof.derive.printer import cube_root_start, interval
from gainproof.derive.printer.fixed_point_enclosure import UP, astray, chain, enclosed, failed
from gainproof.derive.printer.program import ITERATES, Program
from gainproof.derive.printer.ratio import ratio
from gainproof.derive.printer.step_ranges import MARGIN, Mask, PrintingError, Value
from gainproof.derive.printer.unrolled_fixed_point import Cycle

if TYPE_CHECKING:
    from gainproof.derive.printer.forward import Forward


class Cycles:
    """The fixed points of a program over the boxes of a forward pass.

    `rough`: steps whose computed values may be far from exact, being made of early iterates; their
    errors enter nothing but the distance of the next iterate.
    """

    def __init__(self, program: Program, forward: Forward) -> None:
        self.program = program
        # a reference proper would keep the arrays of every pass until cycles are looked for
        self.forward: Forward = proxy(forward)
        self.of = {number: cycle for cycle in program.cycles for number in cycle.iterates}
        self.slope = max((float(c.convergence.slope) for c in program.cycles), default=0.0) * UP
        self.roots: dict[Cycle, Value] = {}
        self.own_error: dict[Cycle, float] = {}
        self.rough = self._rough() if program.cycles else set()

    def _rough(self) -> set[int]:
        found: set[int] = set()
        for number, step in enumerate(self.program.steps):
            early = step.operation in ("near_cbrt", "start", "iterate")
            if early or (step.operation != "root" and any(p in found for p in step.operands)):
                found.add(number)
        return found

    def value(self, number: int, parts: list[Value]) -> Value | None:
        """The value of a step of a fixed point; None for any other."""
        step = self.program.steps[number]
        if step.operation in ITERATES:
            return self._iterate(number, parts[0])
        if step.operation == "near_cbrt":
            return self._near_cbrt(parts[0])
        if step.operation == "less":
            return self._less(number, parts)
        return None

    def complaint(self, box: int) -> str:
        """Which fixed points are not found in a box, in words; empty if all are."""
        names = [
            f"{self.program.steps[cycle.iterates[-1]].label or 'a fixed point'}: its start is not "
            f"shown to lie within a factor 1 + {cycle.within} of it, or something on the way to it "
            "may over- or underflow"
            for cycle in self.roots
            if failed(self.forward.values[cycle.iterates[-1]])[box]
        ]
        return "; ".join(names)

    def set_drift(self, number: int, value: Value, parts: list[Value]) -> None:
        """The drift of a rough step, where no power of a large error may be given away."""
        step = self.program.steps[number]
        if number not in self.rough or step.operation in (*ITERATES, "near_cbrt", "less"):
            return
        errors = [part.drift for part in parts]
        match step.operation:
            case "add" | "sub":
                error = max(errors)
            case "mul" | "div" if step.scale is None:
                error = _joined(*errors)
            case "sqrt":
                error = sqrt(1.0 + errors[0]) - 1.0
            case "select":
                error = max(errors[2:])
            case _:
                error = errors[0]
        value.drift = _joined(error, self.forward.unit)

    def _near_cbrt(self, part: Value) -> Value:
        third = np.full(self.forward.grid.count, 1.0 / 3.0)
        slope = interval.signed_multiply(part.slope, (third, third))
        value = Value(cube_root_start.cube_root(part.size), slope, part.sign)
        value.drift = _joined(cube_root_start.ERROR, part.drift)
        room = (1.0 + part.drift) * UP
        fine = part.size[0][0] >= self.forward.form.least_normal * room
        fine &= part.size[1][0] * room <= self.forward.form.largest
        value.invalid = ~fine | (part.sign <= 0) | astray(part)
        return value

    def _less(self, number: int, parts: list[Value]) -> Value:
        """a - b where b/a is at most the greatest slope, but for the distance of the iterate."""
        a, b = parts
        most = self.slope
        error = (a.drift + most * b.drift) / (1.0 - most) * UP
        limit = most * (1.0 + a.drift) * (1.0 + b.drift) * UP
        if not (error < 1.0 and limit < 1.0):
            node = self.program.steps[number].node
            raise PrintingError(f"node {node}: the start is too rough to bound Newton's steps")
        low, high = (np.minimum(end, limit) for end in ratio(b, a, self.forward.grid.width))
        own = 1.0 / (1.0 - low) / UP, 1.0 / (1.0 - high) * UP
        other = low / (1.0 - low) / UP, high / (1.0 - high) * UP
        size = a.size[0] * (1.0 - high) / UP, a.size[1] * (1.0 - low) * UP
        slope = interval.signed_add(
            interval.signed_multiply(a.slope, own),
            interval.signed_multiply((-b.slope[1], -b.slope[0]), other),
        )
        value = Value(size, slope, a.sign)
        value.drift = _joined(error / (1.0 - error) * UP, self.forward.unit)
        value.rounding, value.shares = self.forward.unit, (own, other)
        value.invalid = astray(a) | astray(b) | (a.sign <= 0) | (b.sign <= 0)
        return value

    def _iterate(self, number: int, expression: Value) -> Value:
        cycle = self.of[number]
        place = cycle.iterates.index(number)
        if place == 0:
            return self._start(cycle, expression)
        if cycle not in self.own_error:
            step = chain(self.program, cycle.iterates[0], self.program.steps[number].operands[0])
            exact = replace(self.roots[cycle], invalid=None)
            self.own_error[cycle] = step.followed(self.forward, exact)[0].drift
        before = self.forward.values[cycle.iterates[place - 1]].drift
        value = replace(self.roots[cycle], rounding=cycle.convergence.after_step(before) * MARGIN)
        value.drift = _joined(value.rounding, self.own_error[cycle])
        value.invalid = self._failed(number) | astray(expression)
        return value

    def _start(self, cycle: Cycle, expression: Value) -> Value:
        """The start, and what is known of the fixed point before any step."""
        image = chain(self.program, cycle.iterates[-1], cycle.map_value)
        slope = float(cycle.convergence.slope)
        value, factor = enclosed(self.forward, image, slope, expression, cycle.known)
        far = (1.0 + expression.drift) * np.maximum(factor[1], 1.0 / factor[0]) * UP
        bad = ~(far <= 1.0 + float(cycle.within)) | astray(expression) | (expression.sign <= 0)
        value.invalid = failed(value) | bad | self._failed(cycle.iterates[0])
        self.roots[cycle] = value
        return replace(value, drift=float(cycle.within) * UP)

    def _failed(self, number: int) -> Mask:
        """Where anything that leads to a step failed."""
        bad = np.zeros(self.forward.grid.count, np.bool_)
        for part in self._ancestors(number):
            bad |= failed(self.forward.values[part])
        return bad

    def _ancestors(self, number: int) -> list[int]:
        needed = set(self.program.steps[number].operands)
        for part in range(number - 1, -1, -1):
            if part in needed:
                needed.update(self.program.steps[part].operands)
        return sorted(needed)


def _joined(a: float, b: float) -> float:
    """(1 + a)(1 + b) - 1, rounded up."""
    return (a + b + a * b) * UP
