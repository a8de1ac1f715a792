"""The subtractions of computed values that are left in the kernels, as their docstrings say.

What a docstring says is printed from the kernel's graph: the printer refuses any other subtraction
but those of exact numbers, which cost one rounding.
"""

from __future__ import annotations

import pkgutil
import re
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from inspect import cleandoc, isfunction

from gainproof import generated
from gainproof.terminal_text import WIDTH, filled

_NAMED = re.compile(r"Cancellation, condition number ([\d.e+]+): (.*?)(?:\.(?= |$))")
_TERMS = "Error over the sum of its terms taken positive"
_LOST = re.compile(r"(\w+): .*Digits that can be lost: (.*)\.")


LOST = (
    "Digits that can be lost, proved for every input: of float64's 16 and float32's 7 decimal "
    "digits, by each output whose error is bounded over something larger than its value."
)


@dataclass(frozen=True)
class Left:
    """What is left in one function: (output, condition number, reason), and outputs of terms.

    The condition number is by how much errors of the difference's two sides, each relative to their
    sum, enter an output over its scale. `by_terms`: outputs whose terms may have either sign.
    `losses`: each output whose error is relative to something larger, with the digits that it can
    lose.
    """

    name: str
    differences: tuple[tuple[str, str, str], ...]
    by_terms: int
    losses: tuple[tuple[str, str], ...]


def left() -> Iterator[Left]:
    """Of every kernel, in order."""
    for found in pkgutil.iter_modules(generated.__path__):
        if found.name.startswith("_"):
            continue
        module = import_module(f"{generated.__name__}.{found.name}")
        for name in module.__all__:
            function = getattr(module, name)
            if isfunction(function):
                outputs = list(_paragraphs(function.__doc__ or ""))
                named = [
                    (text.partition(":")[0], *each)
                    for text in outputs
                    for each in _NAMED.findall(text)
                ]
                losses = [(each[1], each[2]) for each in map(_LOST.fullmatch, outputs) if each]
                terms = sum(_TERMS in text for text in outputs)
                yield Left(f"{found.name}.{name}", tuple(named), terms, tuple(losses))


def _paragraphs(text: str) -> Iterator[str]:
    """Inputs and outputs with what is said of them: lines but the first are indented."""
    paragraph = ""
    for line in [*cleandoc(text).splitlines(), ""]:
        if line.startswith("    ") and paragraph:
            paragraph += " " + line.strip()
            continue
        yield paragraph
        paragraph = line


def page(columns: int = WIDTH) -> str:
    """The kernels with subtractions and their reasons, in lines of at most `columns`."""
    kernels = list(left())
    named = [kernel for kernel in kernels if kernel.differences]
    signed = [kernel for kernel in kernels if kernel.by_terms]
    free = sum(not kernel.differences and not kernel.by_terms for kernel in kernels)
    count = sum(len(kernel.differences) for kernel in named)
    terms = sum(kernel.by_terms for kernel in signed)
    lines = [
        *filled(
            f"{len(kernels)} kernels. {free} subtract no computed values. {len(named)} hold "
            f"{count} differences that vanish inside the domain or nearly so: their errors are "
            "bounded over the sum of both sides, and so are the condition numbers below. "
            f"{len(signed)} take inputs of either sign and have {terms} outputs whose errors are "
            "bounded over the sum of their terms.",
            columns=columns,
        )
    ]
    for kernel in named:
        lines += ["", kernel.name]
        for difference, condition, reason in kernel.differences:
            text = f"{difference}, condition number {condition}: {reason}"
            lines += filled(text, "  ", "      ", columns=columns)
    lines += ["", *filled(LOST, columns=columns)]
    for kernel in kernels:
        lines += ["", kernel.name] if kernel.losses else []
        for output, text in kernel.losses:
            lines += filled(f"{output}: {text}", "  ", "      ", columns=columns)
    return "\n".join(lines) + "\n"
