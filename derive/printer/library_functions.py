"""Functions of NumPy's library in kernels: their names, and what is assumed of their errors.

No standard bounds them. NumPy's own loops promise at most 4 units in the last place (its universal
intrinsics and the vector library that it ships on x86); those of C libraries that it calls
elsewhere do better on the systems that are known (glibc lists 1 or 2). So `ULP` is an assumption:
a bound that rests on it says so, and a test samples it.
"""

from __future__ import annotations

from collections.abc import Iterable

import flint

from gainproof.derive.printer.program import FUNCTIONS, Program

ULP = 4  # units in the last place of the true result

NUMPY = {
    "sin": "sin",
    "cos": "cos",
    "atan2": "arctan2",
    "hypot": "hypot",
    "exp": "exp",
    "expm1": "expm1",
    "log1p": "log1p",
}
"""The functions of NumPy."""


def ball(name: str, parts: list[flint.arb]) -> flint.arb:
    """The true value of a function over balls."""
    first = parts[0]
    match name:
        case "sin":
            return first.sin()
        case "cos":
            return first.cos()
        case "exp":
            return first.exp()
        case "expm1":
            return first.expm1()
        case "log1p":
            return first.log1p()
        case "atan2":
            return flint.arb.atan2(first, parts[1])
        case "hypot":
            return (first * first + parts[1] * parts[1]).sqrt()
    raise ValueError(f"unknown function {name}")


def functions_of(program: Program, ends: Iterable[int]) -> list[str]:
    """The functions, by NumPy's names in order, that steps are computed with."""
    wanted = set(ends)
    for number in range(max(wanted, default=-1), -1, -1):
        if number in wanted:
            wanted.update(program.steps[number].operands)
    used = {program.steps[number].operation for number in wanted}
    return [NUMPY[name] for name in FUNCTIONS if name in used]
