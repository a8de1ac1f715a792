"""The arithmetic of a kernel in double-words, as text; of arrays and of one number alike."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.double_word.float32_results import single_lines
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.layout import row
from gainproof.derive.printer.program import Step

FUNCTIONS = {"input": "exact", "add": "add", "mul": "multiply", "div": "divide", "sqrt": "root"}


def lines(kernel: Kernel) -> Iterator[str]:
    """Statements from the input to float64 results, one a step."""
    program = kernel.accurate_program
    used = {_function(step) for step in program.steps if step.operation != "constant"}
    used |= {"refined"} if kernel.refinement else set()
    yield "# loaded when it is asked for"
    yield f"from gainproof.generated._double_word import {', '.join(sorted(used))}"
    yield ""
    yield from single_lines(kernel)
    names: list[str] = []
    for number, step in enumerate(program.steps):
        if step.operation == "constant":
            names.append(_pair(step))
            continue
        name = step.label if step.label.isidentifier() else f"t{step.node}"
        names.append(f"w{number}" if name in names or name in used else name)
        if kernel.refinement and step.label == kernel.refinement.near:
            yield from _start(kernel, names[-1])
        elif kernel.refinement and step.label == kernel.refinement.root:
            near = names[[step.label for step in program.steps].index(kernel.refinement.near)]
            ends = (kernel.refinement.image, kernel.refinement.slope)
            image, slope = (names[program.outputs[end]] for end in ends)
            yield f"{names[-1]} = refined({near}, {image}, {slope})"
        else:
            yield f"{names[-1]} = {_call(step, names)}"
    values = [f"{names[program.outputs[output.name]]}[0]" for output in kernel.outputs]
    yield from row("return ", values)


def _start(kernel: Kernel, name: str) -> Iterator[str]:
    """The root's float64 start from two outputs of the plain kernel."""
    wanted = kernel.refinement
    assert wanted is not None
    outputs = [output.name for output in kernel.outputs]
    over, under = (outputs.index(each) for each in (wanted.over, wanted.under))
    yield "# what the plain kernel gives is near the root"
    signature = f"_{kernel.name.upper()}"
    yield f"near = evaluate({signature}, exact(given)[:1], None, 1)"
    yield f"{name} = exact({literal(float(wanted.factor))} * near[{over}] / near[{under}])"


def _function(step: Step) -> str:
    return "scale" if step.scale is not None else FUNCTIONS[step.operation]


def _call(step: Step, names: list[str]) -> str:
    given = [names[number] for number in step.operands]
    if step.operation == "input":
        given = ["given"]
    elif step.scale is not None:
        given.append(literal(step.scale))
    return f"{_function(step)}({', '.join(given)})"


def _pair(step: Step) -> str:
    """A constant, and what its rounding leaves, rounded."""
    value = step.constant.rational if step.constant else None
    assert value is not None
    high = float(value)
    return f"({literal(high)}, {literal(float(value - Fraction(high)))})"
