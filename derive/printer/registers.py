"""Which array each step of a program is written to: few buffers, used again as values die."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.derive.printer.output_registers import apart
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.register_plan import SLOW, Plan, late, lives


def plan(program: Program, outputs: Sequence[int]) -> Plan:
    """Registers for the steps that the outputs need; operands may be overwritten when they die.

    The usual plan has few buffers. One in which an output holds steps on the way to it comes in its
    place if steps touch a tenth fewer arrays by that, more of them being done in place; or else one
    in which outputs hold little beside what becomes of them, if fewer sums and products fill an
    output by that, with no more buffers and no more arrays touched. Neither does if fewer outputs
    are then first written by what hides their way into the cache.
    """
    usual, straight = (_Planner(program, outputs, straight).run() for straight in (False, True))
    count = len(outputs)
    touched, hidden = _touched(program, usual), _hidden(program, usual, count)
    tenth = 10 * _touched(program, straight) <= 9 * touched
    if tenth and hidden <= _hidden(program, straight, count):
        return straight
    other = apart(program, outputs)
    fits = other.work <= usual.work and _touched(program, other) <= touched
    fewer = _filled(program, other, count) < _filled(program, usual, count)
    if fits and fewer and hidden <= _hidden(program, other, count):
        return other
    return usual


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


def _filled(program: Program, plan: Plan, outputs: int) -> int:
    """How many sums and products fill an output array with what is made of others."""
    at = plan.register
    sums = [step for step in plan.order if program.steps[step].operation not in SLOW]
    return sum(
        at[step] < outputs and at[step] not in map(at.get, program.steps[step].operands)
        for step in sums
    )


class _Planner:
    """One pass over the steps in order; `straight`: see `plan`."""

    def __init__(self, program: Program, outputs: Sequence[int], straight: bool) -> None:
        self.program, self.outputs, self.straight = program, outputs, straight
        self.of = lives(program, outputs, late(program, outputs))
        self.filled = {output: self.of.time[step] for step, output in self.of.home.items()}

    def run(self) -> Plan:
        register: dict[int, int] = {}
        busy: dict[int, int] = {}  # register -> time after which it is free
        count = len(self.outputs)
        for at, step in enumerate(self.of.order):
            free = [r for r in range(count) if busy.get(r, -1) <= at]
            chosen = self.of.home.get(step)
            if chosen is None:
                chosen = next(iter(self._best(step, free, register, busy)), count)
            register[step] = chosen
            busy[chosen] = self.of.last_use[step]
            count = max(count, chosen + 1)
        return Plan(self.of.order, register, count - len(self.outputs), self.of.copies)

    def _best(
        self, step: int, free: Sequence[int], register: dict[int, int], busy: dict[int, int]
    ) -> list[int]:
        """Registers that a step may fill, best first."""
        lasts, places = self.of.last_use[step], len(self.outputs)
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
        while step not in self.of.home:
            step = self.of.last_reader[step]
        return self.of.home[step]
