"""Names of a user's kernels that cannot stand beside each other in a printed module."""

from __future__ import annotations

import keyword
from collections.abc import Iterator, Sequence

from gainproof.derive.own_expressions.expressions import ExpressionError

CLASSES = frozenset(
    (
        *("Any", "Array", "ArrayLike", "Arrays", "Block", "Call", "Domain", "Literal"),
        *("NamedTuple", "Real", "Required", "Sequence", "Signature"),
    )
)
"""What a printed module has for something else."""
ENTRIES = ("", "_values", "_of", "_fine", "_code", "_array", "_refuses")
TYPES = ("", "_float")
"""Endings of the functions of a kernel in C."""


def result_class(kernel: str) -> str:
    """The class of a kernel's result, after its name."""
    return "".join(word.capitalize() for word in kernel.split("_"))


def require_side_by_side(kernels: Sequence[str]) -> None:
    """ExpressionError for a kernel whose class is named as something else is, and for two of which
    the classes in Python, or the functions in C, have one name.
    """
    taken: dict[str, str] = {}
    for kernel in kernels:
        result = result_class(kernel)
        if result in CLASSES or keyword.iskeyword(result):
            raise ExpressionError(
                f"a kernel cannot be called {kernel}: {result}, the class of its result, is "
                "something else in a module"
            )
        for what, name in _names(kernel, result):
            if name in taken:
                raise ExpressionError(
                    f"kernels {taken[name]} and {kernel} both have the {what} {name}; wanted: "
                    "another name for one of them"
                )
        taken |= {name: kernel for _, name in _names(kernel, result)}


def _names(kernel: str, result: str) -> Iterator[tuple[str, str]]:
    yield "class", result
    for entry in ENTRIES:
        for kind in TYPES:
            yield "C function", f"{kernel}{entry}{kind}"
