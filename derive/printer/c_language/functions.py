"""The functions of one kernel in C: guards, arithmetic, and the two entries of each type."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.c_language.body import body, required
from gainproof.derive.printer.c_language.names import Names, codes
from gainproof.derive.printer.c_language.real_types import Flavour
from gainproof.derive.printer.emitter import Body
from gainproof.derive.printer.kernel import Input, Kernel


def prototypes(names: Names, flavour: Flavour) -> list[str]:
    """The two entries: of numbers, and of arrays."""
    kind = flavour.type
    numbers = [f"{kind} {name}" for name in names.inputs]
    numbers += [f"{kind} *{name}" for name in names.outputs]
    arrays = ["size_t n", *(f"const {kind} *{name}" for name in names.inputs)]
    arrays += [f"{kind} *{name}" for name in names.outputs] + ["size_t *first"]
    return [
        head(f"int {names.function(flavour)}", numbers),
        head(f"int {names.function(flavour, '_array')}", arrays),
    ]


def definitions(
    kernel: Kernel, names: Names, flavour: Flavour, bound: KernelBound
) -> tuple[list[str], bool]:
    """All functions of one type, and whether they start cube roots."""
    made = body(kernel, flavour, _input_names(kernel, names))
    wanted = required(kernel, flavour, _input_names(kernel, names))
    near = any("near_cbrt" in each.operations for each in (made, *(each for each, _ in wanted)))
    lines = [
        *_values(names, flavour, made),
        *_fine(kernel, names, flavour, bound, wanted),
        *_code(kernel, names, flavour, bound, wanted),
        *_number(names, flavour),
        *_array(names, flavour),
    ]
    return lines, near


def head(start: str, parts: list[str]) -> str:
    """A start and in parentheses what follows it, in lines that are not too long."""
    line = f"{start}({', '.join(parts)})"
    if len(line) <= 96:
        return line
    margin = " " * (4 + len(start) - len(start.lstrip()))
    rows, row = list[str](), margin
    for part in parts:
        if len(row) + len(part) > 94:
            rows.append(row.rstrip())
            row = margin
        row += f"{part}, "
    return "\n".join([f"{start}(", *rows, f"{row.rstrip(', ')})"])


def _given(names: Names, flavour: Flavour) -> list[str]:
    return [f"{flavour.type} {name}" for name in names.inputs]


def _input_names(kernel: Kernel, names: Names) -> dict[str, str]:
    return {given.name: name for given, name in zip(kernel.inputs, names.inputs, strict=True)}


def _values(names: Names, flavour: Flavour, made: Body) -> Iterator[str]:
    kind = names.function(flavour, "_values")
    yield f"typedef struct {{ {flavour.type} {', '.join(names.outputs)}; }} {kind};"
    yield ""
    yield head(f"static INLINE {kind} {names.function(flavour, '_of')}", _given(names, flavour))
    yield "{"
    yield f"    {kind} values;"
    yield from (f"    {line}" for line in made.lines)
    for output, text in zip(names.outputs, made.outputs, strict=True):
        yield f"    values.{output} = {text};"
    yield from ("    return values;", "}", "")


def _within(given: Input, name: str, flavour: Flavour, ends: tuple[float, float]) -> str:
    """One input in its domain; comparisons with NaN are false."""
    low, high = (flavour.number(end) for end in ends)
    size = f"fabs{flavour.letter}({name})" if given.signed else name
    least = [] if given.signed and not ends[0] else [f"({size} >= {low})"]
    whole = [f"({name} == floor{flavour.letter}({name}))"] if given.integer else []
    text = " & ".join([*least, f"({size} <= {high})", *whole])
    return f"(({text}) | ({name} == 0))" if given.zero and least else f"({text})"


def _fine(
    kernel: Kernel,
    names: Names,
    flavour: Flavour,
    bound: KernelBound,
    wanted: list[tuple[Body, str]],
) -> Iterator[str]:
    """Whether all is as wanted, without branches."""
    start = f"static INLINE int {names.function(flavour, '_fine')}"
    yield head(start, _given(names, flavour))
    yield "{"
    yield "    int fine = 1;"
    for given, name, ends in zip(kernel.inputs, names.inputs, bound.inputs, strict=True):
        yield f"    fine &= {_within(given, name, flavour, ends)};"
    for made, condition in wanted:
        yield from _scope(made, f"fine &= {condition};")
    yield from ("    return fine;", "}", "")


def _code(
    kernel: Kernel,
    names: Names,
    flavour: Flavour,
    bound: KernelBound,
    wanted: list[tuple[Body, str]],
) -> Iterator[str]:
    """What is the first that is not as wanted."""
    yield head(f"static int {names.function(flavour, '_code')}", _given(names, flavour))
    yield "{"
    found = codes(kernel, names)
    for given, name, ends in zip(kernel.inputs, names.inputs, bound.inputs, strict=True):
        yield f"    if (!{_within(given, name, flavour, ends)})"
        yield f"        return {found.pop(0)};"
    for made, condition in wanted:
        yield from _scope(made, f"if (!{condition})", f"    return {found.pop(0)};")
    yield from ("    return 0;", "}", "")


def _scope(made: Body, *last: str) -> Iterator[str]:
    yield "    {"
    yield from (f"        {line}" for line in (*made.lines, *last))
    yield "    }"


def _number(names: Names, flavour: Flavour) -> Iterator[str]:
    inputs = ", ".join(names.inputs)
    parts = [*_given(names, flavour), *(f"{flavour.type} *{name}" for name in names.outputs)]
    yield head(f"int {names.function(flavour)}", parts)
    yield "{"
    yield f"    if (!{names.function(flavour, '_fine')}({inputs}))"
    yield f"        return {names.function(flavour, '_code')}({inputs});"
    kind = names.function(flavour, "_values")
    yield f"    const {kind} values = {names.function(flavour, '_of')}({inputs});"
    yield from (f"    *{name} = values.{name};" for name in names.outputs)
    yield from ("    return 0;", "}", "")


def _array(names: Names, flavour: Flavour) -> Iterator[str]:
    inputs = ", ".join(f"{name}[i]" for name in names.inputs)
    kind = flavour.type
    parts = ["size_t n", *(f"const {kind} *restrict {name}" for name in names.inputs)]
    parts += [f"{kind} *restrict {name}" for name in names.outputs] + ["size_t *first"]
    values = names.function(flavour, "_values")
    yield head(f"int {names.function(flavour, '_array')}", parts)
    yield "{"
    yield "    int fine = 1;"
    yield "    for (size_t i = 0; i < n; ++i)"
    yield f"        fine &= {names.function(flavour, '_fine')}({inputs});"
    yield "    for (size_t i = 0; i < n && !fine; ++i) {"
    yield f"        const int code = {names.function(flavour, '_code')}({inputs});"
    yield "        if (code) {"
    yield "            if (first)"
    yield "                *first = i;"
    yield "            return code;"
    yield "        }"
    yield "    }"
    yield "    for (size_t i = 0; i < n; ++i) {"
    yield f"        const {values} values = {names.function(flavour, '_of')}({inputs});"
    yield from (f"        {name}[i] = values.{name};" for name in names.outputs)
    yield from ("    }", "    return 0;", "}", "")
