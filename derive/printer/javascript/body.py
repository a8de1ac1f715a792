"""The arithmetic of a kernel as JavaScript statements, rounded as in the NumPy module.

JavaScript's numbers are float64, and its + - * / are those of IEEE 754. The standard leaves the
rounding of `Math.sqrt` to the engine; all that are known take the processor's, which is correct.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.derive.printer.emitter import Language, emitted
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.register_plan import late

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
    names = _names(kernel, steps, order)
    made = emitted(steps, ends, _JavaScript(), lambda number, _: names[number])
    return Body(made.lines, tuple(_argument_names(kernel).values()), made.outputs)


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
class _JavaScript(Language):
    def operation(self, sign: str, first: str, second: str) -> str:
        # a negative constant after a sign is a text of its own
        return super().operation(sign, first, f"({second})" if second.startswith("-") else second)

    def sum_in_two_parts(self, text: str, rest: str) -> str:
        return super().sum_in_two_parts(text, f"({rest})")

    def call(self, name: str, parts: Sequence[str]) -> str:
        if name == "near_cbrt":
            return f"nearCubeRoot({parts[0]})"
        return super().call(name if name == "neg" else f"Math.{name}", parts)

    def statement(self, name: str, text: str) -> str:
        return f"const {name} = {text};"
