"""Which array each step of a program is written to: few buffers, used again as values die."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.derive.printer.program import Program

SLOW = ("div", "sqrt")
"""What hides the way of an array from memory into the cache: outputs are first written by these."""


@dataclass(frozen=True)
class Plan:
    """Steps in order with their registers: output arrays come first, work buffers after them.

    `copies` are (output, step) for outputs that are an input, a constant, or another output too.
    """

    order: tuple[int, ...]
    register: dict[int, int]
    work: int
    copies: tuple[tuple[int, int], ...]


def plan(program: Program, outputs: Sequence[int]) -> Plan:
    """Registers for the steps that the outputs need; operands may be overwritten when they die.

    Of two plans the one that first writes an output as a step on the way to that output, if it
    makes steps touch a tenth fewer arrays: more of them are done in place.
    """
    plans = [_Planner(program, outputs, straight).run() for straight in (False, True)]
    usual, straight = (_touched(program, each) for each in plans)
    return plans[10 * straight <= 9 * usual]


def _touched(program: Program, plan: Plan) -> int:
    """How many registers the steps read or write, each counted once a step."""
    at = plan.register
    reads = {step: {at[p] for p in program.steps[step].operands if p in at} for step in plan.order}
    return sum(len(reads[step] | {at[step]}) for step in plan.order)


class _Planner:
    """One pass over the steps in order; `straight`: see `plan`."""

    def __init__(self, program: Program, outputs: Sequence[int], straight: bool) -> None:
        self.program, self.outputs, self.straight = program, outputs, straight
        self.order = _needed(program, outputs)
        time = {step: at for at, step in enumerate(self.order)}
        self.last_reader: dict[int, int] = {}
        for step in self.order:
            for part in program.steps[step].operands:
                if part in time:
                    self.last_reader[part] = step
        self.home: dict[int, int] = {}
        copies: list[tuple[int, int]] = []
        for output, step in enumerate(outputs):
            if step in time and step not in self.home:
                self.home[step] = output
            else:
                copies.append((output, step))
        self.copies = tuple(copies)
        self.filled = {output: time[step] for step, output in self.home.items()}
        self.last_use = {
            step: time[self.last_reader[step]] if step in self.last_reader else -1
            for step in self.order
        }
        for step in self.home:
            self.last_use[step] = len(self.order)

    def run(self) -> Plan:
        register: dict[int, int] = {}
        busy: dict[int, int] = {}  # register -> time after which it is free
        count = len(self.outputs)
        for at, step in enumerate(self.order):
            free = [r for r in range(count) if busy.get(r, -1) <= at]
            chosen = self.home.get(step)
            if chosen is None:
                chosen = next(iter(self._best(step, free, register, busy)), count)
            register[step] = chosen
            busy[chosen] = self.last_use[step]
            count = max(count, chosen + 1)
        return Plan(tuple(self.order), register, count - len(self.outputs), self.copies)

    def _best(
        self, step: int, free: Sequence[int], register: dict[int, int], busy: dict[int, int]
    ) -> list[int]:
        """Registers that a step may fill, best first."""
        lasts, places = self.last_use[step], len(self.outputs)
        fits = [r for r in free if r >= places or lasts <= self.filled.get(r, -1)]
        touched = [r for r in fits if r in busy]
        operands = self.program.steps[step].operands
        best = [register[part] for part in operands if part in register and register[part] in fits]
        best += [r for r in touched if r >= places] + touched
        if self.program.steps[step].operation not in SLOW:
            return best
        untouched = sorted((r for r in fits if r not in busy), key=self.filled.__getitem__)
        if self.straight:
            untouched.sort(key=lambda r: r != self._end(step))
        return untouched + best

    def _end(self, step: int) -> int:
        """The output to which the last readers of a step lead, each of the one before."""
        while step not in self.home:
            step = self.last_reader[step]
        return self.home[step]


def _needed(program: Program, outputs: Sequence[int]) -> list[int]:
    """The steps, inputs and constants left out, that the outputs depend on."""
    used = set(outputs)
    for number in range(len(program.steps) - 1, -1, -1):
        if number in used:
            used.update(program.steps[number].operands)
    plain = ("input", "constant")
    steps = [number for number in sorted(used) if program.steps[number].operation not in plain]
    read = {part for number in steps for part in program.steps[number].operands}
    # outputs that nothing else needs come last: until then their arrays serve as buffers
    return [step for step in steps if step in read] + [step for step in steps if step not in read]
