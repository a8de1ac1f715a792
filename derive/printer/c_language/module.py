"""A module of kernels as a C99 header and source."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterator, Sequence

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.c_language.body import near_cbrt
from gainproof.derive.printer.c_language.functions import definitions, prototypes
from gainproof.derive.printer.c_language.names import Names, codes, names_of
from gainproof.derive.printer.c_language.numpy_loops import VERSIONS, numpy_loops
from gainproof.derive.printer.c_language.real_types import DOUBLE, SINGLE, Flavour, flavours
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.docstring import described
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.library_functions import functions_of

Bounds = Sequence[Sequence[KernelBound]]

CHECKED = """\
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "compile without -ffast-math and without any of the options that it stands for"
#endif
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "every operation has to be rounded to its type: on 32-bit x86 compile with -mfpmath=sse"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__FP_FAST_FMA) && !defined(__STRICT_ANSI__) && !defined(CONTRACTION_IS_OFF)
#error "compile with -std=c99, or with -ffp-contract=off -DCONTRACTION_IS_OFF"
#endif"""
"""What is seen of options that round otherwise does not compile; GCC contracts a * b + c but in ISO
mode. Parts of -ffast-math that define no macro are not seen: the test program tells.
"""
INLINE = """\
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define INLINE inline __attribute__((always_inline))
#else
#define INLINE inline
#endif"""
"""Compilers make vectors of a loop only where all that it calls is part of it, and leave what is
large apart.
"""

ABOUT = (
    "Each kernel has an entry for numbers and one for arrays of n numbers, {}. It returns 0, or "
    "the constant of what it refuses: an input outside its domain, NaN included; nothing is "
    "written then. Of arrays the first element that is refused is written to *first, where "
    "`first` is not null; they must not overlap. Nothing is allocated, nothing is kept."
)


def c_files(module: Module, bounds: Bounds) -> dict[str, str]:
    """The header and the source by file name, from bounds already proved; a record in JSON of the
    functions that have the bits of the NumPy module, by kernel, and the loops of these that it
    calls.
    """
    same = {
        kernel.name: names_of(module.name, kernel).stem
        for kernel in module.kernels
        if not functions_of(kernel.program, kernel.program.outputs.values())
    }
    texts = {".h": _header(module, bounds), ".c": _source(module, bounds)}
    if same:
        texts["_numpy.c"] = _loops(module, bounds, same)
    return {
        f"{module.name}.json": canonical_json({"same_bits": same}),
        **{f"{module.name}{ending}": "\n".join(lines) + "\n" for ending, lines in texts.items()},
    }


def c_function(kernel: Kernel, bound: KernelBound) -> tuple[str, str]:
    """One kernel's function of double arrays as `c_files` has it, guards included: the source that
    it needs, and its name.
    """
    names = names_of("one", kernel)
    lines, near = definitions(kernel, names, DOUBLE, bound)
    headers = [f"#include <{name}.h>" for name in ("math", "stddef", "stdint", "string")]
    start = near_cbrt(DOUBLE) if near else []
    source = [*headers, "", INLINE, "", *_enumeration(kernel, names), "", *start, *lines]
    return "\n".join(source) + "\n", names.function(DOUBLE, "_array")


def c_loops(kernel: Kernel, bound: KernelBound) -> tuple[str, str]:
    """One kernel's loops over double arrays and numbers as `c_files` has them: the source, and what
    they are called after.
    """
    names = names_of("one", kernel)
    source = [c_function(kernel, bound)[0], VERSIONS, *numpy_loops(kernel, names, DOUBLE)]
    return "\n".join(source) + "\n", names.function(DOUBLE)


def _comment(lines: Sequence[str]) -> Iterator[str]:
    first, *rest = (line.replace("*/", "* /").replace("/*", "/ *") for line in lines)
    yield f"/* {first}"
    yield from (f" * {line}".rstrip() for line in rest)
    yield " */"


def _opening(module: Module) -> list[str]:
    return [f"Made by: {module.command} --target c", f"From: {module.derivation}", module.title]


def _header(module: Module, bounds: Bounds) -> Iterator[str]:
    guard = f"GAINPROOF_{module.name.upper()}_H"
    found = _flavours(bounds)
    types = " and ".join({DOUBLE: "in double", SINGLE: "(_float) in float"}[x] for x in found)
    compile_line = f"cc -O2 -std=c99 -ffp-contract=off -c {module.name}.c (linked with -lm)"
    about = textwrap.wrap(
        f"{ABOUT.format(types)} Compile with: {compile_line}", 96, break_on_hyphens=False
    )
    yield from _comment([*_opening(module), "", *about])
    yield from (f"#ifndef {guard}", f"#define {guard}", "", "#include <stddef.h>", "")
    yield from ("#ifdef __cplusplus", 'extern "C" {', "#endif")
    for kernel, pair in zip(module.kernels, bounds, strict=True):
        names = names_of(module.name, kernel)
        yield from ("", *_comment(described(kernel, pair)), *_enumeration(kernel, names))
        for flavour in found:
            yield from (f"{line};" for line in prototypes(names, flavour))
    yield from ("", "#ifdef __cplusplus", "}", "#endif", "", "#endif")


def _flavours(bounds: Bounds) -> list[Flavour]:
    return flavours([bound.format.name for bound in bounds[0]])


def _enumeration(kernel: Kernel, names: Names) -> Iterator[str]:
    yield "enum {"
    found = [f"    {code} = {place}" for place, code in enumerate(codes(kernel, names), start=1)]
    yield ",\n".join(found)
    yield "};"


def _source(module: Module, bounds: Bounds) -> Iterator[str]:
    parts, starts = list[str](), list[str]()
    for flavour, row in zip(_flavours(bounds), zip(*bounds, strict=True), strict=True):
        any_near = False
        for kernel, bound in zip(module.kernels, row, strict=True):
            lines, near = definitions(kernel, names_of(module.name, kernel), flavour, bound)
            parts += lines
            any_near |= near
        starts += near_cbrt(flavour) if any_near else []
    yield from _comment(_opening(module))
    yield f'#include "{module.name}.h"'
    yield from ("", "#include <float.h>", "#include <math.h>")
    yield from ("#include <stdint.h>", "#include <string.h>") if starts else ()
    yield from ("", CHECKED, INLINE, "", *starts, *parts[:-1])


def _loops(module: Module, bounds: Bounds, wanted: Collection[str]) -> Iterator[str]:
    yield from _comment([*_opening(module), "", "What the NumPy module calls."])
    yield from (f'#include "{module.name}.c"', "", VERSIONS)
    for kernel in module.kernels:
        if kernel.name in wanted:
            for flavour in _flavours(bounds):
                yield from numpy_loops(kernel, names_of(module.name, kernel), flavour)
