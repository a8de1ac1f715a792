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

    Of two plans the one in which an output holds steps on the way to it, if steps touch a tenth
    fewer arrays by that, more of them being done in place, and no fewer outputs are first written
    by what hides their way into the cache.
    """
    usual, straight = (_Planner(program, outputs, straight).run() for straight in (False, True))
    fewer = 10 * _touched(program, straight) <= 9 * _touched(program, usual)
    hidden = [_hidden(program, each, len(outputs)) for each in (usual, straight)]
    return straight if fewer and hidden[1] >= hidden[0] else usual


def _touched(program: Program, plan: Plan) -> int:
    """How many registers the steps read or write, each counted once a step."""
    at = plan.register
    reads = {step: {at[p] for p in program.steps[step].operands if p in at} for step in plan.order}
    return sum(len(reads[step] | {at[step]}) for step in plan.order)


def _hidden(program: Program, plan: Plan, outputs: int) -> int:
    """How many of the output arrays are first written by a slow step."""
    first: dict[int, int] = {}
    for step in plan.order:
        first.setdefault(plan.register[step], step)
    slow = (program.steps[step].operation in SLOW for at, step in first.items() if at < outputs)
    return sum(slow)


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
        dying = [register[part] for part in operands if part in register and register[part] in fits]
        best = dying + [r for r in touched if r >= places] + touched
        untouched = sorted((r for r in fits if r not in busy), key=self.filled.__getitem__)
        if self.straight:
            untouched.sort(key=lambda r: r != self._end(step))
        if self.program.steps[step].operation in SLOW:
            return untouched + best
        # what is made of inputs alone comes too early to wait in an output
        if self.straight and any(part in register for part in operands):
            return dying + [r for r in untouched if r == self._end(step)] + best
        return best

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
