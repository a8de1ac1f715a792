"""The arithmetic of a kernel as C statements, every operation rounded as in the NumPy module."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.c_language.flavour import Flavour
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.near_cbrt import added_bits
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.register_plan import late
from gainproof.derive.printer.threshold import threshold

SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
SIXTEENTHS = (4, 8, 16, 32)


@dataclass(frozen=True)
class Body:
    """Declarations of the steps in order, the texts of the outputs, and what they call of ours."""

    lines: tuple[str, ...]
    outputs: tuple[str, ...]
    near_cbrt: bool


def body(kernel: Kernel, flavour: Flavour, names: Mapping[str, str]) -> Body:
    """The steps that a kernel's outputs need; `names` of inputs are texts of their values."""
    steps = plain(kernel.program)
    ends = [steps.outputs[output.name] for output in kernel.outputs]
    printer = _Printer(steps, flavour, names)
    order = late(steps, ends)
    lines = tuple(printer.lines(order))
    near = any(steps.steps[number].operation == "near_cbrt" for number in order)
    return Body(lines, tuple(printer.operand(end) for end in ends), near)


@dataclass(frozen=True)
class _Printer:
    steps: Program
    flavour: Flavour
    names: Mapping[str, str]

    def lines(self, order: Sequence[int]) -> Iterator[str]:
        for number in order:
            step = self.steps.steps[number]
            remark = f" /* {step.label} */" if step.label else ""
            text = self._expression(number, step)
            yield f"const {self.flavour.type} t{number} = {text};{remark}"

    def operand(self, number: int) -> str:
        step = self.steps.steps[number]
        if step.operation == "input":
            return self.names[step.label]
        if step.constant is not None:
            return self.flavour.number(step.constant.nearest(self.flavour.form))
        return f"t{number}"

    def _expression(self, number: int, step: Step) -> str:
        parts = [self.operand(part) for part in step.operands]
        if step.scale is not None:
            return f"{parts[0]} * {self.flavour.number(step.scale)}"
        letter = self.flavour.letter
        match step.operation:
            case "sqrt":
                return f"sqrt{letter}({parts[0]})"
            case "abs":
                return f"fabs{letter}({parts[0]})"
            case "neg":
                return f"-{parts[0]}"
            case "near_cbrt":
                return f"near_cbrt{self.flavour.ending}({parts[0]})"
            case "select":
                limit = threshold(self.steps, step, self.flavour.form)
                value = self.flavour.number(limit.value)
                test = f"{parts[0]} < {value}" if limit.input_first else f"{value} < {parts[1]}"
                return f"{test} ? {parts[2]} : {parts[3]}"
            case name if name in FUNCTIONS:
                return f"{name}{letter}({', '.join(parts)})"
        plain_text = f"{parts[0]} {SIGN[step.operation]} {parts[1]}"
        found = in_two_parts(self.steps, number)
        if found is None:
            return plain_text
        affine = found[FORMATS.index(self.flavour.form)]
        rest = affine.sign * affine.constant.remainder(self.flavour.form)
        return f"({plain_text}) + {self.flavour.number(rest)}"


def near_cbrt(flavour: Flavour) -> list[str]:
    """A function that starts cube roots from a third of a number's bits.

    Of 64 bits the third comes by shifts, as no vector unit divides such integers.
    """
    kind, wide = flavour.type, 64 if flavour.type == "double" else 32
    third = ["q = b / 3u;"]
    if wide == 64:
        sums = ["(b >> 2) + (b >> 4)", *(f"q + (q >> {count})" for count in SIXTEENTHS)]
        third = [
            *(f"q = {each};" for each in sums),
            "b -= q + (q << 1);",
            "q += (b + (b << 1) + (b << 3)) >> 5;",
        ]
    return [
        f"static inline {kind} near_cbrt{flavour.ending}({kind} x)",
        "{",
        f"    uint{wide}_t b, q;",
        "    memcpy(&b, &x, sizeof b);",
        *(f"    {line}" for line in third),
        f"    q += {added_bits(flavour.form)}u;",
        "    memcpy(&x, &q, sizeof x);",
        "    return x;",
        "}",
        "",
    ]
