"""A C program that holds a module's kernels against exact values, within their proved bounds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from gainproof.derive.printer.c_language.names import Names, codes, names_of
from gainproof.derive.printer.c_language.real_types import Flavour, flavours
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.test_program_points import points

COUNTING = """\
static int numbers, wrong;

static void expect(const char *what, size_t place, double found, double low, double high)
{
    numbers++;
    if (found >= low && found <= high)
        return;
    wrong++;
    printf("%s, point %lu: %.17g, not from %.17g to %.17g\\n", what, (unsigned long)place, found,
           low, high);
}
"""

ENDING = """\
    printf("%d of %d values are not as proved\\n", wrong, numbers);
    return wrong != 0;
}
"""


def c_trial(module: Module, values: Mapping[str, Any]) -> str:
    """The text of the program; `values` are those of `known_values`, by kernel."""
    lines = [
        f"/* Made by: {module.command} --target c",
        " *",
        f" * cc -O2 -std=c99 -ffp-contract=off {module.name}.c test_{module.name}.c -lm && ./a.out",
        " */",
        "#include <math.h>",
        "#include <stddef.h>",
        "#include <stdio.h>",
        "",
        f'#include "{module.name}.h"',
        "",
        COUNTING,
    ]
    calls = list[str]()
    for kernel in module.kernels:
        for flavour in flavours(values[kernel.name]["points"]):
            name = f"{kernel.name}{flavour.ending}"
            lines += [f"static void try_{name}(void)", "{"]
            lines += _tries(module, kernel, flavour, values[kernel.name])
            lines += ["}", ""]
            calls.append(f"    try_{name}();")
    return "\n".join([*lines, "int main(void)", "{", *calls, ENDING])


def _tries(
    module: Module, kernel: Kernel, flavour: Flavour, known: Mapping[str, Any]
) -> Iterator[str]:
    names, kind = names_of(module.name, kernel), flavour.type
    found = list(points(known, flavour.form))
    width = len(names.inputs)
    yield f"    static const {kind} at[][{width}] = {{"
    yield from (f"        {_row(flavour, at)}," for at, _ in found)
    yield "    };"
    yield f"    static const {kind} ends[][{2 * len(names.outputs)}] = {{"
    yield from (f"        {_row(flavour, ends)}," for _, ends in found)
    yield "    };"
    yield f"    {kind} {', '.join(f'{name} = 0' for name in names.outputs)};"
    targets = [f"&{name}" for name in names.outputs]
    yield "    for (size_t place = 0; place < sizeof at / sizeof at[0]; ++place) {"
    given = ", ".join([*(f"at[place][{i}]" for i in range(width)), *targets])
    yield f"        const int code = {names.function(flavour)}({given});"
    yield f'        expect("{kernel.name}{flavour.ending}", place, code, 0, 0);'
    for row, name in enumerate(names.outputs):
        bounds = ", ".join(f"(double)ends[place][{2 * row + i}]" for i in (0, 1))
        yield (
            f'        expect("{kernel.name}{flavour.ending} {name}", place, (double){name}, '
            f"{bounds});"
        )
    yield "    }"
    yield from _refusals(kernel, names, flavour, targets)


def _refusals(kernel: Kernel, names: Names, flavour: Flavour, targets: list[str]) -> Iterator[str]:
    """NaN in place of each input is refused with the input's code."""
    for row, code in enumerate(codes(kernel, names)[: len(names.inputs)]):
        given = [f"at[0][{i}]" if i != row else "NAN" for i in range(len(names.inputs))]
        call = f"{names.function(flavour)}({', '.join([*given, *targets])})"
        yield f'    expect("{kernel.name}{flavour.ending} refuses", {row}, {call}, {code}, {code});'


def _row(flavour: Flavour, numbers: list[float]) -> str:
    infinite = {float("inf"): "INFINITY", -float("inf"): "-INFINITY"}
    return f"{{{', '.join(infinite.get(x) or flavour.number(x) for x in numbers)}}}"
