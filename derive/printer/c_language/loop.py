"""A kernel as a bare C loop in double precision, without guards: for comparison of speed."""

from __future__ import annotations

from gainproof.derive.printer.c_language.body import body, near_cbrt
from gainproof.derive.printer.c_language.real_types import DOUBLE
from gainproof.derive.printer.kernel import Kernel


def c_loop(kernel: Kernel) -> str:
    """``void name(size_t n, const double *input, ..., double *output, ...)`` and its headers.

    Arrays hold n numbers each and must not overlap; inputs come first, in the kernel's order.
    Compile without fast-math and with contraction off, so that every operation is rounded as in
    the NumPy module.
    """
    arguments = [f"const double *restrict {given.name}_in" for given in kernel.inputs]
    arguments += [f"double *restrict {output.name}_out" for output in kernel.outputs]
    made = body(kernel, DOUBLE, {given.name: f"{given.name}_in[i]" for given in kernel.inputs})
    lines = [
        "#include <math.h>",
        "#include <stddef.h>",
        *(("#include <stdint.h>", "#include <string.h>") if "near_cbrt" in made.operations else ()),
        "",
        *(near_cbrt(DOUBLE) if "near_cbrt" in made.operations else ()),
        f"void {kernel.name}(size_t n, {', '.join(arguments)})",
        "{",
        "    for (size_t i = 0; i < n; ++i) {",
        *(f"        {line}" for line in made.lines),
        *(
            f"        {output.name}_out[i] = {text};"
            for output, text in zip(kernel.outputs, made.outputs, strict=True)
        ),
        "    }",
        "}",
    ]
    return "\n".join(lines) + "\n"
