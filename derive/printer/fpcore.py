"""Kernels as FPCore, the format in which tools on floating-point errors exchange expressions.

FPBench 2.0, fpbench.org. An output is one core in one precision; its steps are bindings in the
order in which the kernel computes them, so that a tool sees the roundings that are made.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.formats import FLOAT64, FORMATS, Format
from gainproof.derive.printer.kernel import Input, Kernel, Module
from gainproof.derive.printer.near_cbrt import ERROR
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.register_plan import late
from gainproof.derive.printer.threshold import threshold

PRECISION = {"float64": "binary64", "float32": "binary32"}
OPERATION = {
    "add": "+",
    "sub": "-",
    "mul": "*",
    "div": "/",
    "neg": "-",
    "abs": "fabs",
    "near_cbrt": "cbrt",
}
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


def _let(steps: Program, end: int, form: Format, last: str) -> str:
    """The steps that a value needs as bindings, and what becomes of the value."""
    order = late(steps, [end])
    value = last.format(_operand(steps, end, form))
    if not order:
        return value
    gap = "\n         "
    bindings = gap.join(f"[{_step(number)} {_expression(steps, number, form)}]" for number in order)
    return f"(let* ({bindings}){gap[:-5]}{value})"


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
        least = constant(required.least if form is FLOAT64 else required.single).nearest(form)
        each.append(_let(steps, steps.outputs[required.name], form, f"(>= {{}} {literal(least)})"))
    return f"(and {' '.join(each)})" if len(each) > 1 else each[0]


def _domain(given: Input, low: float, high: float) -> str:
    size = f"(fabs {given.name})" if given.signed else given.name
    text = f"(<= {literal(low)} {size} {literal(high)})"
    if given.integer:
        text = f"(and {text} (== {given.name} (floor {given.name})))"
    return f"(or (== {given.name} 0) {text})" if given.zero else text


def _operand(steps: Program, number: int, form: Format) -> str:
    step = steps.steps[number]
    if step.operation == "input":
        return step.label
    if step.constant is not None:
        return literal(step.constant.nearest(form))
    return _step(number)


def _expression(steps: Program, number: int, form: Format) -> str:
    step: Step = steps.steps[number]
    parts = [_operand(steps, part, form) for part in step.operands]
    if step.scale is not None:
        return f"(* {parts[0]} {literal(step.scale)})"
    if step.operation == "select":
        limit = threshold(steps, step, form)
        value = literal(limit.value)
        test = f"(< {parts[0]} {value})" if limit.input_first else f"(< {value} {parts[1]})"
        return f"(if {test} {parts[2]} {parts[3]})"
    text = f"({OPERATION.get(step.operation, step.operation)} {' '.join(parts)})"
    found = in_two_parts(steps, number)
    if found is None:
        return text
    affine = found[FORMATS.index(form)]
    return f"(+ {text} {literal(affine.sign * affine.constant.remainder(form))})"
