"""A plan of registers in which outputs hold little beside what becomes of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from gainproof.derive.printer.program import Program
from gainproof.derive.printer.register_plan import SLOW, Lives, Plan, late, lives


def apart(program: Program, outputs: Sequence[int]) -> Plan:
    """What leads to one output alone, from the last slow step on, comes last and in its array.

    Before that the array is lent to slow steps that several others read, which hide its way into
    the cache, and to what is done in their place. All other steps are in work buffers: sums and
    products are slow to fill an array that does not begin where a line of the cache does.
    """
    order = late(program, outputs)
    readers = Counter(part for step in order for part in set(program.steps[step].operands))
    ends = lives(program, outputs, order).home
    ways = {end: _way(program, readers, ends, end) for end in ends if not readers[end]}
    last = [step for way in sorted(ways.values(), key=len) for step in way]
    of = lives(program, outputs, [step for step in order if step not in set(last)] + last)
    at_home = {step: ends[end] for end, way in ways.items() for step in way} | ends
    planner = _Planner(program, of, len(outputs), at_home, readers)
    for at, step in enumerate(of.order):
        planner.register[step] = planner.chosen(at, step)
        planner.busy[planner.register[step]] = of.last_use[step]
    work = max([*planner.register.values(), len(outputs) - 1]) + 1 - len(outputs)
    return Plan(of.order, planner.register, work, of.copies)


def _way(
    program: Program, readers: Counter[int], ends: dict[int, int], step: int
) -> tuple[int, ...]:
    """The shortest way from a slow step to this one, each of its steps read by the next alone; of
    this step alone where there is none.
    """
    if program.steps[step].operation in SLOW:
        return (step,)
    before = [
        _way(program, readers, ends, part)
        for part in program.steps[step].operands
        if readers[part] == 1 and part not in ends and program.steps[part].operands
    ]
    slow = [way for way in before if program.steps[way[0]].operation in SLOW]
    return (*min(slow, key=len, default=()), step)


@dataclass(frozen=True)
class _Planner:
    """Registers as steps get them; `busy`: the time after which each is free again."""

    program: Program
    of: Lives
    outputs: int
    at_home: dict[int, int]
    readers: Counter[int]
    register: dict[int, int] = field(default_factory=dict)
    busy: dict[int, int] = field(default_factory=dict)

    def chosen(self, at: int, step: int) -> int:
        """The register of a step that comes at this time."""
        if step in self.at_home:
            return self.at_home[step]
        operands = (self.register.get(part, -1) for part in self.program.steps[step].operands)
        dying = [r for r in operands if r in self.busy and self._fits(r, at, step)]
        if self.program.steps[step].operation in SLOW and self.readers[step] > 1:
            lent = [r for r in range(self.outputs) if self._fits(r, at, step)]
            # best the one in which it is overwritten by what becomes of it
            end = self.at_home.get(self.of.last_reader[step])
            return next(iter([r for r in lent if r == end] + lent + dying), self._buffer(at))
        return next(iter(dying), self._buffer(at))

    def _fits(self, register: int, at: int, step: int) -> bool:
        """Whether a register is free, and if it is an output's, until what becomes of it comes."""
        if self.busy.get(register, -1) > at:
            return False
        begins = [self.of.time[each] for each, home in self.at_home.items() if home == register]
        return register >= self.outputs or self.of.last_use[step] <= min(begins, default=-1)

    def _buffer(self, at: int) -> int:
        """The free work buffer that was used last, which is in the cache; else a new one."""
        used = {r: until for r, until in self.busy.items() if r >= self.outputs}
        free = [r for r, until in used.items() if until <= at]
        return max(free, key=lambda r: used[r], default=self.outputs + len(used))
