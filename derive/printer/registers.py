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
    """Registers for the steps that the outputs need; operands may be overwritten when they die."""
    order = _needed(program, outputs)
    time = {step: at for at, step in enumerate(order)}
    last_use = dict.fromkeys(order, -1)
    for at, step in enumerate(order):
        for part in program.steps[step].operands:
            if part in last_use:
                last_use[part] = at
    home: dict[int, int] = {}
    copies: list[tuple[int, int]] = []
    for output, step in enumerate(outputs):
        if step in time and step not in home:
            home[step] = output
        else:
            copies.append((output, step))
    filled = {output: time[step] for step, output in home.items()}
    for step in home:
        last_use[step] = len(order)
    register: dict[int, int] = {}
    busy: dict[int, int] = {}  # register -> time after which it is free
    count = len(outputs)
    for at, step in enumerate(order):
        free = [r for r in range(count) if busy.get(r, -1) <= at]
        fits = [r for r in free if r >= len(outputs) or last_use[step] <= filled.get(r, -1)]
        dying = [register[p] for p in program.steps[step].operands if p in register]
        chosen = home.get(step)
        if chosen is None:
            touched = [r for r in fits if r in busy]
            best = [r for r in dying if r in fits]
            best += [r for r in touched if r >= len(outputs)] + touched
            if program.steps[step].operation in SLOW:
                untouched = [r for r in fits if r not in busy]
                best = sorted(untouched, key=filled.__getitem__) + best
            chosen = best[0] if best else count
        register[step] = chosen
        busy[chosen] = last_use[step]
        count = max(count, chosen + 1)
    return Plan(tuple(order), register, count - len(outputs), tuple(copies))


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
