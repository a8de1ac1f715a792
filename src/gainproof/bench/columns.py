"""What the columns of `gainproof bench` are: one list for the terminal, the page and --help."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

Row = Mapping[str, Any]


@dataclass(frozen=True)
class Column:
    """A ratio of two calls of a row, by name: its heading on the page, in a terminal (None: not
    there), and what it means in a sentence.
    """

    over: str
    under: str
    title: str
    short: str | None
    meaning: str

    def value(self, row: Row) -> float | None:
        """The ratio; None where one of the two was not measured."""
        seconds = row["seconds"]
        if self.over not in seconds or self.under not in seconds:
            return None
        return float(seconds[self.over]) / float(seconds[self.under])


KERNEL_OVER = (
    Column(
        "kernel",
        "C function",
        "kernel / C function",
        "/Cg",
        "the kernel's time over that of the C function of `generate --target c`, which looks at "
        "all inputs first as the kernel does",
    ),
    Column(
        "shared",
        "C function",
        "threads / C function",
        "t/Cg",
        "the same where threads share the blocks",
    ),
    Column(
        "in C",
        "C function",
        "compiled / C function",
        "c/Cg",
        "the same for the kernel of a package that is compiled: guards and arithmetic in C, the "
        "same bits",
    ),
    Column(
        "in C shared",
        "C function",
        "compiled, threads / C function",
        None,
        "the same where threads share the elements",
    ),
    Column(
        "in C",
        "kernel",
        "compiled / kernel",
        "c/np",
        "the compiled kernel's time over the kernel's",
    ),
    Column(
        "thousand in C",
        "thousand",
        "compiled / kernel, a thousand points",
        "1k",
        "the same where a call has a thousand points",
    ),
    Column(
        "kernel",
        "C",
        "kernel / C",
        "/C",
        "the kernel's time, guards included, over that of a bare C loop of its graph without any",
    ),
    Column("shared", "C", "threads / C", None, "the same where threads share the blocks"),
    Column(
        "passes",
        "C",
        "passes / C",
        None,
        "the same for the bare NumPy calls on a block in the cache, without guards and memory "
        "traffic: no NumPy kernel of this graph is faster in one thread",
    ),
    Column(
        "kernel",
        "memory",
        "kernel / memory",
        "/mem",
        "the kernel's time over that of reading its input arrays once and filling its output "
        "arrays once: what memory alone takes",
    ),
    Column(
        "one number",
        "formula",
        "one number / formula",
        "1/py",
        "the kernel called with Python floats, a call a point, over the plain Python formula of "
        "its graph by `math`, without guards and names",
    ),
)
OVER_KERNEL = (
    Column(
        "lambdify",
        "kernel",
        "lambdify / kernel",
        "lambd",
        "the time of SymPy's lambdify on the textbook form over the kernel's",
    ),
    Column(
        "lambdify",
        "shared",
        "lambdify / threads",
        None,
        "lambdify's over that of the kernel where threads share the blocks",
    ),
    Column(
        "lambdify",
        "fresh",
        "lambdify / fresh",
        "fresh",
        "lambdify's where the kernel makes new output arrays too, as lambdify does; one thread",
    ),
    Column(
        "numexpr", "kernel", "numexpr / kernel", None, "numexpr's over the kernel's, one thread"
    ),
    Column("Numba", "kernel", "Numba / kernel", None, "a loop compiled by Numba over the kernel's"),
    Column(
        "JAX",
        "kernel",
        "JAX / kernel",
        None,
        "JAX's, compiled, with its threads, over the kernel's",
    ),
    Column(
        "SciPy",
        "kernel",
        "SciPy / kernel",
        "SciPy",
        "the time of SciPy's Riccati solver, a call a point, over the kernel's",
    ),
)
RATIOS = (*KERNEL_OVER, *OVER_KERNEL)
ERRORS = (
    (
        "worst",
        "worst",
        (
            "greatest error met at random points, in units of 2^-52 of its scale: of the output "
            "itself unless its docstring says of what"
        ),
    ),
    ("proved", "proved", "the proved bound of that output in the same unit"),
)


def explained() -> list[tuple[str, str]]:
    """The headings in a terminal with their meanings."""
    ratios = [(each.short, each.meaning) for each in RATIOS if each.short is not None]
    return [*ratios, *((short, meaning) for _, short, meaning in ERRORS)]


def worst_output(row: Row) -> Mapping[str, Any]:
    """The output that is shown: of those outside their bounds, else of all, the one with the
    greatest error.
    """
    errors = row["errors"]
    outside = [each for each in errors if each["outside"]]
    found: Mapping[str, Any] = max(outside or errors, key=lambda each: float(each["worst"]))
    return found


def ratio_text(value: float | None) -> str:
    """Three figures and a few more of large ones; thousands as k from ten thousand on, and M."""
    if value is None:
        return "-"
    if value >= 999_500:
        return f"{value / 1e6:.1f}M"
    if value >= 10_000:
        return f"{value / 1000:,.0f}k"
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"
