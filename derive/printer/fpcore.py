"""Kernels as FPCore, the format in which tools on floating-point errors exchange expressions.

FPBench 2.0, fpbench.org. An output is one core in one precision; its steps are bindings in the
order in which the kernel computes them, so that a tool sees the roundings that are made.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.cube_root_start import ERROR
from gainproof.derive.printer.emitter import Language, emitted
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Input, Kernel, Module, least_admitted
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.register_plan import late

PRECISION = {"float64": "binary64", "float32": "binary32"}
OPERATION = {"neg": "-", "abs": "fabs", "near_cbrt": "cbrt"}
"""What FPCore calls otherwise. It has no bits of numbers: a start of a cube root is the root."""

START = "The kernel starts {} from bits, at a number within {} of the cube root."


def fpcore(module: Module, bounds: Sequence[Sequence[KernelBound]]) -> str:
    """All cores of a module, from bounds already proved."""
    lines = [f"; Made by: {module.command} --target fpcore", f"; From: {module.derivation}"]
    for kernel, pair in zip(module.kernels, bounds, strict=True):
        for bound in pair:
            for row in range(len(kernel.outputs)):
                lines += ["", *_core(module.name, kernel, bound, row)]
    return "\n".join(lines) + "\n"


def _core(module: str, kernel: Kernel, bound: KernelBound, row: int) -> Iterator[str]:
    form, output = bound.format, kernel.outputs[row]
    steps = plain(kernel.program)
    end = steps.outputs[output.name]
    order = late(steps, [end])
    starts = [number for number in order if steps.steps[number].operation == "near_cbrt"]
    yield f"(FPCore ({' '.join(given.name for given in kernel.inputs)})"
    yield f'  :name "{module}.{kernel.name}.{output.name} {form.name}"'
    yield f"  :precision {PRECISION[form.name]}"
    yield f'  :description "{_text(output.meaning)}"'
    for number in starts:
        yield f'  :gainproof-start "{START.format(_step(number), ERROR)}"'
    yield f"  :pre {_condition(kernel, steps, bound, row)}"
    yield f"  {_let(steps, end, form, '{}')})"


@dataclass(frozen=True)
class _FPCore(Language):
    def operation(self, sign: str, first: str, second: str) -> str:
        return f"({sign} {first} {second})"

    def sum_in_two_parts(self, text: str, rest: str) -> str:
        return f"(+ {text} {rest})"

    def call(self, name: str, parts: Sequence[str]) -> str:
        return f"({OPERATION.get(name, name)} {' '.join(parts)})"

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        return f"(if (< {less} {more}) {yes} {no})"

    def statement(self, name: str, text: str) -> str:
        return f"[{name} {text}]"


def _let(steps: Program, end: int, form: Format, last: str) -> str:
    """The steps that a value needs as bindings, and what becomes of the value."""

    def name(number: int, step: Step) -> str:
        return step.label if step.operation == "input" else _step(number)

    made = emitted(steps, [end], _FPCore(form), name)
    value = last.format(made.outputs[0])
    if not made.lines:
        return value
    gap = "\n         "
    return f"(let* ({gap.join(made.lines)}){gap[:-5]}{value})"


def _step(number: int) -> str:
    """The name of a step: no input has one like it, since names in Python have no dot."""
    return f"t.{number}"


def _text(words: str) -> str:
    return words.replace("\\", "\\\\").replace('"', '\\"')


def _condition(kernel: Kernel, steps: Program, bound: KernelBound, row: int) -> str:
    """Where the bound of the output is proved; of several inputs that is the kernel's domain."""
    form = bound.format
    ends = bound.outputs[row].domain if len(kernel.inputs) == 1 else bound.inputs
    each = [_domain(given, *end) for given, end in zip(kernel.inputs, ends, strict=True)]
    for required in kernel.requirements:
        least = least_admitted(required, form)
        each.append(_let(steps, steps.outputs[required.name], form, f"(>= {{}} {literal(least)})"))
    return f"(and {' '.join(each)})" if len(each) > 1 else each[0]


def _domain(given: Input, low: float, high: float) -> str:
    size = f"(fabs {given.name})" if given.signed else given.name
    text = f"(<= {literal(low)} {size} {literal(high)})"
    if given.integer:
        text = f"(and {text} (== {given.name} (floor {given.name})))"
    return f"(or (== {given.name} 0) {text})" if given.zero else text
