"""What a plan of registers is, and what every way to make one asks of a program."""

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


@dataclass(frozen=True)
class Lives:
    """Of steps in an order: when each comes, which reads it last, and until when it is kept, -1
    where nothing reads it; `home` is the output that a step is.
    """

    order: tuple[int, ...]
    time: dict[int, int]
    last_reader: dict[int, int]
    last_use: dict[int, int]
    home: dict[int, int]
    copies: tuple[tuple[int, int], ...]


def lives(program: Program, outputs: Sequence[int], order: Sequence[int]) -> Lives:
    """Of the steps that the outputs need, in an order in which each comes after its operands."""
    time = {step: at for at, step in enumerate(order)}
    last_reader = {
        part: step for step in order for part in program.steps[step].operands if part in time
    }
    home: dict[int, int] = {}
    copies: list[tuple[int, int]] = []
    for output, step in enumerate(outputs):
        if step in time and step not in home:
            home[step] = output
        else:
            copies.append((output, step))
    last_use = {step: time[last_reader[step]] if step in last_reader else -1 for step in order}
    last_use |= dict.fromkeys(home, len(order))
    return Lives(tuple(order), time, last_reader, last_use, home, tuple(copies))


def late(program: Program, outputs: Sequence[int]) -> list[int]:
    """The steps that the outputs need, inputs and constants left out, in order; outputs that
    nothing reads come last: until then their arrays are free.
    """
    used = set(outputs)
    for number in range(len(program.steps) - 1, -1, -1):
        if number in used:
            used.update(program.steps[number].operands)
    plain = ("input", "constant")
    steps = [number for number in sorted(used) if program.steps[number].operation not in plain]
    read = {part for number in steps for part in program.steps[number].operands}
    return [step for step in steps if step in read] + [step for step in steps if step not in read]
