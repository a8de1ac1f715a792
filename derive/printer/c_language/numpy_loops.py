"""The loops in C that NumPy modules call where their package is compiled: over arrays and numbers,
in a version for each set of instructions.
"""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.derive.printer.c_language.functions import head
from gainproof.derive.printer.c_language.names import Names
from gainproof.derive.printer.c_language.real_types import SINGLE, Flavour
from gainproof.derive.printer.kernel import Kernel

VERSIONS = """\

enum { LOOK = 1, FILL = 2, ROW = 256 };

#define VERSION(set, name, parameters, arguments) \\
    int set##_##name parameters { return rows_##name arguments; }
#if defined(__x86_64__)
#ifdef __clang__
#define WIDE __attribute__((target("avx512f,avx512dq,avx512vl"), min_vector_width(512)))
#else
#define WIDE __attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#endif
#define VERSIONS(name, parameters, arguments) \\
    __attribute__((target("avx2"))) VERSION(avx2, name, parameters, arguments) \\
    WIDE VERSION(avx512, name, parameters, arguments)
#define WIDE_VERSION(name, parameters, arguments) \\
    WIDE VERSION(avx512, name, parameters, arguments)
#else
#define VERSIONS(name, parameters, arguments) VERSION(plain, name, parameters, arguments)
#define WIDE_VERSION(name, parameters, arguments)
#endif

/* The sets of instructions of the versions that this processor can run, the best last. */
const char *instructions(void)
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2"))
        return "";
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
        && __builtin_cpu_supports("avx512vl"))
        return "avx2 avx512";
    return "avx2";
#else
    return "plain";
#endif
}"""
"""Without AVX2 long kernels would take longer than in NumPy: of their steps, which wait for each
other, too few are under way at once where a vector has two numbers; in float32 those with cube
roots want AVX-512.
"""


def numpy_loops(kernel: Kernel, names: Names, flavour: Flavour) -> Iterator[str]:
    """The loops of one kernel over numbers of one type, called after the set of instructions and
    the kernel's function of numbers.

    ``int avx2_NAME(size_t n, size_t how, size_t own, const double *x0, ..., double *y0, ...)``
    looks at n elements and returns 1 where one is refused, fills n results, or does one after the
    other, as `how` says. `own` has a bit for each input, the first the lowest: 1 for an array of n
    numbers, 0 for one number. Numbers are repeated along a row that stays in the nearest cache, so
    that one loop without branches serves arrays and numbers. Outputs must overlap with nothing.
    """
    kind, name = flavour.type, names.function(flavour)
    xs = [f"x{i}" for i in range(len(names.inputs))]
    ys = [f"y{i}" for i in range(len(names.outputs))]
    given = [f"const {kind} *restrict {x}" for x in xs]
    filled = [f"{kind} *restrict {y}" for y in ys]
    elements = [f"{x}[i]" for x in xs]
    yield ""
    yield head(f"static INLINE int look_{name}", ["size_t m", *given])
    yield from ("{", "    int fine = 1;", "    for (size_t i = 0; i < m; ++i)")
    yield head(f"        fine &= {names.function(flavour, '_fine')}", elements) + ";"
    yield from ("    return fine;", "}", "")
    yield head(f"static INLINE void fill_{name}", ["size_t m", *given, *filled])
    yield from ("{", "    for (size_t i = 0; i < m; ++i) {")
    yield f"        const {names.function(flavour, '_values')} values ="
    yield head(f"            {names.function(flavour, '_of')}", elements) + ";"
    fields = zip(ys, names.outputs, strict=True)
    yield from (f"        {y}[i] = values.{field};" for y, field in fields)
    yield from ("    }", "}", "")
    parameters = ["size_t n", "size_t how", "size_t own", *given, *filled]
    here = [f"own & {1 << place}u ? {x} + start : row_{x}" for place, x in enumerate(xs)]
    yield head(f"static INLINE int rows_{name}", parameters)
    yield "{"
    yield f"    const size_t length = own == {2 ** len(xs) - 1}u ? n : ROW;"
    yield from (f"    {kind} row_{x}[ROW];" for x in xs)
    yield "    for (size_t i = 0; length == ROW && i < ROW; ++i) {"
    yield from (f"        row_{x}[i] = *{x};" for x in xs)
    yield "    }"
    look = head(f"        const int fine = look_{name}", ["m", *here]) + ";"
    fill = head(f"        fill_{name}", ["m", *here, *(f"{y} + start" for y in ys)]) + ";"
    refuse = ("        if (!fine)", "            return 1;")
    for how, lines in (("LOOK", (look, *refuse)), ("FILL", (fill,))):
        yield f"    for (size_t start = 0; how & {how} && start < n; start += length) {{"
        yield "        const size_t m = n - start < length ? n - start : length;"
        yield from (*lines, "    }")
    yield from ("    return 0;", "}", "")
    roots = any(step.operation == "near_cbrt" for step in kernel.program.steps)
    versions = "WIDE_VERSION" if roots and flavour == SINGLE else "VERSIONS"
    yield f"{versions}({name}, {head('', parameters)},"
    yield f"         {head('', ['n', 'how', 'own', *xs, *ys])})"
