"""A kernel as a C99 loop in double precision: the same graph, for comparison of speed.

It has no guards. Compile without fast-math and with contraction off, so that every operation is
rounded as in the NumPy module.
"""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.near_cbrt import added_bits
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.registers import plan
from gainproof.derive.printer.threshold import threshold

SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def c_source(kernel: Kernel) -> str:
    """``void name(size_t n, const double *input, ..., double *output, ...)`` and its headers.

    Arrays hold n numbers each and must not overlap; inputs come first, in the kernel's order.
    """
    steps = plain(kernel.program)
    ends = [steps.outputs[output.name] for output in kernel.outputs]
    arguments = [f"const double *restrict {given.name}_in" for given in kernel.inputs]
    arguments += [f"double *restrict {output.name}_out" for output in kernel.outputs]
    lines = [
        "#include <math.h>",
        "#include <stddef.h>",
        *(_near_cbrt() if any(step.operation == "near_cbrt" for step in steps.steps) else ()),
        "",
        f"void {kernel.name}(size_t n, {', '.join(arguments)})",
        "{",
        "    for (size_t i = 0; i < n; ++i) {",
        *(f"        {line}" for line in _body(steps, ends)),
        *(
            f"        {output.name}_out[i] = {_name(steps, end)};"
            for output, end in zip(kernel.outputs, ends, strict=True)
        ),
        "    }",
        "}",
    ]
    return "\n".join(lines) + "\n"


def _near_cbrt() -> list[str]:
    """A third of a number's bits: shifts, as no vector unit divides integers."""
    sums = ["(b >> 2) + (b >> 4)", *(f"q + (q >> {count})" for count in (4, 8, 16, 32))]
    return [
        "#include <stdint.h>",
        "#include <string.h>",
        "",
        "static inline double near_cbrt(double x)",
        "{",
        "    uint64_t b, q;",
        "    memcpy(&b, &x, sizeof b);",
        *(f"    q = {each};" for each in sums),
        "    b -= q + (q << 1);",
        "    q += (b + (b << 1) + (b << 3)) >> 5;",
        f"    q += {added_bits(FLOAT64)}u;",
        "    memcpy(&x, &q, sizeof x);",
        "    return x;",
        "}",
    ]


def _body(steps: Program, ends: list[int]) -> Iterator[str]:
    needed = set(plan(steps, ends).order)
    for number, step in enumerate(steps.steps):
        if step.operation == "input":
            yield f"const double t{number} = {step.label}_in[i];"
        elif number in needed:
            remark = f" /* {step.label} */" if step.label else ""
            yield f"const double t{number} = {_expression(steps, number, step)};{remark}"


def _name(steps: Program, number: int) -> str:
    constant = steps.steps[number].constant
    return f"t{number}" if constant is None else literal(constant.nearest(FLOAT64))


def _expression(steps: Program, number: int, step: Step) -> str:
    parts = [_name(steps, part) for part in step.operands]
    if step.scale is not None:
        return f"{parts[0]} * {literal(step.scale)}"
    match step.operation:
        case "sqrt":
            return f"sqrt({parts[0]})"
        case "abs":
            return f"fabs({parts[0]})"
        case "neg":
            return f"-{parts[0]}"
        case "near_cbrt":
            return f"near_cbrt({parts[0]})"
        case "select":
            limit = threshold(steps, step, FLOAT64)
            value = literal(limit.value)
            test = f"{parts[0]} < {value}" if limit.input_first else f"{value} < {parts[1]}"
            return f"{test} ? {parts[2]} : {parts[3]}"
        case name if name in FUNCTIONS:
            return f"{name}({', '.join(parts)})"
    plain = f"{parts[0]} {SIGN[step.operation]} {parts[1]}"
    affine = affine_sum(steps, number, FLOAT64)
    if affine is None or affine.parts == 1:
        return plain
    return f"({plain}) + {literal(affine.sign * affine.constant.remainder(FLOAT64))}"
