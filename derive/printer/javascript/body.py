"""The arithmetic of a kernel as JavaScript statements, rounded as in the NumPy module.

JavaScript's numbers are float64, and its + - * / are those of IEEE 754. The standard leaves the
rounding of `Math.sqrt` to the engine; all that are known take the processor's, which is correct.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.register_plan import late
from gainproof.derive.printer.threshold import threshold

SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
RUNTIME = ("within", "refuse", "nearCubeRoot")
"""What `runtime.js` defines for kernels."""
TAKEN = frozenset(
    (
        *("arguments", "await", "break", "case", "catch", "class", "const", "continue", "debugger"),
        *("default", "delete", "do", "else", "enum", "eval", "export", "extends", "false"),
        *("finally", "for", "function", "if", "implements", "import", "in", "instanceof"),
        *("interface", "let", "new", "null", "package", "private", "protected", "public"),
        *("return", "static", "super", "switch", "this", "throw", "true", "try", "typeof"),
        *("undefined", "var", "void", "while", "with", "yield", "Infinity", "NaN", "Math"),
        *("gainproof", *RUNTIME),
    )
)
"""What no variable is called: words of JavaScript, and what the statements use."""


@dataclass(frozen=True)
class Body:
    """Statements in order, the texts of the inputs' names and of the outputs' values."""

    lines: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def body(kernel: Kernel) -> Body:
    """The steps that a kernel's outputs need."""
    steps = plain(kernel.program)
    ends = [steps.outputs[output.name] for output in kernel.outputs]
    order = late(steps, ends)
    printer = _Printer(steps, _names(kernel, steps, order))
    inputs = _argument_names(kernel)
    lines = tuple(printer.lines(order))
    return Body(lines, tuple(inputs.values()), tuple(printer.operand(end) for end in ends))


def _argument_names(kernel: Kernel) -> dict[str, str]:
    found: dict[str, str] = {}
    for given in kernel.inputs:
        found[given.name] = _fresh(given.name, set(found.values()))
    return found


def _fresh(wanted: str, taken: set[str]) -> str:
    name = wanted
    while name in TAKEN or name in taken:
        name += "_"
    return name


def _names(kernel: Kernel, steps: Program, order: Sequence[int]) -> dict[int, str]:
    """Of every input, and of every step: its label if it has one."""
    arguments = _argument_names(kernel)
    taken = set(arguments.values())
    names: dict[int, str] = {}
    for number, step in enumerate(steps.steps):
        if step.operation == "input":
            names[number] = arguments[step.label]
    for number in order:
        names[number] = _fresh(steps.steps[number].label or f"t{number}", taken)
        taken.add(names[number])
    return names


@dataclass(frozen=True)
class _Printer:
    steps: Program
    names: dict[int, str]

    def lines(self, order: Sequence[int]) -> Iterator[str]:
        for number in order:
            text = self._expression(number, self.steps.steps[number])
            yield f"const {self.names[number]} = {text};"

    def operand(self, number: int) -> str:
        constant = self.steps.steps[number].constant
        return self.names[number] if constant is None else literal(constant.nearest(FLOAT64))

    def _expression(self, number: int, step: Step) -> str:
        parts = [self.operand(part) for part in step.operands]
        if step.scale is not None:
            return f"{parts[0]} * {literal(step.scale)}"
        match step.operation:
            case "sqrt" | "abs":
                return f"Math.{step.operation}({parts[0]})"
            case "neg":
                return f"-{parts[0]}"
            case "near_cbrt":
                return f"nearCubeRoot({parts[0]})"
            case "select":
                limit = threshold(self.steps, step, FLOAT64)
                value = literal(limit.value)
                test = f"{parts[0]} < {value}" if limit.input_first else f"{value} < {parts[1]}"
                return f"{test} ? {parts[2]} : {parts[3]}"
            case name if name in FUNCTIONS:
                return f"Math.{name}({', '.join(parts)})"
        first, second = parts
        # a negative constant after a sign is a text of its own
        second = f"({second})" if second.startswith("-") else second
        plain_text = f"{first} {SIGN[step.operation]} {second}"
        found = in_two_parts(self.steps, number)
        if found is None:
            return plain_text
        rest = found[0].sign * found[0].constant.remainder(FLOAT64)
        return f"({plain_text}) + ({literal(rest)})"
