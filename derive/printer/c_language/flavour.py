"""The two real types of C, and numbers and names as its texts."""

from __future__ import annotations

import re
from dataclasses import dataclass

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format
from gainproof.derive.printer.kernel import Kernel

KEYWORDS = frozenset(
    (
        *("auto", "break", "case", "char", "const", "continue", "default", "do", "double"),
        *("else", "enum", "extern", "float", "for", "goto", "if", "inline", "int", "long"),
        *("register", "restrict", "return", "short", "signed", "sizeof", "static", "struct"),
        *("switch", "typedef", "union", "unsigned", "void", "volatile", "while"),
        *("class", "delete", "new", "private", "public", "template", "this", "operator"),
        *("n", "i", "first", "fine", "values", "code"),
    )
)
"""What an argument is not called: words of C and C++, and those of the functions printed."""


@dataclass(frozen=True)
class Flavour:
    """A format with its type, the ending of our functions, and that of literals and `math.h`."""

    form: Format
    type: str
    ending: str
    letter: str

    def number(self, value: float) -> str:
        """A number of the format as a literal that is read as just that number."""
        return f"{literal(value)}{self.letter}"


DOUBLE = Flavour(FLOAT64, "double", "", "")
SINGLE = Flavour(FLOAT32, "float", "_float", "f")
FLAVOURS = (DOUBLE, SINGLE)


def argument(name: str) -> str:
    """The name of an input or output in C."""
    taken = name in KEYWORDS or re.fullmatch(r"t\d+", name)
    return f"{name}_" if taken else name


def arguments(kernel: Kernel) -> tuple[list[str], list[str]]:
    """Names of inputs and outputs, no two alike."""
    inputs = [argument(given.name) for given in kernel.inputs]
    outputs = [argument(output.name) for output in kernel.outputs]
    return inputs, [f"{name}_out" if name in inputs else name for name in outputs]
