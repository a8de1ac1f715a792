"""A program as it is printed: what only says what a step means is left out."""

from __future__ import annotations

from dataclasses import replace

from gainproof.derive.printer.program import ITERATES, Program


def plain(program: Program) -> Program:
    """The same numbers of steps; a difference is a difference, and iterates are their operands.

    The steps that stand for iterates stay, and nothing uses them.
    """
    same = list(range(len(program.steps)))
    for number, step in enumerate(program.steps):
        if step.operation in ITERATES:
            same[number] = same[step.operands[0]]
    steps = tuple(
        replace(
            step,
            operands=tuple(same[part] for part in step.operands),
            operation="sub" if step.operation == "less" else step.operation,
        )
        for step in program.steps
    )
    outputs = {name: same[end] for name, end in program.outputs.items()}
    return replace(program, steps=steps, outputs=outputs, cycles=())
