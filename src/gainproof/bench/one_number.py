"""A kernel called with one number after another, as a tracker's loop does, beside the plain Python
formula of its graph: functions of `math`, no guards, no names of results, no other types.
"""

from __future__ import annotations

import importlib.util
from collections import deque
from collections.abc import Callable, Sequence
from itertools import starmap
from pathlib import Path
from typing import Any

from gainproof.bench.compiler import Arrays
from gainproof.bench.subjects import Measured
from gainproof.bench.timing import best_times
from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.emitter import body, named, unlike
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.one_number import TAKEN, Python

POINTS = 1000
IN_MATH = ("sqrt", "cbrt", "sin", "cos", "atan2", "hypot", "exp", "expm1", "log1p")


class _Formula(Python):
    """As a person writes it, for float64 alone."""

    def constant(self, value: Callable[[Format], float]) -> str:
        return literal(value(FLOAT64))

    def call(self, name: str, parts: Sequence[str]) -> str:
        return super().call(name, parts).removeprefix("form.").replace("near_cbrt(", "cbrt(")

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        return f"{yes} if {less} < {more} else {no}"


def formula_source(kernel: Kernel) -> str:
    """A module of Python with the function `formula`, from floats to a tuple of floats."""
    given = [each.name for each in kernel.inputs]
    names = dict(zip(given, unlike(given, {*TAKEN, *IN_MATH}), strict=True))
    made = body(kernel, _Formula(), named(names))
    lines = [
        f"from math import {', '.join(IN_MATH)}",
        "",
        f"def formula({', '.join(names.values())}):",
        *(f"    {line}" for line in made.lines),
        f"    return ({', '.join(made.outputs)},)",
    ]
    return "\n".join(lines) + "\n"


def formula(kernel: Kernel, folder: Path) -> Callable[..., tuple[float, ...]]:
    """That function; the module is written to the folder."""
    source = folder / f"formula_{kernel.name}.py"
    source.parent.mkdir(parents=True, exist_ok=True)
    source.write_text(formula_source(kernel), encoding="utf-8")
    specification = importlib.util.spec_from_file_location(source.stem, source)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    found: Callable[..., tuple[float, ...]] = module.formula
    return found


def seconds_of_numbers(item: Measured, columns: Arrays, folder: Path) -> dict[str, float]:
    """Seconds of a call with Python floats: of the kernel, and of the formula."""
    points = list(zip(*(column[:POINTS].tolist() for column in columns), strict=True))

    def calling(function: Callable[..., Any]) -> Callable[[], object]:
        return lambda: deque(starmap(function, points), maxlen=0)

    calls = {
        "one number": calling(item.function),
        "formula": calling(formula(item.kernel, folder / item.subject)),
    }
    return {name: taken / len(points) for name, taken in best_times(calls).items()}
